#include "io/worker/isolated_project.h"

#include "core/message/message.h"
#include "io/formats/cad_format.h"
#include "io/project/project_file.h"
#include "io/worker/isolated_import.h"
#include "io/worker/isolated_work.h"
#include "io/worker/project_worker.h"

#include <cmath>

namespace knead {

namespace {

constexpr double trialShare = 0.5;

/// @throws as readTriedProject()
void tryProject(const std::string& program, const std::string& path, bool rescues, TaskControl& control)
{
    control.throwIfCancelled();
    const ImportLimits limits = limitsFor(path);
    const ProjectTrialRequest request{
        path, rescues, {limits.memory, static_cast<unsigned>(std::ceil(limits.processorTime))}};
    const NamelessFile file;
    const IsolatedWork work{
        .program = program,
        .arguments = argumentsForProject(request),
        .path = path,
        .processorTime = limits.processorTime,
        .wallTime = limits.wallTime,
        .worker = Message("Work", "the reader"),
        .work = Message("Work", "reading"),
        .outOfTime = Message("Project", "Nothing was opened; the file is damaged or far too large."),
        .afterFailure = Message("Project", "Nothing was opened; open a copy of the project, or the part that it was "
                                           "made from."),
    };
    std::optional<Message> damage;
    const std::string bytes = runIsolated(work, file, control);
    try {
        damage = damageFromBytes(bytes);
    } catch (const std::runtime_error& error) {
        failReading(path, Message("Field", "the reader's result is damaged (%1). Nothing was read; try again.")
                              .with(messageOf(error)));
    }
    if (damage)
        throw DamagedProject(*damage);
}

} // namespace

Project readTriedProject(const std::string& program, const std::string& path, TaskControl& control)
{
    TaskPortion trial(control, 0, trialShare);
    tryProject(program, path, false, trial);
    TaskPortion reading(control, trialShare, 1);
    return readProject(path, reading);
}

RescuedProject rescueTriedProject(const std::string& program, const std::string& path, TaskControl& control)
{
    TaskPortion trial(control, 0, trialShare);
    tryProject(program, path, true, trial);
    TaskPortion reading(control, trialShare, 1);
    return rescueProject(path, reading);
}

} // namespace knead
