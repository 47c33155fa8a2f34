#include "io/worker/import_worker.h"

#include "core/message/message.h"
#include "io/formats/cad_format.h"
#include "io/importer.h"
#include "io/previewer.h"
#include "io/worker/confinement.h"
#include "io/worker/model_file.h"
#include "io/worker/worker_process.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstring>

namespace knead {

namespace {

using Json = nlohmann::json;

constexpr const char* importCommand = "--read-for-parent";
constexpr int importArgumentCount = 4; // program, command, path, everything else

ImportOptions optionsOf(const Json& json)
{
    ImportOptions options;
    options.linearDeflection = json.at("linearDeflection").get<double>();
    options.relativeDeflection = json.at("relativeDeflection").get<double>();
    options.angularDeflection = json.at("angularDeflection").get<double>();
    options.heal = json.at("heal").get<bool>();
    options.capsFlatOpenings = json.at("capsFlatOpenings").get<bool>();
    options.onlyShapes = json.at("onlyShapes").get<bool>();
    options.unit = json.at("unit").get<std::string>();
    options.parts = json.at("parts").get<std::vector<std::string>>();
    const auto shift = json.at("shift").get<std::array<double, 3>>();
    options.shift = Vec3(shift[0], shift[1], shift[2]);
    return options;
}

std::string bytesFor(const std::string& path, const Json& request, TaskControl& control)
{
    if (request.at("preview").get<bool>())
        return previewToBytes(previewFile(path, control));
    const Model model = importFile(path, optionsOf(request), control);
    control.report(1, "handing the parts over");
    return modelToBytes(model);
}

} // namespace

std::vector<std::string> argumentsFor(const ReadingRequest& request)
{
    const Json json{{"namesOthers", request.namesOthers},
                    {"preview", request.task == ReadingTask::preview},
                    {"linearDeflection", request.options.linearDeflection},
                    {"relativeDeflection", request.options.relativeDeflection},
                    {"angularDeflection", request.options.angularDeflection},
                    {"heal", request.options.heal},
                    {"capsFlatOpenings", request.options.capsFlatOpenings},
                    {"onlyShapes", request.options.onlyShapes},
                    {"unit", request.options.unit},
                    {"parts", request.options.parts},
                    {"shift", {request.options.shift.x(), request.options.shift.y(), request.options.shift.z()}},
                    {"memory", request.limits.memory},
                    {"processorTime", request.limits.processorTime}};
    return {"knead-cad-worker", importCommand, request.path, json.dump(-1, ' ', true, Json::error_handler_t::replace)};
}

bool isImportWorker(int argc, char** argv)
{
    return argc == importArgumentCount && std::strcmp(argv[1], importCommand) == 0;
}

int runImportWorker(int, char** argv)
{
    const std::string path = argv[2];
    const Json request = Json::parse(argv[3]);
    serveParent({.limits = {request.at("memory").get<std::uint64_t>(), request.at("processorTime").get<unsigned>()},
                 .readable = readableFor(path, request.at("namesOthers").get<bool>()),
                 .subject = shortName(path),
                 .outOfMemory = Message(
                     "Import", "the file asks for more memory than there is; it is damaged or far too detailed."),
                 .work = [&](TaskControl& control) { return bytesFor(path, request, control); }});
}

} // namespace knead
