#include "ui/project/autosave.h"

#include "ui/language/said.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

namespace knead {

namespace {

/// All but that of the current entry. They may take long to write, and follow from the rest.
std::map<History::Entry, HistoryRecord> takeOldMoments(Project& project)
{
    std::map<History::Entry, HistoryRecord> taken;
    for (History::Entry i = 0; i < project.entries.size(); ++i)
        if (i != project.current && project.entries[i].moment != nullptr) {
            taken.emplace(i, project.entries[i]);
            project.entries[i].moment = nullptr;
        }
    return taken;
}

} // namespace

/// What is being written whole need not be.
struct Autosave::Stop final : TaskControl {
    std::atomic<bool> stopped = false;
    void report(double /*fraction*/, std::string_view /*stage*/) override {}
    bool isCancelled() const override { return stopped; }
};

/// The thread, and what only it touches.
struct Autosave::Worker {
    using Job = std::function<void(Worker&)>;

    explicit Worker(std::function<void(const Message&)> teller)
        : tell(std::move(teller))
        , thread([this] { run(); })
    {
    }

    ~Worker()
    {
        post(nullptr);
        thread.join();
    }

    void post(Job job)
    {
        {
            const std::lock_guard lock(mutex);
            jobs.push_back(std::move(job));
        }
        wake.notify_one();
    }

    void run()
    {
        while (const Job job = next())
            try {
                job(*this);
            } catch (const Cancelled&) {
                // It is discarded next.
            } catch (const std::exception& error) {
                tell(messageOf(error));
            }
    }

    /// What can wait comes when there is nothing else to do, but before the end.
    Job next()
    {
        std::unique_lock lock(mutex);
        wake.wait(lock, [this] { return !jobs.empty() || !oldMoments.empty(); });
        if (!oldMoments.empty() && (jobs.empty() || !jobs.front()))
            return [](Worker& worker) { worker.keepOldMoment(); };
        Job job = std::move(jobs.front());
        jobs.pop_front();
        return job;
    }

    /// Calls for something that is kept, if anything is.
    template <class Change>
    void change(Change call)
    {
        if (kept && kept->isGoingOn())
            call(*kept);
    }

    void keepOldMoment()
    {
        const auto next = oldMoments.extract(oldMoments.begin());
        change([&](KeptWork& work) { work.replaceMoment(next.key(), next.mapped()); });
    }

    void drop()
    {
        oldMoments.clear();
        if (kept)
            kept->discard();
        kept.reset();
    }

    std::shared_ptr<KeptWork> kept;
    std::map<History::Entry, HistoryRecord> oldMoments; ///< entries of which the rest is kept
    std::optional<std::uint64_t> revisionInFile;        ///< when saving began; none when all was kept anew since

