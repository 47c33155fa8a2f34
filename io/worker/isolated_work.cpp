#include "io/worker/isolated_work.h"

#include "core/message/message.h"
#include "io/formats/cad_format.h"
#include "io/worker/confinement.h"
#include "io/worker/model_file.h"
#include "io/worker/worker_process.h"

#include <cmath>
#include <csignal>

namespace knead {

namespace {

constexpr double workShare = 0.95; // of the progress; the rest is handing over

/// "2 minutes", "45 s"
Message duration(double seconds)
{
    return seconds < 120 ? Message::verbatim("%1 s").with(std::lround(seconds))
                         : Message("Work", "%1 minutes").with(std::lround(seconds / 60));
}

/// The stages that came through the pipe; keeps the last for the sentence about a crash.
class StageList {
public:
    explicit StageList(TaskControl& control)
        : m_control(control)
    {
    }

    void take(std::string_view line)
    {
        double fraction = 0;
        std::string stage;
        if (!readStageLine(line, fraction, stage))
            return;
        m_last = stage;
        m_control.report(workShare * fraction, stage);
    }

    /// " while making shapes"
    Message whileLast() const { return m_last.empty() ? Message() : Message("Work", " while %1").with(m_last); }

private:
    TaskControl& m_control;
    std::string m_last;
};

[[noreturn]] void failFor(const IsolatedWork& work, const ChildEnd& end, const StageList& stages)
{
    const bool outOfTime = end.kind == ChildEnd::Kind::signaled && end.number == SIGXCPU;
    if (outOfTime || end.kind == ChildEnd::Kind::tooLong)
        failReading(work.path, Message("Work", "%1 took longer than %2%3 and was ended. %4")
                                   .with(work.work, duration(outOfTime ? work.processorTime : work.wallTime),
                                         stages.whileLast(), work.outOfTime));
    if (end.kind == ChildEnd::Kind::signaled) {
        const Message crashed =
            Message("Work", "%1 crashed%2 (%3). %4")
                .with(work.worker, stages.whileLast(), reasonOfSignal(end.number), work.afterFailure);
        if (end.number == SIGKILL) // from outside
            failReading(work.path, crashed);
        throw WorkerCrashed(aboutFile(work.path, crashed));
    }
    failReading(
        work.path,
        Message("Work", "%1 ended without a result%2. %3").with(work.worker, stages.whileLast(), work.afterFailure));
}

} // namespace

std::string runIsolated(const IsolatedWork& work, const NamelessFile& file, TaskControl& control)
{
    control.throwIfCancelled();
    StageList stages(control);
    const ChildEnd end = runChild(
        {.program = work.program,
         .arguments = work.arguments,
         .result = &file,
         .environment = environmentForConfined()},
        work.wallTime > 0 ? work.wallTime : 1e9, [&](std::string_view line) { stages.take(line); },
        [&] { return control.isCancelled(); });
    if (end.kind == ChildEnd::Kind::cancelled)
        throw Cancelled();
    if (end.kind != ChildEnd::Kind::exited || end.number != 0)
        failFor(work, end, stages);
    control.report(workShare, "handing over");
    std::string bytes = file.content();
    if (const Message failure = failureIn(bytes); !failure.empty())
        throw Problem(failure);
    control.throwIfCancelled();
    return bytes;
}

} // namespace knead
