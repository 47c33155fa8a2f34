#include "core/session/frame.h"
#include "io/formats/mesh_writer.h"
#include "support/projects_on_test.h"
#include "support/shapes.h"
#include "ui/run_window.h"

#include <QElapsedTimer>
#include <QSignalSpy>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <random>

using namespace knead;

namespace {

constexpr double volumeOfBar = 64e-6; // [m^3]
constexpr int repeats = 5;
constexpr int pictures = 60;
constexpr int picks = 500;

/// "median 12.1 ms (82 a second), worst 20.3 ms"
void print(const char* what, std::vector<double> milliseconds)
{
    std::sort(milliseconds.begin(), milliseconds.end());
    const double median = milliseconds[milliseconds.size() / 2];
    std::printf("%s: median %.2f ms (%.0f a second), worst %.2f ms\n", what, median, 1000 / median,
                milliseconds.back());
    std::fflush(stdout);
}

/// What other programs add to it by taking the caches is least in the quickest ones.
void printSpent(const char* what, std::vector<double> milliseconds)
{
    std::sort(milliseconds.begin(), milliseconds.end());
    std::printf("%s: best %.1f ms, quartile %.1f, median %.1f\n", what, milliseconds.front(),
                milliseconds[milliseconds.size() / 4], milliseconds[milliseconds.size() / 2]);
}

/// Of all threads of this program; it says more than the clock where other programs keep the machine busy [s].
double processorSeconds()
{
    timespec spent{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &spent);
    return static_cast<double>(spent.tv_sec) + 1e-9 * static_cast<double>(spent.tv_nsec);
}

} // namespace

/// How long a person waits: for a project, from the click until the view has drawn it and keys work; for the next picture of a large
/// skin, and for what is under the mouse. Needs a display.
class WindowBench : public QObject, ProjectsOnTest {
    Q_OBJECT

    void makeProject(double objects)
    {
        m_window->open(QStringList(example("bar.step")));
        wait();
        m_window->features().imports->refill(std::cbrt(volumeOfBar / objects));
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

    /// A torus of 100,000 triangles, in a window of 1280x800.
    void openLargeSkin()
    {
        const QString path = file("torus.3mf"); // which knows its unit, so that nothing is asked
        writeMeshes(bytesOf(path), {{.name = "torus", .color = {}, .mesh = shapes::torus(0.03, 0.01, 500, 100)}});
        m_window->open(QStringList(path));
        wait();
        QVERIFY2(!document().isEmpty(), qPrintable(m_window->banner().sentence()));
        QTest::qWait(500); // the view turns to fit
        std::size_t triangles = 0;
        for (const auto& body : document().content().bodies)
            triangles += body->mesh.triangles.size();
        std::printf("a skin of %zu triangles, %zu objects, view %d x %d\n", triangles, snapshot().objects,
                    m_window->viewport().width(), m_window->viewport().height());
    }

    /// From asking for a picture until it is there [ms].
    double timeToDraw()
    {
        QSignalSpy drawn(&m_window->viewport(), &ViewportWidget::frameSwapped);
        QElapsedTimer timer;
        timer.start();
        m_window->viewport().repaint();
        [&] { QTRY_VERIFY_WITH_TIMEOUT(!drawn.isEmpty(), patience); }();
        return 1e-6 * static_cast<double>(timer.nsecsElapsed());
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            QSKIP("The view needs a display: run this under xvfb-run.");
        prepare(Eyes::open);
    }

    /// While the mouse turns the view, and while the material moves as fast as it is simulated.
    void largeSkinsAreDrawn()
    {
        begin();
        openLargeSkin();
        ViewportWidget& view = m_window->viewport();
        const QPoint middle(view.width() / 2, view.height() / 2);
        std::vector<double> times;
        std::vector<double> spent;
        QTest::mousePress(&view, Qt::MiddleButton, {}, middle);
        for (int i = 0; i < pictures; ++i) {
            QTest::mouseMove(&view, middle + QPoint(3 * i, i));
            const double before = processorSeconds();
            times.push_back(timeToDraw());
            spent.push_back(1000 * (processorSeconds() - before));
        }
        QTest::mouseRelease(&view, Qt::MiddleButton, {}, middle);
        print("a picture while the view is turned", times);
        printSpent("its processor time, of all threads", spent);

        switchGravity();
        document().play();
        [&] { QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.05, patience); }();
        QSignalSpy drawn(&view, &ViewportWidget::frameSwapped);
        QElapsedTimer timer;
        timer.start();
        QTest::qWait(5000);
        std::printf("pictures while it is simulated: %.1f a second\n",
                    1e9 * static_cast<double>(drawn.size()) / static_cast<double>(timer.nsecsElapsed()));
        document().pause();
    }

    /// Of a skin that has moved, so that nothing of it is known from before.
    void largeSkinsArePicked()
    {
        begin();
        openLargeSkin();
        ViewportWidget& view = m_window->viewport();
        switchGravity();
        std::minstd_rand random(1);
        std::vector<double> first;
        std::vector<double> more;
        int hits = 0;
        for (int step = 0; step < repeats; ++step) {
            const double time = snapshot().time;
            document().stepOnce();
            [&] { QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > time, patience); }();
            for (int i = 0; i < picks; ++i) {
                const auto within = [&](int length) { // the middle half, where the part is
                    return length / 4 + static_cast<int>(random() % static_cast<unsigned>(length / 2));
                };
                const QPointF place(within(view.width()), within(view.height()));
                QElapsedTimer timer;
                timer.start();
                hits += view.hitAt(place).kind != PickHit::Kind::Nothing ? 1 : 0;
                (i == 0 ? first : more).push_back(1e-6 * static_cast<double>(timer.nsecsElapsed()));
            }
        }
        std::printf("%d of %d picks hit something\n", hits, repeats * picks);
        print("the first pick after it moved", first);
        print("each of the next", more);
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
