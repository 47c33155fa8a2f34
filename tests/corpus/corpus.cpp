// Takes a folder of CAD files through info, the first recipe with its exports, and an independent check of what was written;
// makes a table and a page. One file after the other, the run on one core.

#include "corpus/check.h"
#include "corpus/page.h"
#include "corpus/shapes.h"
#include "support/export_summary.h"

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QProcess>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>

namespace {

using Json = nlohmann::ordered_json;

constexpr int longestRun = 600'000; // [ms]
constexpr double leastMove = 0.03;  // of the size
constexpr double mostMove = 0.3;
constexpr double longestGoodRun = 60; // [s]

struct Ended {
    bool isGood = false;
    double seconds = 0;
    std::string out;
    std::string errors;
};

Ended run(const QString& program, const QStringList& arguments)
{
    QElapsedTimer timer;
    timer.start();
    QProcess process;
    process.start(program, arguments);
    const bool isDone = process.waitForFinished(longestRun);
    if (!isDone)
        process.kill();
    process.waitForFinished();
    return {isDone && process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0,
            1e-3 * static_cast<double>(timer.elapsed()), process.readAllStandardOutput().toStdString(),
            process.readAllStandardError().toStdString()};
}

/// On one core, as it is measured.
Ended runOnOneCore(QStringList arguments)
{
    arguments.prepend(KNEAD_PROGRAM);
    return run("taskset", QStringList{"-c", "0"} + arguments);
}

std::string firstLine(const std::string& text)
{
    return text.substr(0, text.find('\n'));
}

Json fault(Json file, const char* verdict, const std::string& said)
{
    file["verdict"] = verdict;
    file["said"] = firstLine(said);
    return file;
}

void addInfo(const Json& info, Json& file)
{
    file["parts"] = info.at("parts").size();
    file["closed"] = std::count_if(info.at("parts").begin(), info.at("parts").end(), [](const Json& part) {
        return part.at("watertight").get<bool>() && part.at("solids").get<int>() > 0;
    });
}

void addCheck(const Json& check, double volume, Json& file)
{
    if (check.contains("error")) {
        file["check_valid"] = check.at("error");
        return;
    }
    file["check_valid"] = check.at("valid");
    file["check_free_edges"] = check.at("free_edges");
    file["check_volume_error"] = volume > 0 ? check.at("volume_mm3").get<double>() / volume - 1 : 0;
    file["check_tolerance_mm"] = check.at("largest_tolerance_mm");
    for (const char* key : {"stl_to_step_mm", "step_to_stl_mm"})
        if (check.contains(key))
            file[key] = check.at(key);
}

double volumeOf(const Json& report)
{
    double volume = 0; // [mm^3]
    for (const Json& part : report.at("parts"))
        volume += 1e9 * part.at("volume_m3").at("file").get<double>();
    return volume;
}

/// @param self this program, which checks in a process of its own: libraries crash
Json takeThrough(const QString& self, const QFileInfo& cad, const QString& folder)
{
    Json file{{"file", cad.completeBaseName().toStdString()}};
    QDir(folder).removeRecursively();
    QDir().mkpath(folder);
    const Ended info = run(KNEAD_PROGRAM, {"info", "--json", cad.filePath()});
    file["info_s"] = info.seconds;
    if (!info.isGood)
        return fault(file, "not read", info.errors);
    addInfo(Json::parse(info.out), file);
    run(KNEAD_PROGRAM, {"convert", cad.filePath(), folder + "/before.png"});
    const QString recipe = folder + "/first.recipe.json";
    if (const Ended made = run(KNEAD_PROGRAM, {"recipe", cad.filePath(), "--output", recipe}); !made.isGood)
        return fault(file, "no recipe", made.errors);
    const Ended pressed = runOnOneCore({"run", recipe, "--out", folder, "--json"});
    file["run_s"] = pressed.seconds;
    if (!pressed.isGood)
        return fault(file, "run failed", pressed.errors);
    const Json report = Json::parse(pressed.out);
    const QString name = cad.completeBaseName();
    QFile::rename(folder + "/" + name + "-pressed.png", folder + "/after.png");
    const Json& exported = report.at("exports")[0];
    file.update(knead::exportSummary(exported));
    const Ended checked =
        run(self, {"--check", folder + "/" + name + "-pressed.step", folder + "/" + name + "-pressed.stl"});
    const Json check = checked.isGood ? Json::parse(checked.out) : Json{{"error", "the check crashed"}};
    addCheck(check, volumeOf(exported), file);
    double moved = 0;
    for (const Json& body : report.at("bodies"))
        moved = std::max(moved, body.at("largest_displacement_mm").get<double>());
    const double share = check.contains("size_mm") ? moved / check.at("size_mm").get<double>() : 0;
    file["moved_share"] = share;

    const bool isSound = file.at("sound") == file.at("bodies");
    const bool passes = check.value("valid", false) && check.value("free_edges", 1) == 0 &&
                        std::abs(file.value("check_volume_error", 1.0)) < 1e-3;
    file["verdict"] = isSound && !passes                       ? "said to be sound, is not"
                      : file.at("smooth") != file.at("bodies") ? "flat faces"
                      : !isSound                               ? "not sound"
                      : share < leastMove || share > mostMove  ? "moves too little or too much"
                      : pressed.seconds > longestGoodRun       ? "slow"
                                                               : "good";
    return file;
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() == 4 && arguments[1] == "--check") {
        std::cout << knead::corpus::checkFiles(arguments[2].toStdString(), arguments[3].toStdString()).dump() << '\n';
        return 0;
    }
    if (arguments.size() == 3 && arguments[1] == "--shapes") {
        QDir().mkpath(arguments[2]);
        std::cout << knead::corpus::writeShapes(arguments[2].toStdString()) << " shapes\n";
        return 0;
    }
    if (arguments.size() != 3 || !QDir(arguments[1]).exists()) {
        std::cerr << "knead_corpus FOLDER OUT: FOLDER holds CAD files\nknead_corpus --shapes FOLDER: makes some\n";
        return 2;
    }
    std::vector<Json> files;
    const QDir out(arguments[2]);
    for (const QFileInfo& cad :
         QDir(arguments[1]).entryInfoList({"*.st*p", "*.igs", "*.iges", "*.br*p"}, QDir::Files, QDir::Name)) {
        files.push_back(
            takeThrough(QCoreApplication::applicationFilePath(), cad, out.filePath(cad.completeBaseName())));
        std::cout << files.back().at("file").get<std::string>() << ": " << files.back().at("verdict").get<std::string>()
                  << std::endl;
        std::ofstream(out.filePath("table.tsv").toStdString()) << knead::corpus::tableOf(files);
        std::ofstream(out.filePath("index.html").toStdString()) << knead::corpus::pageOf(files);
    }
    const auto good =
        std::count_if(files.begin(), files.end(), [](const Json& file) { return file.at("verdict") == "good"; });
    std::cout << good << " of " << files.size() << " files are good; see " << out.filePath("index.html").toStdString()
              << '\n';
    return 0;
}
