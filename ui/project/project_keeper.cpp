#include "ui/project/project_keeper.h"

#include "ui/tasks/task_runner.h"

#include <QFile>
#include <QFileInfo>
#include <QScopedValueRollback>
#include <QTimer>

#include <filesystem>
#include <utility>

namespace knead {

namespace {

constexpr auto watchInterval = std::chrono::milliseconds(500);
constexpr auto viewInterval = std::chrono::seconds(30);
constexpr auto retryInterval = std::chrono::seconds(15);

} // namespace

ProjectKeeper::ProjectKeeper(ProjectServices services, Packing packing, const Window& window)
    : m_services(std::move(services))
    , m_packing(std::move(packing))
    , m_window(window)
    , m_autosave(m_services)
    , m_watch(new QTimer(this))
{
    connect(&m_window.document, &Document::changed, this, &ProjectKeeper::documentChanged);
    connect(&m_window.document.history(), &DocumentHistory::changed, this, &ProjectKeeper::historyChanged);
    connect(&m_window.document.history(), &DocumentHistory::settled, this, &ProjectKeeper::historyChanged);
    const auto savingEnded = [this] { // without finishSaving()
        if (m_saving && m_saving->stage == Saving::Stage::running)
            m_saving.reset();
    };
    connect(&m_window.tasks, &TaskRunner::cancelled, this, savingEnded);
    connect(&m_window.tasks, &TaskRunner::failed, this, savingEnded);
    connect(&m_window.tasks, &TaskRunner::finished, this, &ProjectKeeper::goOnSaving);
    connect(&m_autosave, &Autosave::failed, this, &ProjectKeeper::keepingFailed);
    connect(&m_autosave, &Autosave::recoveriesFailed, this,
            [this](const QString& sentence) { emit problem(sentence, {}, {}); });
    connect(&m_autosave, &Autosave::begun, this, [this] {
        if (std::exchange(m_isRefused, false))
            emit told(tr("The work is kept for recovery again."));
    });
    connect(m_watch, &QTimer::timeout, this, &ProjectKeeper::watch);
    m_watch->start(watchInterval);
}

ProjectKeeper::~ProjectKeeper() = default;

QString ProjectKeeper::name() const
{
    if (!m_path.isEmpty())
        return QFileInfo(m_path).fileName();
    if (m_window.document.isEmpty())
        return {};
    return QFileInfo(QFile::decodeName(m_window.document.content().model->file.c_str())).fileName();
}

bool ProjectKeeper::isModified() const
{
    const Document& document = m_window.document;
    if (document.isEmpty() || document.history().isEmpty())
        return false;
    return document.isAnythingUnderWay() || !document.history().isSettled() ||
           m_savedRevision != document.history().revision();
}

bool ProjectKeeper::isProject(const QString& file) const
{
    return !m_services.ending.empty() &&
           QFileInfo(file).suffix().compare(QString::fromStdString(m_services.ending), Qt::CaseInsensitive) == 0;
}

/// However it is called: by links, or from another folder.
bool ProjectKeeper::isOwnFile(const std::string& path) const
{
    if (m_path.isEmpty() || path.empty())
        return false;
    std::error_code error;
    const auto own = std::filesystem::weakly_canonical(QFile::encodeName(m_path).toStdString(), error);
    const auto other = std::filesystem::weakly_canonical(path, error);
    return !error && own == other;
}

QString ProjectKeeper::filter() const
{
    return tr("Knead projects (*.%1)").arg(QString::fromStdString(m_services.ending));
}

void ProjectKeeper::keepPanel(const std::string& name, PanelMemory panel)
{
    m_kept[name] = std::move(panel);
}

void ProjectKeeper::panelChanged()
{
    if (!m_isChanging && !m_isNew && m_autosave.isBegun())
        m_autosave.followPanels(panels());
}

void ProjectKeeper::open(PreparedModel parts)
{
    const QScopedValueRollback changing(m_isChanging, true);
    m_window.document.open(std::move(parts));
    ++m_documents;
    m_path.clear();
    m_lock.reset();
    m_saving.reset();
    m_marks.clear();
    m_panels.clear();
    m_savedRevision = m_window.document.history().revision();
    m_isNew = true;
    m_wasModified = isModified();
    emit changed();
}

// --- what changes ---------------------------------------------------------------------------------------------------------

void ProjectKeeper::documentChanged(Document::Change what)
{
    if (what != Document::Change::Selection && !m_isChanging)
        noteModified();
}

void ProjectKeeper::historyChanged()
{
    const DocumentHistory& history = m_window.document.history();
    if (m_isChanging)
        return;
    if (!history.isEmpty() && m_isNew && history.isSettled()) {
        m_isNew = false;
        m_autosave.begin(collect(), state());
        m_gestureKept = m_viewKept = Clock::now();
    } else if (!history.isEmpty() && !m_isNew && m_autosave.isBegun()) {
        for (std::size_t start = m_autosave.knownStarts(); start < history.starts().size(); ++start)
            m_autosave.addStart(history.starts()[start].start);
        m_autosave.follow(history.tree().records(), history.tree().current());
        m_autosave.followPanels(panels());
    }
    noteModified();
}

void ProjectKeeper::noteModified()
{
    if (std::exchange(m_wasModified, isModified()) != m_wasModified)
        emit changed();
}

void ProjectKeeper::watch()
{
    if (!m_autosave.isBegun() || m_isNew)
        return;
    const Clock::time_point now = Clock::now();
    if (m_isRefused && now - m_lastTry >= retryInterval) {
        m_lastTry = now;
        m_autosave.beginAgain(collect(), state());
    }
    if (now - m_gestureKept >= m_keepingInterval)
        lookAfterGesture();
    if (now - m_viewKept >= viewInterval) {
        m_viewKept = now;
        m_autosave.keepView(view());
    }
}

/// A gesture belongs to the entry that is current now; it is not kept when another one is, or was, by the time the simulation
/// tells. Then it is looked at again soon.
void ProjectKeeper::lookAfterGesture()
{
    Document& document = m_window.document;
    if (!document.isAnythingUnderWay() || !document.history().isSettled() || document.isGoing())
        return;
    document.lookAtGesture([this, place = place()](std::vector<RecordedCommand> commands, std::uint64_t step) {
        const auto keep = [this, place, commands = std::move(commands), step] {
            const Clock::time_point now = Clock::now();
            if (!m_window.document.history().isSettled() || this->place() != place ||
                now - m_gestureKept < m_keepingInterval)
                return;
            m_gestureKept = now;
            m_autosave.keepGesture(commands, step);
        };
        QMetaObject::invokeMethod(this, keep, Qt::QueuedConnection);
    });
}

ProjectKeeper::Place ProjectKeeper::place() const
{
    if (m_window.document.history().isEmpty())
        return {m_documents, 0, 0};
    const History& tree = m_window.document.history().tree();
    return {m_documents, tree.current(), tree.records().size()};
}

/// It is said once, and tried again and again.
void ProjectKeeper::keepingFailed(const QString& sentence)
{
    m_lastTry = Clock::now();
    if (!std::exchange(m_isRefused, true))
        emit problem(sentence, tr("Save"), [this] { save(); });
}

} // namespace knead
