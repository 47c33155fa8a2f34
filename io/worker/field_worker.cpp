#include "io/worker/field_worker.h"

#include "core/message/message.h"
#include "core/model/file_names.h"
#include "io/fields/field_bytes.h"
#include "io/fields/field_reader.h"
#include "io/worker/confinement.h"
#include "io/worker/worker_process.h"

#include <nlohmann/json.hpp>

#include <cstring>

namespace knead {

namespace {

using Json = nlohmann::json;

constexpr const char* fieldCommand = "--read-field-for-parent";
constexpr int fieldArgumentCount = 4; // program, command, path, everything else

std::string fieldBytesFor(const std::string& path, const Json& request, TaskControl& control)
{
    FieldChoice choice;
    choice.unit = request.at("unit").get<std::string>();
    if (request.at("mesh").get<bool>())
        return meshToBytes(readNodes(path, choice.unit, control));
    choice.name = request.at("name").get<std::string>();
    if (!request.at("step").is_null())
        choice.step = request.at("step").get<std::size_t>();
    return fieldToBytes(readField(path, choice, control));
}

} // namespace

std::vector<std::string> argumentsForField(const FieldReadingRequest& request)
{
    const Json json{{"namesOthers", request.namesOthers},
                    {"mesh", request.isForMesh},
                    {"step", request.choice.step ? Json(*request.choice.step) : Json()},
                    {"name", request.choice.name},
                    {"unit", request.choice.unit},
                    {"memory", request.limits.memory},
                    {"processorTime", request.limits.processorTime}};
    return {"knead-cad-worker", fieldCommand, request.path, json.dump(-1, ' ', true, Json::error_handler_t::replace)};
}

bool isFieldWorker(int argc, char** argv)
{
    return argc == fieldArgumentCount && std::strcmp(argv[1], fieldCommand) == 0;
}

int runFieldWorker(int, char** argv)
{
    const std::string path = argv[2];
    const Json request = Json::parse(argv[3]);
    serveParent({.limits = {request.at("memory").get<std::uint64_t>(), request.at("processorTime").get<unsigned>()},
                 .readable = readableFor(path, request.at("namesOthers").get<bool>()),
                 .subject = shortName(path),
                 .outOfMemory = Message(
                     "Field", "the file asks for more memory than there is; write fewer steps and values into it."),
                 .work = [&](TaskControl& control) { return fieldBytesFor(path, request, control); }});
}

} // namespace knead
