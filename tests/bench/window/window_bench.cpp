#include "support/projects_on_test.h"
#include "ui/run_window.h"

#include <QElapsedTimer>
#include <QSignalSpy>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

using namespace knead;

namespace {

constexpr double volumeOfBar = 64e-6; // [m^3]
constexpr int repeats = 5;

} // namespace

/// How long a person waits for a project: from the click until the view has drawn it and keys work. Needs a display.
class WindowBench : public QObject, ProjectsOnTest {
    Q_OBJECT

    void makeProject(double objects)
    {
        m_window->open(QStringList(example("bar.step")));
        wait();
        m_window->refill(std::cbrt(volumeOfBar / objects));
        wait();
        switchGravity();
        document().stepOnce();
        waitForGesture();
        saveTo(file("bar.knead"));
    }

    /// [ms]
    double timeToOpen()
    {
        newWindow(m_services);
        QTest::qWait(300);
        QElapsedTimer timer;
        timer.start();
        openProject(file("bar.knead"));
        QSignalSpy drawn(&m_window->viewport(), &ViewportWidget::frameSwapped);
        m_window->viewport().update();
        [&] { QTRY_VERIFY_WITH_TIMEOUT(!drawn.isEmpty(), patience); }();
        return 1e-6 * static_cast<double>(timer.nsecsElapsed());
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            QSKIP("The view needs a display: run this under xvfb-run.");
        prepare();
    }

    void projectsOpen_data()
    {
        QTest::addColumn<double>("objects");
        for (const double objects : {3e3, 27e3, 100e3})
            QTest::newRow(QByteArray::number(objects, 'f', 0).constData()) << objects;
    }

    void projectsOpen()
    {
        QFETCH(double, objects);
        begin();
        makeProject(objects);
        const std::size_t filled = snapshot().objects;
        std::vector<double> times;
        for (int i = 0; i < repeats; ++i)
            times.push_back(timeToOpen());
        std::sort(times.begin(), times.end());
        std::printf("open a project of %zu objects, %.1f MB: median %.0f ms, best %.0f, worst %.0f\n", filled,
                    1e-6 * static_cast<double>(std::filesystem::file_size(bytesOf(file("bar.knead")))),
                    times[repeats / 2], times.front(), times.back());
        std::fflush(stdout);
        m_window.reset();
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowBench bench;
    return QTest::qExec(&bench, argc, argv);
}

#include "window_bench.moc"
