#include "io/worker/export_worker.h"

#include "core/message/message.h"
#include "io/export/exporter.h"
#include "io/export/job_file.h"
#include "io/worker/worker_process.h"

#include <nlohmann/json.hpp>

#include <cstring>

namespace knead {

namespace {

using Json = nlohmann::json;

constexpr const char* exportCommand = "--export-for-parent";
constexpr int exportArgumentCount = 4; // program, command, path, everything else

} // namespace

std::vector<std::string> argumentsForExport(FormatKind kind, const std::string& path, const OwnLimits& limits)
{
    const Json json{
        {"kind", static_cast<int>(kind)}, {"memory", limits.memory}, {"processorTime", limits.processorTime}};
    return {"knead-cad-worker", exportCommand, path, json.dump()};
}

bool isExportWorker(int argc, char** argv)
{
    return argc == exportArgumentCount && std::strcmp(argv[1], exportCommand) == 0;
}

int runExportWorker(int, char** argv)
{
    const std::string path = argv[2];
    const Json request = Json::parse(argv[3]);
    serveParent({.limits = {request.at("memory").get<std::uint64_t>(), request.at("processorTime").get<unsigned>()},
                 .subject = shortName(path),
                 .outOfMemory =
                     Message("Export", "the export asks for more memory than there is; export fewer parts at a time."),
                 .work = [&](TaskControl& control) {
                     return exportedToBytes(exportCad(static_cast<FormatKind>(request.at("kind").get<int>()),
                                                      jobFromBytes(requestOfParent()), control));
                 }});
}

} // namespace knead
