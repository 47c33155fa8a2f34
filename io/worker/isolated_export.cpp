#include "io/worker/isolated_export.h"

#include "core/message/message.h"
#include "io/export/job_file.h"
#include "io/files/safe_file.h"
#include "io/formats/cad_format.h"
#include "io/worker/export_worker.h"
#include "io/worker/isolated_work.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

constexpr double gibibyte = 1U << 30U;
constexpr double leastExportMemory = 4 * gibibyte;
constexpr double exportMemoryPerByte = 200; // of the job
constexpr double leastExportTime = 600;     // [s]
constexpr double timePerByte = 60e-6;       // [s]

FormatKind kindFor(const std::string& path)
{
    const FileFormat* format = formatToWrite(path);
    if (format == nullptr || !format->isSmooth)
        failReading(path, Message("Export", "smooth faces go into .step, .iges and .brep files only."));
    return format->kind;
}

} // namespace

ExportReport exportIsolated(const std::string& program, const std::string& path, const ExportJob& job,
                            TaskControl& control)
{
    const FormatKind kind = kindFor(path);
    checkIsWritable(path); // before the work, not after it
    const std::string bytes = jobToBytes(job);
    const auto size = static_cast<double>(bytes.size());
    const OwnLimits limits{static_cast<std::uint64_t>(leastExportMemory + exportMemoryPerByte * size),
                           static_cast<unsigned>(std::ceil(leastExportTime + timePerByte * size))};
    NamelessFile file;
    file.write(bytes);
    const IsolatedWork work{
        .program = program,
        .arguments = argumentsForExport(kind, path, limits),
        .path = path,
        .processorTime = static_cast<double>(limits.processorTime),
        .wallTime = 2.0 * limits.processorTime,
        .worker = Message("Work", "the writer"),
        .work = Message("Work", "writing"),
        .outOfTime =
            Message("Export", "Nothing was written; export fewer parts at a time, or with a larger tolerance."),
        .afterFailure =
            Message("Export", "Nothing was written; export the parts one by one to see which one it is, or as a mesh."),
    };
    ExportedFile exported;
    try {
        exported = exportedFromBytes(runIsolated(work, file, control));
    } catch (const Cancelled&) {
        throw;
    } catch (const std::runtime_error& error) {
        if (std::string(error.what()).starts_with(shortName(path) + ": "))
            throw;
        failReading(path, messageOf(error));
    }
    writeFileSafely(path, exported.bytes);
    exported.report.file = path;
    control.report(1, "done");
    return std::move(exported.report);
}

} // namespace knead
