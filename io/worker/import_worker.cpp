#include "io/worker/import_worker.h"

#include "io/cad_format.h"
#include "io/importer.h"
#include "io/previewer.h"
#include "io/worker/model_file.h"

#include <Standard_OutOfMemory.hxx>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

#include <unistd.h>

namespace knead {

namespace {

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr const char* command = "--read-for-parent";
constexpr int argumentCount = 4; // program, command, path, everything else
constexpr std::chrono::milliseconds interval{20};

/// @return false when the disk takes no more, or nobody listens
bool writeAll(int descriptor, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            return false;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

/// Tells the parent of every new stage, and of progress within one now and then.
class PipeControl final : public TaskControl {
public:
    void report(double fraction, std::string_view stage) override
    {
        const Clock::time_point now = Clock::now();
        if (stage == m_stage && now < m_next)
            return;
        m_stage = stage;
        m_next = now + interval;
        writeAll(child_descriptors::lines, stageLine(fraction, stage));
    }
    bool isCancelled() const override { return false; } // the parent ends this process

private:
    std::string m_stage;
    Clock::time_point m_next{};
};

/// Written before work begins, since there may be no memory left for it later.
std::string& outOfMemoryBytes()
{
    static std::string bytes;
    return bytes;
}

/// The CAD libraries lack memory in places that no exception may leave: that is no crash.
[[noreturn]] void endTerminated()
{
    try {
        if (const std::exception_ptr exception = std::current_exception())
            std::rethrow_exception(exception);
    } catch (const std::bad_alloc&) {
        writeAll(child_descriptors::result, outOfMemoryBytes());
        _exit(0);
    } catch (const Standard_OutOfMemory&) {
        writeAll(child_descriptors::result, outOfMemoryBytes());
        _exit(0);
    } catch (...) {
    }
    std::abort();
}

ImportOptions optionsOf(const Json& json)
{
    ImportOptions options;
    options.linearDeflection = json.at("linearDeflection").get<double>();
    options.relativeDeflection = json.at("relativeDeflection").get<double>();
    options.angularDeflection = json.at("angularDeflection").get<double>();
    options.heal = json.at("heal").get<bool>();
    options.capsFlatOpenings = json.at("capsFlatOpenings").get<bool>();
    options.unit = json.at("unit").get<std::string>();
    options.parts = json.at("parts").get<std::vector<std::string>>();
    return options;
}

std::string bytesFor(const std::string& path, const Json& request)
{
    PipeControl control;
    try {
        if (request.at("preview").get<bool>())
            return previewToBytes(previewFile(path, control));
        const Model model = importFile(path, optionsOf(request), control);
        control.report(1, "handing the parts over");
        return modelToBytes(model);
    } catch (const std::bad_alloc&) {
        return outOfMemoryBytes();
    } catch (const std::exception& error) {
        return failureToBytes(error.what());
    }
}

} // namespace

std::vector<std::string> argumentsFor(const ReadingRequest& request)
{
    const Json json{{"preview", request.task == ReadingTask::preview},
                    {"linearDeflection", request.options.linearDeflection},
                    {"relativeDeflection", request.options.relativeDeflection},
                    {"angularDeflection", request.options.angularDeflection},
                    {"heal", request.options.heal},
                    {"capsFlatOpenings", request.options.capsFlatOpenings},
                    {"unit", request.options.unit},
                    {"parts", request.options.parts},
                    {"memory", request.limits.memory},
                    {"processorTime", request.limits.processorTime}};
    return {"knead", command, request.path, json.dump(-1, ' ', true, Json::error_handler_t::replace)};
}

bool isImportWorker(int argc, char** argv)
{
    return argc == argumentCount && std::strcmp(argv[1], command) == 0;
}

int runImportWorker(int, char** argv)
{
    const std::string path = argv[2];
    const Json request = Json::parse(argv[3]);
    limitOwnProcess({request.at("memory").get<std::uint64_t>(), request.at("processorTime").get<unsigned>()});
    outOfMemoryBytes() = failureToBytes(
        shortName(path) + ": the file asks for more memory than there is; it is damaged or far too detailed.");
    std::set_terminate(endTerminated);
    std::string bytes = bytesFor(path, request);
    if (!writeAll(child_descriptors::result, bytes)) {
        const std::string reason = std::generic_category().message(errno);
        if (ftruncate(child_descriptors::result, 0) == 0 && lseek(child_descriptors::result, 0, SEEK_SET) == 0)
            writeAll(child_descriptors::result,
                     failureToBytes(shortName(path) + ": the folder for temporary files takes no more (" + reason +
                                    "); make room there, or set TMPDIR to another folder."));
    }
    _exit(0); // the work is done; the CAD libraries may fall over while they tidy up
}

std::string stageLine(double fraction, std::string_view stage)
{
    return std::to_string(static_cast<int>(std::lround(1e6 * fraction))) + " " + std::string(stage) + "\n";
}

bool readStageLine(std::string_view line, double& fraction, std::string& stage)
{
    int millionths = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), millionths);
    if (error != std::errc() || end == line.data() + line.size() || *end != ' ' || millionths < 0 ||
        millionths > 1'000'000)
        return false;
    fraction = 1e-6 * millionths;
    stage = line.substr(static_cast<std::size_t>(end - line.data()) + 1);
    return true;
}

} // namespace knead
