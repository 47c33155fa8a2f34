#include "support/projects_on_test.h"
#include "ui/run_window.h"
#include "ui/viewport/view_grid.h"

#include <QScreen>

#include <set>

using namespace knead;

namespace {

/// How many colors there are: where edges are smoothed, many more than where they are jagged.
std::size_t colorsIn(const QImage& image)
{
    std::set<QRgb> colors;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            colors.insert(image.pixel(x, y));
    return colors.size();
}

} // namespace

/// Pictures of what moves need not be smoothed where that takes long. What is still, or is kept, always is.
class WindowSketchTest : public QObject, ProjectsOnTest {
    Q_OBJECT

    ViewportWidget& view() { return m_window->viewport(); }

    /// What is on the screen, which asks for no other picture.
    QImage seen()
    {
        const QPoint corner = view().mapTo(m_window.get(), QPoint());
        return m_window->screen()
            ->grabWindow(m_window->winId(), corner.x(), corner.y(), view().width(), view().height())
            .toImage()
            .convertToFormat(QImage::Format_RGB32);
    }

    void keep(const QImage& image, const char* name)
    {
        if (const QString folder = qEnvironmentVariable("KNEAD_PICTURES"); !folder.isEmpty())
            image.save(QDir(folder).filePath(QStringLiteral("sketch-%1.png").arg(name)));
    }

    Camera turned() const
    {
        Camera camera = m_window->viewport().camera();
        camera.orbit(40, 25);
        return camera;
    }

    void waitForPicture()
    {
        QSignalSpy swapped(&view(), &ViewportWidget::frameSwapped);
        view().repaint();
        QTRY_VERIFY_WITH_TIMEOUT(!swapped.isEmpty(), patience);
    }

    /// Moves the view there, as if a full picture took longer, or no longer, than a person waits.
    void jump(const Camera& camera, bool isSlow)
    {
        view().setLongestFull(isSlow ? 0 : 1000);
        view().jumpTo(camera);
        waitForPicture();
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare(Eyes::open);
    }

    void init()
    {
        QSettings().clear();
        begin();
        openExample("bracket.step");
        QTRY_VERIFY_WITH_TIMEOUT(!view().isSketch(), patience);
        view().setTurningSmoothly(false);
    }

    void cleanup() { m_window.reset(); }

    void whatIsStillIsSeenInFull()
    {
        const Camera there = turned();
        jump(there, false);
        QVERIFY(!view().isSketch());
        rest();
        const QImage full = seen();
        Camera elsewhere = there;
        elsewhere.orbit(-30, 10);
        jump(elsewhere, true);
        QVERIFY(view().isSketch());
        jump(there, true);
        QVERIFY(view().isSketch());
        const QImage sketch = seen();
        keep(full, "full");
        keep(sketch, "sketch");
        QVERIFY(colorsIn(sketch) < colorsIn(full));
        QTRY_VERIFY_WITH_TIMEOUT(!view().isSketch(), patience);
        waitForPicture();
        QCOMPARE(seen(), full);
    }

    void whereFullPicturesAreQuickAllAre()
    {
        jump(turned(), false);
        QVERIFY(!view().isSketch());
    }

    void aPictureThatIsKeptIsFull()
    {
        const Camera there = turned();
        jump(there, false);
        const QImage full = view().grabFramebuffer();
        jump(turned(), true);
        jump(there, true);
        QVERIFY(view().isSketch());
        QCOMPARE(view().grabFramebuffer(), full);
        QVERIFY(!view().isSketch());
    }

    /// Who wants no smoothing has nothing to wait for.
    void withoutSmoothingThereAreNoSketches()
    {
        view().setSamples(1);
        jump(turned(), true);
        QVERIFY(!view().isSketch());
    }

    void whileTimeRunsSketchesAreDrawnAndThenAFullPicture()
    {
        view().setLongestFull(0);
        switchGravity();
        document().play();
        QTRY_VERIFY_WITH_TIMEOUT(view().isSketch() && snapshot().time > 0, patience);
        QTest::qWait(400); // more than twice as long as things are taken to stand still
        QTRY_VERIFY_WITH_TIMEOUT(view().isSketch(), patience);
        document().pause();
        QTRY_VERIFY_WITH_TIMEOUT(!view().isSketch(), patience);
    }

    /// As what turns; other options are shown in full at once.
    void aSectionPlaneThatIsDraggedIsSketched()
    {
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ShiftModifier);
        QTRY_VERIFY(view().options().section.plane.has_value());
        rest();
        waitForPicture();
        view().setLongestFull(0);
        for (int i = 0; i < 3; ++i) {
            SceneOptions options = view().options();
            options.section.plane->offset += 1e-4;
            view().setOptions(options);
            waitForPicture();
            QVERIFY(view().isSketch());
        }
        QTRY_VERIFY_WITH_TIMEOUT(!view().isSketch(), patience);
        SceneOptions options = view().options();
        options.grid = !options.grid;
        view().setOptions(options);
        waitForPicture();
        QVERIFY(!view().isSketch());
    }

    void otherViewsDoTheSame()
    {
        m_window->findChild<ViewGrid*>()->arrange(ViewArrangement::two);
        SideView* side = nullptr;
        QTRY_VERIFY((side = m_window->findChild<SideView*>()) != nullptr && side->isVisible());
        side->setLongestFull(0);
        QTRY_VERIFY_WITH_TIMEOUT(!side->isSketch() && side->drawings() > 0, patience);
        rest();
        Camera camera = side->camera();
        camera.orbit(20, 20);
        side->setCamera(camera);
        QTRY_VERIFY_WITH_TIMEOUT(side->isSketch(), patience);
        QTRY_VERIFY_WITH_TIMEOUT(!side->isSketch(), patience);
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowSketchTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_sketch_test.moc"
