#include "app/commands/info_command.h"

#include "app/cad_process.h"
#include "app/commands/carry_out.h"
#include "app/commands/command_output.h"
#include "app/exit_status.h"
#include "app/import_arguments.h"
#include "core/geometry/wall_thickness.h"
#include "core/message/message.h"
#include "core/model/file_formats.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace knead {

namespace {

using Json = nlohmann::ordered_json;

constexpr double toMm = 1e3;
constexpr double toMm2 = 1e6;
constexpr double toMm3 = 1e9;

struct InfoOptions {
    std::string file;
    bool json = false;
    ImportOptions import;
};

std::string hexColor(const Color& color)
{
    const auto byte = [](float channel) { return static_cast<unsigned>(std::lround(255 * channel)) & 0xFFU; };
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(color.r), byte(color.g), byte(color.b));
    return text.data();
}

Json toJson(const Box& box)
{
    Json numbers = Json::array();
    for (const Vec3& corner : {box.min(), box.max()})
        for (const double coordinate : corner)
            numbers.push_back(toMm * coordinate);
    return numbers;
}

std::vector<std::string> englishOf(const std::vector<Message>& sentences)
{
    std::vector<std::string> english;
    for (const Message& sentence : sentences)
        english.push_back(sentence.english());
    return english;
}

Json toJson(const Part& part)
{
    Json named = Json::array();
    for (std::size_t f = 0; f < part.faces.size(); ++f)
        if (!part.faces[f].name.empty())
            named.push_back({{"face", f}, {"name", part.faces[f].name}});
    return {{"name", part.name},
            {"path", part.path},
            {"color", part.color ? Json(hexColor(*part.color)) : Json(nullptr)},
            {"solids", part.solids},
            {"shells", part.shells},
            {"faces", part.faces.size()},
            {"named_faces", named},
            {"edges", part.edges},
            {"triangles", part.mesh.triangles.size()},
            {"volume_mm3", toMm3 * part.volume},
            {"area_mm2", toMm2 * part.area},
            {"bbox_mm", toJson(part.box)},
            {"thinnest_wall_mm", part.canBeFilled() ? Json(toMm * wallThickness(part.mesh).thinnest) : Json(nullptr)},
            {"watertight", part.watertight},
            {"valid", part.valid},
            {"max_tolerance_mm", toMm * part.maxTolerance},
            {"hidden", !part.visible},
            {"layer", part.layer},
            {"open_edges", part.openEdges.size()},
            {"repairs", englishOf(part.repairs)},
            {"warnings", englishOf(part.warnings)}};
}

void printJson(const Model& model)
{
    Json json{{"file", model.file},
              {"format", model.format},
              {"unit", model.unit},
              {"unit_remark", nullptr},
              {"warnings", englishOf(model.warnings)},
              {"missing", englishOf(model.missing)},
              {"parts", Json::array()}};
    if (model.unitRemark)
        json["unit_remark"] = {{"sentence", model.unitRemark->sentence.english()}, {"unit", model.unitRemark->unit}};
    for (const Part& part : model.parts)
        json["parts"].push_back(toJson(part));
    printAsJson(json);
}

std::string plural(std::size_t count, const char* noun)
{
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::map<std::string, std::vector<std::size_t>> namedFaces(const Part& part)
{
    std::map<std::string, std::vector<std::size_t>> named;
    for (std::size_t f = 0; f < part.faces.size(); ++f)
        if (!part.faces[f].name.empty())
            named[part.faces[f].name].push_back(f);
    return named;
}

std::string listed(const std::vector<std::size_t>& numbers)
{
    std::string text;
    for (const std::size_t number : numbers)
        text += (text.empty() ? "" : ", ") + std::to_string(number);
    return text;
}

void printPart(const Part& part, int depth)
{
    const int indent = 2 * depth;
    const Vec3 size = part.box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(toMm * part.box.sizes());
    std::printf("%*s  %.5g x %.5g x %.5g mm", indent, "", size.x(), size.y(), size.z());
    if (part.volume > 0)
        std::printf(", volume %.6g mm3", toMm3 * part.volume);
    std::printf(", area %.6g mm2", toMm2 * part.area);
    if (part.canBeFilled())
        std::printf(", thinnest wall %.3g mm", toMm * wallThickness(part.mesh).thinnest);
    if (part.color)
        std::printf(", color %s", hexColor(*part.color).c_str());
    std::printf("\n%*s  ", indent, "");
    if (!part.faces.empty())
        std::printf("%s, %s, ", plural(part.faces.size(), "face").c_str(),
                    plural(static_cast<std::size_t>(part.edges), "edge").c_str());
    std::printf("%s; %s%s", plural(part.mesh.triangles.size(), "triangle").c_str(),
                part.watertight ? "closed" : "not closed", part.visible ? "" : ", hidden");
    if (!part.layer.empty())
        std::printf(", layer %s", part.layer.c_str());
    std::printf("\n");
    for (const auto& [name, faces] : namedFaces(part))
        std::printf("%*s  faces \"%s\": %s\n", indent, "", name.c_str(),
                    faces.size() == part.faces.size() ? "all" : listed(faces).c_str());
    for (const Message& repair : part.repairs)
        std::printf("%*s  repaired: %s\n", indent, "", repair.english().c_str());
    for (const Message& warning : part.warnings)
        std::printf("%*s  warning: %s\n", indent, "", warning.english().c_str());
}

void printNode(const PartNode& node, const Model& model, int depth)
{
    std::printf("%*s%s\n", 2 * depth, "", node.name.c_str());
    if (node.part)
        printPart(model.parts[*node.part], depth);
    for (const PartNode& child : node.children)
        printNode(child, model, depth + 1);
}

void printTree(const Model& model)
{
    double volume = 0;
    std::size_t closed = 0;
    for (const Part& part : model.parts) {
        volume += part.volume;
        closed += part.watertight ? 1 : 0;
    }
    std::printf("%s: %s, unit %s, %s (%zu closed), volume %.6g mm3\n", model.file.c_str(), model.format.c_str(),
                model.unit.empty() ? "not stated" : model.unit.c_str(), plural(model.parts.size(), "part").c_str(),
                closed, toMm3 * volume);
    for (const Message& warning : model.warnings)
        std::printf("warning: %s\n", warning.english().c_str());
    if (model.unitRemark)
        std::printf("remark: %s Take it so with --unit %s.\n", model.unitRemark->sentence.english().c_str(),
                    model.unitRemark->unit.c_str());
    for (const Message& sentence : model.missing)
        std::printf("missing: %s\n", sentence.english().c_str());
    for (const PartNode& child : model.tree.children)
        printNode(child, model, 1);
}

int info(const InfoOptions& options)
{
    return carryOut([&](TerminalControl& control, int&) {
        const Model model = importInChild(options.file, options.import, control);
        control.clear();
        options.json ? printJson(model) : printTree(model);
        return exit_status::done;
    });
}

} // namespace

void addInfoCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command = program.add_subcommand("info", "Say what a CAD or mesh file holds");
    command->add_option("FILE", options->file, formatNames(" or ") + " file")->required();
    command->add_flag("--json", options->json, "Print it as JSON");
    addImportArguments(*command, options->import);
    command->callback([options, &exitStatus] { exitStatus = info(*options); });
}

} // namespace knead
