#include "app/commands/measure_command.h"

#include "app/commands/carry_out.h"
#include "app/commands/command_output.h"
#include "app/exit_status.h"
#include "app/import_arguments.h"
#include "app/opened_shape.h"
#include "core/session/measurement.h"
#include "core/session/measurement_text.h"
#include "ui/units.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

namespace {

using Json = nlohmann::ordered_json;

struct MeasureOptions {
    std::string file;
    std::optional<std::uint32_t> entry;
    std::vector<std::string> what;
    bool json = false;
    ImportOptions import;
};

/// What was measured, under a name.
struct Row {
    std::string name;
    Measurement measurement;
    Measured measured;
};

std::vector<Row> measureAll(const MeasureOptions& options, const OpenedShape& shape)
{
    std::vector<Row> rows;
    const auto add = [&](std::string name, const Measurement& measurement) {
        rows.push_back(
            {std::move(name), measurement, measured(measurement, shape.content, *shape.frame, *shape.frame->snapshot)});
    };
    for (BodyId body = 0; body < shape.content.bodies.size(); ++body)
        for (const MeasureKind kind : {MeasureKind::box, MeasureKind::mass})
            add(shape.content.bodies[body]->name, {.kind = kind, .places = {{.body = body}}});
    for (const std::string& text : options.what)
        add(text, measurementOf(text, shape.content));
    return rows;
}

/// A file has no material, and so no mass.
bool isKnown(const Reading& reading, const OpenedShape& shape)
{
    return reading.quantity != Quantity::Mass || shape.entry.has_value();
}

const char* doubtOn(Doubt doubt)
{
    switch (doubt) {
    case Doubt::none:
        break;
    case Doubt::notFlat:
        return "The face is not flat: this far it is from its mean plane at most";
    case Doubt::notRound:
        return "The face is not quite round: this far it is from this radius at most";
    case Doubt::onALine:
        return "The three places lie on a line";
    case Doubt::flat:
        return "The face is flat and has no radius";
    }
    return "";
}

void print(const std::vector<Row>& rows, const OpenedShape& shape)
{
    if (shape.entry)
        std::printf("entry %u, at %.3f s\n", *shape.entry, shape.frame->snapshot->time);
    const std::string* last = nullptr;
    for (const Row& row : rows) {
        if (last == nullptr || *last != row.name)
            std::printf("%s\n", row.name.c_str());
        last = &row.name;
        for (const Reading& reading : row.measured.readings) {
            if (!isKnown(reading, shape))
                continue;
            const auto shown = [&](double value) { return formatQuantity(value, reading.quantity).toStdString(); };
            std::printf("  %-18s %s", reading.name.english().c_str(), shown(reading.now).c_str());
            if (shape.entry)
                std::printf("  (%s at rest)", shown(reading.rest).c_str());
            std::printf("\n");
        }
        if (row.measured.doubt != Doubt::none)
            std::printf("  %s%s.\n", doubtOn(row.measured.doubt),
                        row.measured.deviation > 0
                            ? (": " + formatReading(row.measured.deviation, Quantity::Length).toStdString()).c_str()
                            : "");
    }
}

void printJson(const std::vector<Row>& rows, const MeasureOptions& options, const OpenedShape& shape)
{
    Json json{{"file", options.file},
              {"entry", shape.entry ? Json(*shape.entry) : Json(nullptr)},
              {"time_s", shape.frame->snapshot->time},
              {"measurements", Json::array()}};
    for (const Row& row : rows) {
        Json readings = Json::array();
        for (const Reading& reading : row.measured.readings) {
            if (!isKnown(reading, shape))
                continue;
            const auto [unit, scale] = plainUnit(reading.quantity);
            readings.push_back({{"name", reading.name.english()},
                                {"unit", unit.toStdString()},
                                {"now", reading.now / scale},
                                {"at_rest", reading.rest / scale}});
        }
        json["measurements"].push_back({{"of", row.name},
                                        {"kind", wordFor(row.measurement.kind)},
                                        {"readings", std::move(readings)},
                                        {"doubt", doubtOn(row.measured.doubt)}});
    }
    printAsJson(json);
}

int measure(const MeasureOptions& options)
{
    return carryOut([&](TerminalControl& control, int&) {
        const OpenedShape shape = openShape(options.file, options.entry, options.import, control);
        const std::vector<Row> rows = measureAll(options, shape);
        control.clear();
        printWarnings(shape.warnings);
        options.json ? printJson(rows, options, shape) : print(rows, shape);
        return exit_status::done;
    });
}

} // namespace

void addMeasureCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<MeasureOptions>();
    CLI::App* command = program.add_subcommand(
        "measure", "Measure the bodies of a file, or of a project as they are at an entry and were at rest");
    command->add_option("FILE", options->file, "CAD or mesh file, or a project saved by the window")->required();
    command
        ->add_option(
            "-m,--measure", options->what,
            "What else: \"distance 0,0,0 100,0,0\", \"face-radius lid:12\"; also point, distance-to-face, angle, "
            "face-angle, radius. A place is the point of the skin at rest nearest to x,y,z in mm; faces are "
            "numbered from 0. May be given several times")
        ->type_name("WHAT")
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--entry", options->entry, "Entry of the history of a project; without it the present one")
        ->type_name("N");
    command->add_flag("--json", options->json, "Print it as JSON");
    addImportArguments(*command, options->import);
    command->callback([options, &exitStatus] { exitStatus = measure(*options); });
}

} // namespace knead
