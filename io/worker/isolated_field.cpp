#include "io/worker/isolated_field.h"

#include "core/message/message.h"
#include "io/fields/field_bytes.h"
#include "io/fields/field_reader.h"
#include "io/formats/cad_format.h"
#include "io/worker/field_worker.h"
#include "io/worker/isolated_import.h"
#include "io/worker/isolated_work.h"

#include <cmath>

namespace knead {

namespace {

/// Runs the request in a process of its own and returns what it left.
template <class Result>
Result readFieldWork(const std::string& program, FieldReadingRequest request, TaskControl& control,
                     Result (*fromBytes)(std::string_view))
{
    const std::string& path = request.path;
    control.throwIfCancelled();
    request.namesOthers = isFieldCollection(path); // what is no file needs no process to be told so
    const ImportLimits limits = limitsFor(path);
    request.limits = {limits.memory, static_cast<unsigned>(std::ceil(limits.processorTime))};
    const NamelessFile file;
    const IsolatedWork work{
        .program = program,
        .arguments = argumentsForField(request),
        .path = path,
        .processorTime = limits.processorTime,
        .wallTime = limits.wallTime,
        .worker = Message("Work", "the reader"),
        .work = Message("Work", "reading"),
        .outOfTime = Message("Field", "Nothing was read; the file is damaged or far too large."),
        .afterFailure = Message("Field", "Nothing was read; write the file again, best as .vtu."),
    };
    const std::string bytes = runIsolated(work, file, control);
    try {
        Result read = fromBytes(bytes);
        read.path = path; // as given, whatever letters it is written in
        control.report(1, "done");
        return read;
    } catch (const std::runtime_error& error) {
        failReading(path, Message("Field", "the reader's result is damaged (%1). Nothing was read; try again.")
                              .with(messageOf(error)));
    }
}

} // namespace

FieldFile readFieldIsolated(const std::string& program, const std::string& path, const FieldChoice& choice,
                            TaskControl& control)
{
    return readFieldWork(program, {path, choice, false, {}}, control, fieldFromBytes);
}

NodalMesh readNodesIsolated(const std::string& program, const std::string& path, const std::string& unit,
                            TaskControl& control)
{
    return readFieldWork(program, {path, {.unit = unit}, true, {}}, control, meshFromBytes);
}

} // namespace knead
