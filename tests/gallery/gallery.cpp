#include "gallery/gallery.h"

#include "support/export_summary.h"
#include "support/html.h"

#include <QDir>
#include <QProcess>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace knead::gallery {

namespace {

using Json = nlohmann::ordered_json;

constexpr int longestRun = 600'000; // [ms]

Json fromFile(const QString& path)
{
    std::ifstream file(path.toStdString());
    if (!file)
        throw std::runtime_error(path.toStdString() + " cannot be read.");
    return Json::parse(file);
}

struct Ended {
    bool isGood = false;
    std::string out;
    std::string errors;
};

Ended run(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.start(program, arguments);
    const bool isDone = process.waitForFinished(longestRun);
    if (!isDone)
        process.kill();
    process.waitForFinished();
    return {isDone && process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0,
            process.readAllStandardOutput().toStdString(), process.readAllStandardError().toStdString()};
}

/// The first export whose file has an ending.
Json exportOf(const Json& recipe, const std::string& ending)
{
    for (const Json& wanted : recipe.at("exports")) {
        const std::string file = wanted.at("file").get<std::string>();
        if (file.size() > ending.size() && file.substr(file.size() - ending.size()) == ending)
            return wanted;
    }
    throw std::runtime_error("a recipe of the gallery has no export " + ending);
}

std::string rounded(double number, const char* format)
{
    char text[32];
    std::snprintf(text, sizeof text, format, number);
    return text;
}

std::string picture(const Json& piece, const char* which)
{
    return std::string("<figure><img loading='lazy' alt='") + which + "' src='" +
           escaped(piece.at(which).get<std::string>()) + "'><figcaption>" + which + "</figcaption></figure>";
}

std::string cell(const std::string& text)
{
    return "<td>" + text + "</td>";
}

std::string rowOf(const Json& piece)
{
    const std::string title = escaped(piece.at("title").get<std::string>());
    if (piece.contains("fault"))
        return "<tr class='fault'>" + cell(title) + "<td colspan='8'>" + escaped(piece.at("fault").get<std::string>()) +
               "</td></tr>\n";
    const std::string step = escaped(piece.at("step").get<std::string>());
    const auto of = [&](const char* key) {
        return std::to_string(piece.at(key).get<int>()) + " of " + std::to_string(piece.at("bodies").get<int>());
    };
    return std::string("<tr") + (isGood(piece) ? ">" : " class='fault'>") + cell(title) +
           cell(std::to_string(piece.at("objects").get<int>())) +
           cell(std::to_string(piece.at("faces_before").get<int>()) + " &rarr; " +
                std::to_string(piece.at("faces_after").get<int>())) +
           cell(of("smooth")) + cell(of("sound")) +
           cell(rounded(100 * piece.at("volume_error").get<double>(), "%+.4f %%")) +
           cell(rounded(piece.at("off_mm").get<double>(), "%.4f mm")) +
           cell(rounded(piece.at("run_s").get<double>(), "%.1f s")) +
           cell("<a href='" + step + "'>STEP</a> " + escaped(piece.at("said").get<std::string>())) + "</tr>\n";
}

} // namespace

std::vector<Piece> read(const QString& folder)
{
    std::vector<Piece> pieces;
    for (const Json& entry : fromFile(folder + "/gallery.json"))
        pieces.push_back({entry.at("recipe").get<std::string>(), entry.at("title").get<std::string>(),
                          entry.at("line").get<std::string>()});
    return pieces;
}

Json carryOut(const QString& program, const Piece& piece, const QString& folder, const QString& out, double coarser)
{
    const QString name = QString::fromStdString(piece.name);
    const QString path = folder + "/" + name + ".recipe.json";
    const Json recipe = fromFile(path);
    const Json step = exportOf(recipe, ".step");
    const Json after = exportOf(recipe, ".png");
    Json result{{"name", piece.name},
                {"title", piece.title},
                {"line", piece.line},
                {"step", piece.name + "/" + step.at("file").get<std::string>()},
                {"after", piece.name + "/" + after.at("file").get<std::string>()},
                {"before", piece.name + "/before.png"}};
    const QString spacing = "spacing_mm=" + QString::number(coarser * recipe.at("spacing_mm").get<double>());
    const QStringList common{"run", path, "--out", out + "/" + name, "--threads", "1", "--json", "--set", spacing};

    Json before = after;
    before["file"] = "before.png";
    before["show_tools"] = true;
    const Ended start =
        run(program, common + QStringList{"--set", "duration_s=null", "--set", "duration_steps=1", "--set",
                                          "exports=" + QString::fromStdString(Json{before}.dump())});
    const Ended end = run(program, common);
    if (!start.isGood || !end.isGood) {
        result["fault"] = (start.isGood ? end : start).errors;
        return result;
    }
    const Json report = Json::parse(end.out);
    result["objects"] = report.at("objects");
    result["run_s"] = report.at("wall_s");
    result.update(exportSummary(report.at("exports").at(0)));
    return result;
}

bool isGood(const Json& piece)
{
    return !piece.contains("fault") && piece.at("bodies").get<int>() > 0 && piece.at("smooth") == piece.at("bodies") &&
           piece.at("sound") == piece.at("bodies") && piece.at("said").get<std::string>().empty();
}

std::string pageOf(const std::vector<Json>& pieces)
{
    std::string page =
        "<!DOCTYPE html><html lang='en'><head><meta charset='utf-8'><title>Knead: gallery</title><style>"
        "body{font:15px sans-serif;margin:32px auto;max-width:1400px;padding:0 16px}"
        ".pair{display:grid;grid-template-columns:1fr 1fr;gap:12px}figure{margin:0}img{width:100%;border-radius:6px}"
        "figcaption{color:#667}table{border-collapse:collapse}td,th{border-bottom:1px solid #ccc;padding:4px 10px;"
        "text-align:left;vertical-align:top}.fault td{background:#fee}</style></head><body><h1>Gallery</h1>"
        "<p>Parts sculpted by recipes: pushed, bent and cut as lumps of material, and written as STEP with smooth "
        "faces.</p>\n";
    for (const Json& piece : pieces) {
        page += "<section id='" + escaped(piece.at("name").get<std::string>()) + "'><h2>" +
                escaped(piece.at("title").get<std::string>()) + "</h2><p>" +
                escaped(piece.at("line").get<std::string>()) + "</p>";
        if (!piece.contains("fault"))
            page += "<div class='pair'>" + picture(piece, "before") + picture(piece, "after") + "</div>";
        page += "</section>\n";
    }
    page += "<h2>Facts</h2><table><tr><th>part</th><th>objects</th><th>faces</th><th>smooth bodies</th><th>sound "
            "bodies</th>"
            "<th>volume, file to skin</th><th>file off the skin by</th><th>time, one thread</th><th>file</th></tr>\n";
    for (const Json& piece : pieces)
        page += rowOf(piece);
    return page + "</table></body></html>\n";
}

} // namespace knead::gallery
