#include "app/commands/compare_command.h"
#include "core/model/file_formats.h"

#include "app/cad_process.h"
#include "app/commands/carry_out.h"
#include "app/commands/command_output.h"
#include "app/complaint.h"
#include "app/drawn_bodies.h"
#include "app/exit_status.h"
#include "app/import_arguments.h"
#include "app/opened_shape.h"
#include "core/message/message.h"
#include "core/model/file_names.h"
#include "core/session/comparison.h"
#include "io/files/safe_file.h"
#include "io/picture/picture_writer.h"
#include "io/project/project_file.h"
#include "ui/measuring/comparison_report.h"
#include "ui/units.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <QDateTime>
#include <QGuiApplication>
#include <QTemporaryDir>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace knead {

namespace {

using Json = nlohmann::ordered_json;

struct CompareOptions {
    std::string file;
    std::string changed; ///< empty: the file is a project
    std::optional<std::uint32_t> entry;
    std::string report; ///< empty: none
    bool json = false;
    ImportOptions import;
};

/// What is compared, and how it looks now.
struct Compared {
    Comparison comparison;
    std::vector<MeshBody> bodies;
    std::vector<Message> warnings;
};

Compared compareProject(const CompareOptions& options, TaskControl& control)
{
    TaskPortion opening(control, 0, 0.7);
    const OpenedShape shape = openShape(options.file, options.entry, options.import, opening);
    if (!shape.entry)
        throw std::runtime_error(shortName(options.file) +
                                 " is no project. Name a second file that it is compared with, or a project.");
    TaskPortion comparing(control, 0.7, 1);
    return {
        compareWithOriginal(shape.content, *shape.frame, *shape.frame->snapshot, comparing), drawnBodies(shape), {}};
}

Compared compareFiles(const CompareOptions& options, TaskControl& control)
{
    TaskPortion first(control, 0, 0.4);
    const Model original = importInChild(options.file, options.import, first);
    TaskPortion second(control, 0.4, 0.8);
    const Model changed = importInChild(options.changed, options.import, second);
    TaskPortion comparing(control, 0.8, 1);
    Compared compared{compareModels(original, changed, comparing), drawnBodies(changed), {}};
    for (const Model* model : {&original, &changed})
        for (Message& remark : remarksOnImport(*model))
            compared.warnings.push_back(std::move(remark));
    for (const std::string& name : compared.comparison.onlyBefore)
        compared.warnings.push_back(
            Message("Comparison", "\"%1\" of the original belongs to no closed part of the other file.").with(name));
    for (const std::string& name : compared.comparison.onlyNow)
        compared.warnings.push_back(
            Message("Comparison", "\"%1\" belongs to no closed part of the original.").with(name));
    return compared;
}

QImage pictureOf(const std::vector<MeshBody>& bodies)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("compared.png");
    writePicture(path.toStdString(), bodies);
    return QImage(path);
}

/// Fonts and pages need Qt's graphics, which need no display.
void writeReport(const CompareOptions& options, const Compared& compared)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    int count = 1;
    std::array<char, 6> name{"knead"};
    std::array<char*, 2> arguments{name.data(), nullptr};
    const QGuiApplication application(count, arguments.data());
    const std::string& shown = options.changed.empty() ? options.file : options.changed;
    const ComparisonReport report{.part = QString::fromStdString(shortName(shown)),
                                  .original = options.changed.empty() ? QString()
                                                                      : QString::fromStdString(shortName(options.file)),
                                  .when = QDateTime::currentDateTime(),
                                  .comparison = compared.comparison,
                                  .picture = pictureOf(compared.bodies),
                                  .measurements = {}};
    writeFileSafely(options.report, bytesOf(report, QString::fromStdString(options.report)).toStdString());
}

void print(const Comparison& comparison)
{
    const auto length = [](double value) {
        return std::isnan(value) ? std::string("-") : formatReading(value, Quantity::Length).toStdString();
    };
    std::printf("%-20s  %-12s  %-12s  %-12s  volume\n", "part", "farthest", "mean", "moved");
    for (const BodyComparison& body : comparison.bodies) {
        const double change = body.rest.volume != 0 ? 100 * (body.now.volume / body.rest.volume - 1) : 0;
        std::printf("%-20s  %-12s  %-12s  %-12s  %s -> %s (%+.2f %%)\n", body.name.c_str(),
                    length(body.largestDistance).c_str(), length(body.meanDistance).c_str(),
                    length(body.largestDisplacement).c_str(),
                    formatQuantity(body.rest.volume, Quantity::Volume).toStdString().c_str(),
                    formatQuantity(body.now.volume, Quantity::Volume).toStdString().c_str(), change);
    }
}

void printJson(const Comparison& comparison, const CompareOptions& options)
{
    const bool isProject = options.changed.empty();
    Json json{{"original", isProject ? Json(nullptr) : Json(options.file)},
              {"changed", isProject ? options.file : options.changed},
              {"time_s", isProject ? Json(comparison.time) : Json(nullptr)},
              {"only_in_original", comparison.onlyBefore},
              {"only_in_changed", comparison.onlyNow},
              {"bodies", Json::array()}};
    for (const BodyComparison& body : comparison.bodies) {
        const Vec3 far = 1e3 * body.farthest;
        json["bodies"].push_back({{"name", body.name},
                                  {"largest_distance_mm", 1e3 * body.largestDistance},
                                  {"farthest_mm", {far.x(), far.y(), far.z()}},
                                  {"mean_distance_mm", 1e3 * body.meanDistance},
                                  {"largest_displacement_mm", 1e3 * body.largestDisplacement},
                                  {"volume_before_mm3", 1e9 * body.rest.volume},
                                  {"volume_mm3", 1e9 * body.now.volume}});
    }
    printAsJson(json);
}

bool isReport(const std::string& path)
{
    const std::string ending = lowerCaseEnding(path);
    return ending == "html" || ending == "pdf";
}

int compare(const CompareOptions& options)
{
    if (!options.report.empty() && !isReport(options.report))
        return complain(options.report + ": a report ends in .html or .pdf.", exit_status::wrongUse);
    if (!options.changed.empty() && (options.entry || isProjectFile(options.file) || isProjectFile(options.changed)))
        return complain("a project is compared with its own original, and alone has entries; name one project, or two "
                        "CAD or mesh files.",
                        exit_status::wrongUse);
    return carryOut([&](TerminalControl& control, int& failure) {
        const Compared compared =
            options.changed.empty() ? compareProject(options, control) : compareFiles(options, control);
        control.clear();
        printWarnings(compared.warnings);
        options.json ? printJson(compared.comparison, options) : print(compared.comparison);
        failure = exit_status::failed;
        if (!options.report.empty())
            writeReport(options, compared);
        return exit_status::done;
    });
}

} // namespace

void addCompareCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<CompareOptions>();
    CLI::App* command = program.add_subcommand(
        "compare", "Say how far a project is from its original, or the parts of one file from those of another");
    command->add_option("FILE", options->file, "Project saved by the window; or the original, a CAD or mesh file")
        ->required();
    command->add_option("CHANGED", options->changed, "CAD or mesh file that is compared with the original");
    command->add_option("--entry", options->entry, "Entry of the history of the project; without it the present one")
        ->type_name("N");
    command->add_option("--report", options->report, "Write a page with a picture, too: .html or .pdf")
        ->type_name("FILE");
    command->add_flag("--json", options->json, "Print it as JSON");
    addImportArguments(*command, options->import);
    command->callback([options, &exitStatus] { exitStatus = compare(*options); });
}

} // namespace knead
