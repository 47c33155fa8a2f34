#include "io/worker/isolated_import.h"

#include "core/message/message.h"
#include "io/formats/cad_format.h"
#include "io/worker/import_worker.h"
#include "io/worker/isolated_work.h"
#include "io/worker/model_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <unistd.h>

namespace knead {

namespace {

constexpr double mebibyte = 1 << 20;
constexpr double leastImportMemory = 3072 * mebibyte;
constexpr double importMemoryPerByte =
    400; // OpenCASCADE takes 5 to 40 bytes for one of a file, and its triangles come on top
constexpr double largestMemoryShare = 0.75; // of the machine's memory
constexpr double leastImportTime = 120;     // [s]
constexpr double timePerMebibyte = 30;

double machineMemory()
{
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

/// Parts of an assembly, colors and numbers of a mesh.
bool namesOtherFiles(FormatKind kind)
{
    return kind == FormatKind::Step || kind == FormatKind::Obj || kind == FormatKind::Gltf;
}

/// Runs the request in a process of its own and returns what it left.
template <class Result>
Result readIsolated(const std::string& program, ReadingRequest request, const ImportLimits& limits,
                    TaskControl& control, Result (*fromBytes)(std::string_view))
{
    const std::string& path = request.path;
    control.throwIfCancelled();
    // What is no CAD file at all needs no process to be told so.
    request.namesOthers = namesOtherFiles(recognizeFormat(path));
    const NamelessFile file;
    const IsolatedWork work{
        .program = program,
        .arguments = argumentsFor(request),
        .path = path,
        .processorTime = limits.processorTime,
        .wallTime = limits.wallTime,
        .worker = Message("Work", "the reader"),
        .work = Message("Work", "reading"),
        .outOfTime = Message("Import", "Nothing was imported; the file is damaged, or needs a longer time limit."),
        .afterFailure = Message("Import", "Nothing was imported; export the file again, best as STEP."),
    };
    const std::string bytes = runIsolated(work, file, control);
    try {
        Result read = fromBytes(bytes);
        read.file = path; // as given, whatever letters it is written in
        control.report(1, "done");
        return read;
    } catch (const std::runtime_error& error) {
        failReading(path, Message("Import", "the reader's result is damaged (%1). Nothing was imported; try again.")
                              .with(messageOf(error)));
    }
}

OwnLimits ownLimits(const ImportLimits& limits)
{
    return {limits.memory, static_cast<unsigned>(std::ceil(limits.processorTime))};
}

} // namespace

ImportLimits limitsFor(const std::string& path, const ImportOptions& options)
{
    std::error_code error;
    const std::uintmax_t found = std::filesystem::file_size(path, error);
    const double size = error ? 0 : static_cast<double>(found);
    const double memory = options.memoryLimit > 0 ? options.memoryLimit
                                                  : std::min(leastImportMemory + importMemoryPerByte * size,
                                                             largestMemoryShare * machineMemory());
    const double time = options.timeLimit > 0 ? options.timeLimit : leastImportTime + timePerMebibyte * size / mebibyte;
    return {static_cast<std::uint64_t>(memory), time, 2 * time};
}

Model importIsolated(const std::string& program, const std::string& path, const ImportOptions& options,
                     const ImportLimits& limits, TaskControl& control)
{
    const auto read = [&](const ImportOptions& how) {
        return readIsolated(program, {ReadingTask::import, path, how, ownLimits(limits)}, limits, control,
                            modelFromBytes);
    };
    try {
        return read(options);
    } catch (const WorkerCrashed& crash) {
        if (recognizeFormat(path) != FormatKind::Step || options.onlyShapes)
            throw;
        ImportOptions plain = options;
        plain.onlyShapes = true;
        try {
            Model model = read(plain);
            model.warnings.push_back(
                Message("Import", "%1: the reader crashed on what the file says beside its shapes; these were read "
                                  "without names, colors and assemblies, and without other files that it refers to.")
                    .with(shortName(path)));
            return model;
        } catch (const Cancelled&) {
            throw;
        } catch (const std::runtime_error&) {
            throw crash;
        }
    }
}

FilePreview previewIsolated(const std::string& program, const std::string& path, const ImportLimits& limits,
                            TaskControl& control)
{
    return readIsolated(program, {ReadingTask::preview, path, {}, ownLimits(limits)}, limits, control,
                        previewFromBytes);
}

} // namespace knead