    const std::function<void(const Message&)> tell;
    std::mutex mutex; // guards the jobs
    std::deque<Job> jobs;
    std::condition_variable wake;
    std::thread thread; // last: it uses the others
};

Autosave::Autosave(ProjectServices services, QObject* parent)
    : QObject(parent)
    , m_services(std::move(services))
    , m_stop(std::make_shared<Stop>())
    , m_worker(std::make_unique<Worker>([this](const Message& sentence) { tell(sentence, &Autosave::failed); }))
{
}

Autosave::~Autosave()
{
    m_worker.reset(); // nobody is told of what fails now
}

/// On the thread.
void Autosave::tell(const Message& sentence, void (Autosave::*signal)(const QString&))
{
    QMetaObject::invokeMethod(
        this, [this, sentence, signal] { emit(this->*signal)(said(sentence)); }, Qt::QueuedConnection);
}

Autosave::Known Autosave::knownOf(const HistoryRecord& record)
{
    return {record.name, record.isKey, record.moment, record.moment != nullptr};
}

bool Autosave::isSame(const Known& known, const HistoryRecord& record)
{
    return known.isKey == record.isKey && known.hasMoment == (record.moment != nullptr) && known.name == record.name &&
           known.moment.lock() == record.moment;
}

void Autosave::know(const Project& project)
{
    m_known.emplace();
    for (const HistoryRecord& record : project.entries)
        m_known->entries.push_back(knownOf(record));
    m_known->starts = project.starts.size();
    m_known->current = project.current;
    m_known->panels = project.panels;
}

void Autosave::begin(Project project, WorkState state)
{
    discard();
    beginAgain(std::move(project), std::move(state));
}

void Autosave::takeOver(std::shared_ptr<KeptWork> kept, Project project, WorkState state)
{
    discard();
    m_worker->post([kept = std::move(kept)](Worker& worker) { worker.kept = kept; });
    beginAgain(std::move(project), std::move(state));
}

void Autosave::beginAgain(Project project, WorkState state)
{
    if (!m_services.keepWork)
        return;
    know(project);
    auto oldMoments = takeOldMoments(project);
    m_worker->post([this, makes = m_services.keepWork, project = std::move(project), state = std::move(state),
                    oldMoments = std::move(oldMoments), stop = m_stop](Worker& worker) {
        worker.revisionInFile.reset();
        worker.oldMoments.clear();
        if (!worker.kept)
            worker.kept = makes();
        worker.kept->begin(project, state, *stop);
        worker.oldMoments = oldMoments;
        QMetaObject::invokeMethod(this, &Autosave::begun, Qt::QueuedConnection);
    });
}

void Autosave::addStart(ProjectStart start)
{
    if (!m_known)
        return;
    ++m_known->starts;
    m_worker->post(
        [start = std::move(start)](Worker& worker) { worker.change([&](KeptWork& kept) { kept.addStart(start); }); });
}

void Autosave::follow(const std::vector<HistoryRecord>& entries, History::Entry current)
{
    if (!m_known)
        return;
    KnownHistory& known = *m_known;
    for (std::size_t i = 0; i < known.entries.size(); ++i)
        if (!isSame(known.entries[i], entries[i])) {
            const Known before = std::exchange(known.entries[i], knownOf(entries[i]));
            const bool isWork = before.name != entries[i].name || before.isKey != entries[i].isKey;
            replace(static_cast<History::Entry>(i), entries[i],
                    isWork ? &KeptWork::replaceEntry : &KeptWork::replaceMoment);
        }
    for (std::size_t i = known.entries.size(); i < entries.size(); ++i) {
        known.entries.push_back(knownOf(entries[i]));
        known.current = static_cast<History::Entry>(i);
        m_worker->post(
            [record = entries[i]](Worker& worker) { worker.change([&](KeptWork& kept) { kept.append(record); }); });
    }
    if (std::exchange(known.current, current) != current)
        m_worker->post([current](Worker& worker) { worker.change([&](KeptWork& kept) { kept.setCurrent(current); }); });
}

void Autosave::replace(History::Entry entry, const HistoryRecord& record, Replacing call)
{
    m_worker->post([entry, record, call](Worker& worker) {
        worker.oldMoments.erase(entry);
        worker.change([&](KeptWork& kept) { (kept.*call)(entry, record); });
    });
}

void Autosave::followPanels(const std::map<std::string, std::string>& panels)
{
    if (!m_known || m_known->panels == panels)
        return;
    m_known->panels = panels;
    m_worker->post([panels](Worker& worker) { worker.change([&](KeptWork& kept) { kept.setPanels(panels); }); });
}

void Autosave::keepGesture(std::vector<RecordedCommand> commands, std::uint64_t step)
{
    m_worker->post([commands = std::move(commands), step](Worker& worker) {
        worker.change([&](KeptWork& kept) { kept.keepGesture(commands, step); });
    });
}

void Autosave::keepView(ProjectView view)
{
    m_worker->post(
        [view = std::move(view)](Worker& worker) { worker.change([&](KeptWork& kept) { kept.setView(view); }); });
}

void Autosave::savingBegins()
{
    m_worker->post(
        [](Worker& worker) { worker.change([&](KeptWork& kept) { worker.revisionInFile = kept.revision(); }); });
}

void Autosave::saved(const std::string& projectFile)
{
    m_worker->post([projectFile](Worker& worker) {
        if (worker.revisionInFile)
            worker.change([&](KeptWork& kept) { kept.markSaved(projectFile, *worker.revisionInFile); });
    });
}

void Autosave::find(std::function<void(std::vector<Recovery>)> told)
{
    if (!m_services.findRecoveries)
        return;
    onRecoveries([this, finds = m_services.findRecoveries, told = std::move(told)] {
        QMetaObject::invokeMethod(
            this, [told, found = finds()] { told(found); }, Qt::QueuedConnection);
    });
}

void Autosave::drop(const Recovery& recovery)
{
    onRecoveries([drops = m_services.dropRecovery, recovery] { drops(recovery); });
}

/// On the thread, for work that is not this window's.
void Autosave::onRecoveries(std::function<void()> work)
{
    m_worker->post([this, work = std::move(work)](Worker& /*worker*/) {
        try {
            work();
        } catch (const std::runtime_error& error) {
            tell(messageOf(error), &Autosave::recoveriesFailed);
        }
    });
}

void Autosave::discard()
{
    m_known.reset();
    std::exchange(m_stop, std::make_shared<Stop>())->stopped = true;
    m_worker->post([](Worker& worker) { worker.drop(); });
}

} // namespace knead
