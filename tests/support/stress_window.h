#pragma once

#include "support/project_digest.h"
#include "support/window_on_test.h"
#include "ui/project/project_keeper.h"
#include "ui/run_window.h"

#include <QTimer>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>

#include <unistd.h>

namespace knead {

/// What the window says of itself, over and over.
struct Word {
    enum class Kind : std::uint32_t { working, saving, saved, exporting, exported } kind = Kind::working;
    std::uint32_t entries = 0; ///< of the history
    std::uint32_t current = 0;
    std::uint32_t isUnderWay = 0; ///< something is done that is not in them
    std::uint64_t step = 0;
    std::uint64_t hash = 0; ///< of the whole project that is written, see digests::of()
    std::int64_t time = 0;  ///< of the steady clock [ns]
};

/// What the window does: a bit of everything; nothing but letting time run; or saving and exporting without a pause.
enum class Work { all, play, save };
inline constexpr const char* workNames[] = {"--work", "--play", "--save"};

/// A window that works without end, driven by timers.
class StressWindow : public QObject, WindowOnTest {
public:
    explicit StressWindow(const QString& folder)
        : m_folder(folder)
    {
    }

    void begin(Work work)
    {
        prepare();
        qputenv("XDG_STATE_HOME", m_folder.toUtf8());
        m_services.projects.write = [write = m_services.projects.write](const std::string& path, const Project& project,
                                                                        TaskControl& control) {
            sayOfSaving(Word::Kind::saving, project);
            write(path, project, control);
            sayOfSaving(Word::Kind::saved, project);
        };
        m_services.exportParts = [write = m_services.exportParts](const std::string& path, const ExportJob& job,
                                                                  bool keepsReport, TaskControl& control) {
            tell({.kind = Word::Kind::exporting});
            ExportReport report = write(path, job, keepsReport, control);
            tell({.kind = Word::Kind::exported});
            return report;
        };
        show(m_services);
        m_window->open(QStringList(m_folder + "/work.knead"));
        QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty() && !m_window->tasks().isRunning(), patience);
        every(20, [this] { say(); });
        if (work == Work::all)
            workOnAll();
        else if (work == Work::save)
            saveAndExport();
        document().play();
        say();
    }

private:
    void workOnAll()
    {
        every(700, [this] { push(); });
        every(2300, [this] { document().togglePlay(); });
        every(1900, [this] { m_window->projects().save(); });
        every(3100, [this] { m_window->features().exports->exportTo(m_folder + "/out.stl"); });
    }

    void saveAndExport()
    {
        every(700, [this] { push(); });
        every(30, [this] {
            if (m_window->tasks().isRunning())
                return;
            if ((m_isExportNext = !m_isExportNext))
                m_window->projects().save();
            else
                m_window->features().exports->exportTo(m_folder + "/out.stl");
        });
    }

    void every(int milliseconds, const std::function<void()>& action)
    {
        auto* timer = new QTimer(this);
        connect(timer, &QTimer::timeout, this, action);
        timer->start(milliseconds);
    }

    /// Down and up in turns; the tool is there.
    void push()
    {
        document().select({Selection::Kind::Tool, 0});
        const auto key = m_isDown ? Qt::Key_PageUp : Qt::Key_PageDown;
        QTest::keyRelease(&m_window->viewport(), m_isDown ? Qt::Key_PageDown : Qt::Key_PageUp);
        QTest::keyPress(&m_window->viewport(), key);
        m_isDown = !m_isDown;
    }

    static void sayOfSaving(Word::Kind kind, const Project& project)
    {
        tell({.kind = kind, .hash = digests::of(project)});
    }

    static void tell(Word word)
    {
        word.time = std::chrono::steady_clock::now().time_since_epoch().count();
        [[maybe_unused]] const auto written = write(STDOUT_FILENO, &word, sizeof word);
    }

    void say()
    {
        const DocumentHistory& history = document().history();
        if (!history.isSettled() || document().isGoing())
            return;
        Word word;
        word.entries = static_cast<std::uint32_t>(history.tree().records().size());
        word.current = history.tree().current();
        word.isUnderWay = document().isAnythingUnderWay() ? 1 : 0;
        word.step = snapshot().step;
        tell(word);
    }

    QString m_folder;
    bool m_isDown = false;
    bool m_isExportNext = false;
};

/// With --work, --play or --save, and the folder of a project: what main() comes to in the process of the window.
inline int workForever(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    StressWindow worker(argv[2]);
    const auto* name = std::find(std::begin(workNames), std::end(workNames), std::string(argv[1]));
    worker.begin(static_cast<Work>(name - std::begin(workNames)));
    return QApplication::exec();
}

} // namespace knead
