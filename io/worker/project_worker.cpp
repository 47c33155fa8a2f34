#include "io/worker/project_worker.h"

#include "core/model/file_names.h"
#include "io/json/message_json.h"
#include "io/project/project_file.h"
#include "io/worker/confinement.h"
#include "io/worker/worker_process.h"

#include <cstring>

namespace knead {

namespace {

using Json = nlohmann::json;

constexpr const char* projectCommand = "--try-project-for-parent";
constexpr int projectArgumentCount = 4; // program, command, path, everything else
constexpr const char* damageKey = "damage";

std::string verdictOn(const std::string& path, bool rescues, TaskControl& control)
{
    Json verdict = Json::object();
    try {
        if (rescues)
            rescueProject(path, control);
        else
            readProject(path, control);
    } catch (const DamagedProject& damage) {
        verdict[damageKey] = toJson(damage.message());
    }
    return verdict.dump();
}

} // namespace

std::vector<std::string> argumentsForProject(const ProjectTrialRequest& request)
{
    const Json json{{"rescues", request.rescues},
                    {"memory", request.limits.memory},
                    {"processorTime", request.limits.processorTime}};
    return {"knead-cad-worker", projectCommand, request.path, json.dump()};
}

bool isProjectWorker(int argc, char** argv)
{
    return argc == projectArgumentCount && std::strcmp(argv[1], projectCommand) == 0;
}

int runProjectWorker(int, char** argv)
{
    const std::string path = argv[2];
    const Json request = Json::parse(argv[3]);
    const bool rescues = request.at("rescues").get<bool>();
    serveParent({.limits = {request.at("memory").get<std::uint64_t>(), request.at("processorTime").get<unsigned>()},
                 .readable = readableFor(path, false),
                 .subject = shortName(path),
                 .outOfMemory = Message("Project", "the project asks for more memory than there is."),
                 .work = [&](TaskControl& control) { return verdictOn(path, rescues, control); }});
}

std::optional<Message> damageFromBytes(std::string_view bytes)
{
    try {
        const Json verdict = Json::parse(bytes);
        if (!verdict.contains(damageKey))
            return std::nullopt;
        return messageFrom(verdict.at(damageKey));
    } catch (const Json::exception& error) {
        throw std::runtime_error(error.what());
    }
}

} // namespace knead
