#include "app/commands/fields_command.h"

#include "app/cad_process.h"
#include "app/commands/carry_out.h"
#include "app/commands/command_output.h"
#include "app/exit_status.h"
#include "app/fields_at_nodes.h"
#include "app/opened_shape.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

namespace {

using Json = nlohmann::ordered_json;

struct FieldsOptions {
    std::string project;
    std::optional<std::uint32_t> entry;
    FieldsRequest request;
    bool json = false;
};

/// A moment of a project, for who looks at its nodes.
struct AskedMoment {
    PreparedProject prepared;
    SnapshotPointer snapshot;
    std::vector<BodyAtNodes> bodies;
};

AskedMoment momentOf(const FieldsOptions& options, TaskControl& control)
{
    AskedMoment moment{.prepared = openEntry(options.project, options.entry, control), .snapshot = {}, .bodies = {}};
    Simulation& simulation = *moment.prepared.destination.simulation;
    simulation.showPressing(true);
    moment.snapshot = simulation.snapshot();
    std::vector<std::size_t> partOfBody;
    for (const auto& body : moment.prepared.destination.content->bodies)
        partOfBody.push_back(body->part);
    moment.bodies = bodiesAtNodes(*moment.prepared.project.model, partOfBody, *moment.snapshot,
                                  moment.prepared.destination.moment.get());
    return moment;
}

void print(const WrittenFields& written, const FieldsOptions& options, const AskedMoment& moment)
{
    std::printf("%s: %zu nodes, entry %u at %.3f s\n", options.request.output.c_str(), written.nodes,
                moment.prepared.project.current, moment.snapshot->time);
    for (std::size_t b = 0; b < moment.bodies.size(); ++b)
        if (written.ofBody[b] > 0)
            std::printf("  %zu of %s\n", written.ofBody[b], moment.bodies[b].name.c_str());
    for (const std::string& name : written.names)
        std::printf("  %s\n", name.c_str());
    std::printf("largest displacement %.4g mm, von Mises stress %.4g MPa\n", 1e3 * written.largestDisplacement,
                1e-6 * written.largestStress);
}

void printJson(const WrittenFields& written, const FieldsOptions& options, const AskedMoment& moment)
{
    Json bodies = Json::array();
    for (std::size_t b = 0; b < moment.bodies.size(); ++b)
        bodies.push_back({{"name", moment.bodies[b].name}, {"nodes", written.ofBody[b]}});
    Json warnings = Json::array();
    for (const Message& warning : written.warnings)
        warnings.push_back(warning.english());
    printAsJson({{"project", options.project},
                 {"entry", moment.prepared.project.current},
                 {"time_s", moment.snapshot->time},
                 {"file", options.request.output},
                 {"fields", written.names},
                 {"nodes", written.nodes},
                 {"nodes_outside", written.outside},
                 {"farthest_outside_mm", 1e3 * written.farthest},
                 {"bodies", std::move(bodies)},
                 {"largest_displacement_mm", 1e3 * written.largestDisplacement},
                 {"largest_von_mises_mpa", 1e-6 * written.largestStress},
                 {"warnings", std::move(warnings)}});
}

int writeAll(const FieldsOptions& options)
{
    return carryOut([&](TerminalControl& control, int& failure) {
        checkFields(options.request);
        TaskPortion reading(control, 0, 0.2);
        const NodalMesh mesh = readNodesInChild(options.request.nodes, options.request.unit, reading);
        TaskPortion going(control, 0.2, 0.5);
        const AskedMoment moment = momentOf(options, going);
        failure = exit_status::failed;
        TaskPortion telling(control, 0.5, 1);
        const WrittenFields written = writeFieldsAtNodes(options.request, mesh, moment.bodies, telling);
        control.clear();
        printWarnings(written.warnings);
        options.json ? printJson(written, options, moment) : print(written, options, moment);
        return exit_status::done;
    });
}

} // namespace

void addFieldsCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<FieldsOptions>();
    CLI::App* command = program.add_subcommand(
        "fields", "Write displacement, strain and stress of a project at the nodes of another program's mesh");
    command->add_option("PROJECT", options->project, "Project saved by the window")->required();
    command->add_option("--entry", options->entry, "Entry of the history; without it the present one")->type_name("N");
    addFieldsArguments(*command, options->request, "--unit", "--output");
    command->get_option("--nodes")->required();
    command->get_option("--output")->required();
    command->add_flag("--json", options->json, "Print what was written as JSON");
    command->callback([options, &exitStatus] { exitStatus = writeAll(*options); });
}

} // namespace knead
