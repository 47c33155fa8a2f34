#include "support/contrast.h"
#include "support/cut_texts.h"
#include "support/window_on_test.h"
#include "ui/interaction/hands.h"
#include "ui/language/language.h"
#include "ui/panels/status_readings.h"
#include "ui/preferences/preferences.h"
#include "ui/project/thumbnails.h"
#include "ui/run_window.h"
#include "ui/selection/selection_model.h"
#include "ui/viewport/color_legend.h"
#include "ui/viewport/scene_style.h"

#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTreeWidget>
#include <QWheelEvent>

#include <vtkRenderWindow.h>

#include <algorithm>
#include <cmath>

using namespace knead;

/// Whether what the window shows can be seen and read: marks on parts of any color, the part itself, panels to their ends, words.
class WindowReadableTest : public QObject, WindowOnTest {
    Q_OBJECT

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
        QSettings().setValue("language", "en");
        show(m_services);
    }

    void cleanup() { m_window.reset(); }

    void marksStandOutFromEveryColor()
    {
        for (const SceneStyle& style : {lightScene(), darkScene()})
            for (int r = 0; r <= 4; ++r)
                for (int g = 0; g <= 4; ++g)
                    for (int b = 0; b <= 4; ++b) {
                        const Color ground{r / 4.0F, g / 4.0F, b / 4.0F};
                        const Color mark = standingOut(ground, style.selectedEdge, style.selectedOther);
                        QVERIFY2(differenceOf(ground, mark) > 0.7,
                                 qPrintable(QStringLiteral("%1 %2 %3").arg(r).arg(g).arg(b)));
                    }
    }

    void aSelectedFaceStandsOutOnABluePart()
    {
        openExample("bracket.step");
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            m_window->features().preferences->setTheme(theme);
            document().selected().select({});
            const auto [place, face] = faceTowardsTheEye();
            QTest::mouseMove(&view(), QPoint(5, view().height() - 5));
            drawn();
            const Color before = colorAt(place);
            QTest::keyClick(m_window.get(), Qt::Key_2);
            click(place);
            QTRY_VERIFY(document().selected().region().contains(0, face));
            QTest::mouseMove(&view(), QPoint(5, view().height() - 5));
            drawn();
            picture(theme == Theme::Light ? "selected-face-light" : "selected-face-dark");
            const double difference = differenceOf(before, colorAt(place));
            QVERIFY2(difference > 0.6, qPrintable(QString::number(difference)));
        }
    }

    void keyCardsLeaveThePartFree_data()
    {
        QTest::addColumn<QString>("file");
        for (const char* name : {"bar", "bracket", "handle", "plate"})
            QTest::newRow(name) << QString(name) + ".step";
    }

    void keyCardsLeaveThePartFree()
    {
        QFETCH(QString, file);
        openExample(qPrintable(file), 10);
        for (const char* tool : {"addBlock", "addBall"})
            action(tool)->trigger();
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{2});
        QTest::keyClick(m_window.get(), Qt::Key_1, Qt::KeypadModifier);
        action("driveByKeys")->setChecked(true);
        QTest::keyClick(m_window.get(), Qt::Key_F);
        rest();
        auto* cards = find<QWidget>("keyCards");
        QTRY_VERIFY(cards->isVisible());
        picture(qPrintable("key-cards-" + file.chopped(5)));
        QTRY_VERIFY2(!seenPart().intersects(cards->geometry()), "the part is beside the cards");
        QVERIFY(view().rect().contains(seenPart()));
        action("driveByKeys")->setChecked(false);
        const double small = view().camera().viewHeight();
        QTest::keyClick(m_window.get(), Qt::Key_F);
        if (file == "plate.step") // as wide as the view, with the cards and without
            QTRY_VERIFY(view().camera().viewHeight() <= (1 + 1e-9) * small);
        else
            QTRY_VERIFY2(view().camera().viewHeight() < small, "without the cards there is more room");
    }

    void theLegendLeavesThePartFree()
    {
        openExample("plate.step", 10);
        QTest::keyClick(m_window.get(), Qt::Key_1, Qt::KeypadModifier);
        action("color-displacement")->trigger();
        auto* legend = find<QWidget>("colorLegend");
        QTRY_VERIFY(legend->isVisible());
        QTest::keyClick(m_window.get(), Qt::Key_F);
        rest();
        picture("legend-front");
        QTRY_VERIFY(!seenPart().intersects(legend->geometry()));
    }

    /// Everything of every panel can be brought into sight in a small window.
    void panelsCanBeReadToTheirEnds()
    {
        openExample("bar.step", 10);
        document().addTool(ToolKind::box);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        QCOMPARE(m_window->size(), QSize(1280, 800));
        for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            drawn();
            picture(qPrintable("dock-" + dock->objectName()));
            for (QWidget* widget : dock->widget()->findChildren<QWidget*>())
                if (isRow(*widget, *dock))
                    QVERIFY2(canBeSeen(*widget), qPrintable(dock->objectName() + ": " + widget->objectName() + ' ' +
                                                            widget->metaObject()->className() + ' ' + textOf(*widget)));
        }
    }

    /// In the language of the longest words, beside four views.
    void panelsAreAsWideAsTheirWords()
    {
        openExample("bracket.step", 10);
        action("fourViews")->trigger();
        Preferences other = readPreferences();
        other.language = "de";
        m_window->features().preferences->set(other);
        document().addTool(ToolKind::box);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        const auto look = [this](const char* what) {
            drawn();
            picture(what);
            QStringList cut;
            for (const QScrollArea* area : m_window->findChildren<QScrollArea*>())
                if (area->isVisible() && area->widget()->minimumSizeHint().width() > area->viewport()->width())
                    cut << area->widget()->objectName() + QStringLiteral(" %1 in %2")
                                                              .arg(area->widget()->minimumSizeHint().width())
                                                              .arg(area->viewport()->width());
            QVERIFY2(cut.isEmpty(), qPrintable(what + (": " + cut.join(", "))));
        };
        for (const Selection& one : {Selection{Selection::Kind::Tool, snapshot().tools[0].id},
                                     Selection{Selection::Kind::Body, 0}, Selection{}}) {
            document().select(one);
            look(qPrintable(QStringLiteral("panel-de-%1").arg(int(one.kind))));
        }
        for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            look(qPrintable("panel-de-" + dock->objectName()));
        }
        speak("en");
    }

    void wordsOfPanelsAreNeverCut_data()
    {
        QTest::addColumn<QString>("code");
        QTest::addColumn<QSize>("size");
        for (const Language& language : languages())
            QTest::addRow("%s, 1280", language.code) << QString(language.code) << QSize(1280, 800);
        QTest::addRow("de, 1920") << QString("de") << QSize(1920, 1080); // the longest words, where docks are wider
    }

    void examplesOpenWithoutWarnings_data()
    {
        QTest::addColumn<QString>("file");
        for (const char* name : {"bar", "bracket", "grip", "handle", "lump", "paper-bar", "plate"})
            QTest::newRow(name) << QString(name) + ".step";
    }

    /// What a person sees first is no list of what is wrong.
    void examplesOpenWithoutWarnings()
    {
        QFETCH(QString, file);
        m_window->open(QStringList(example(qPrintable(file))));
        waitForTasks();
        QVERIFY2(m_window->banner().sentence().isEmpty(), qPrintable(m_window->banner().sentence()));
        QVERIFY(!m_window->findChild<LogPanel*>()->toPlainText().contains("Warning"));
        for (BodyId body = 0; body < document().content().bodies.size(); ++body) {
            document().select({Selection::Kind::Body, body});
            drawn();
            for (const QLabel* label : m_window->findChildren<QLabel*>())
                QVERIFY2(!label->isVisible() || label->property("role") != "slow", qPrintable(label->text()));
        }
        picture(qPrintable("example-" + file.chopped(5)));
    }

    /// With all that panels can show, at the width that they have when the window opens.
    void wordsOfPanelsAreNeverCut()
    {
        QFETCH(QString, code);
        QFETCH(QSize, size);
        QSettings().setValue("language", code);
        show(m_services);
        m_window->resize(size);
        QTRY_COMPARE(m_window->size(), size);
        openExample("bracket.step", 10);
        for (const ToolKind kind : {ToolKind::box, ToolKind::cylinder})
            document().addTool(kind);
        QTest::keyClick(m_window.get(), Qt::Key_2);
        click(faceTowardsTheEye().first);
        QTRY_VERIFY(!document().selected().region().isEmpty());
        document().fixRegion(document().selected().region());
        QTRY_VERIFY(!snapshot().fixtures.empty());
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{2});
        for (const char* name : {"section", "compare"})
            action(name)->setChecked(true);
        action("color-strain")->trigger();
        drawn(); // numbers for a range
        action("automaticRange")->trigger();
        action("measureMass")->trigger();
        click(faceTowardsTheEye().first);
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        action("play")->trigger();
        QTRY_VERIFY(snapshot().time > 0.01);
        action("play")->trigger();
        QStringList cut;
        const auto look = [&](const QDockWidget& dock, const char* what) {
            drawn();
            picture(qPrintable(code + QString::number(size.width()) + what + dock.objectName()));
            for (const QString& text : cutTextsIn(*m_window))
                if (const QString line = dock.objectName() + what + ": " + text; !cut.contains(line))
                    cut << line;
        };
        auto* properties = find<QDockWidget>("propertiesDock");
        const std::vector<Selection> ones{{Selection::Kind::Region},
                                          {Selection::Kind::Tool, snapshot().tools[0].id},
                                          {Selection::Kind::Tool, snapshot().tools[1].id},
                                          {Selection::Kind::Body, 0},
                                          {Selection::Kind::Fixture, document().fixtures().list().front().key},
                                          {}};
        for (const Selection& one : ones) {
            if (one.kind != Selection::Kind::Region)
                document().select(one);
            look(*properties, qPrintable(QStringLiteral("-%1-").arg(int(one.kind))));
        }
        for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            look(*dock, "-");
        }
        for (const QTabBar* tabs : m_window->findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
            cutTexts::lookAt(*tabs, cut);
        action("compareWithOriginal")->trigger();
        QTRY_VERIFY(m_window->findChild<QDialog*>("comparisonDialog"));
        picture(qPrintable(code + QString::number(size.width()) + "compare"));
        cut << cutTextsIn(*find<QDialog>("comparisonDialog"));
        auto* table = find<QTreeWidget>("comparison");
        if (table->header()->length() > table->viewport()->width())
            cut << QStringLiteral("comparison: columns of %1 in %2")
                       .arg(table->header()->length())
                       .arg(table->viewport()->width());
        speak("en");
        QVERIFY2(cut.isEmpty(), qPrintable("\n" + cut.join('\n')));
    }

    /// In the language of the longest words, with all that can be said at once.
    void theStatusBarIsNeverCut()
    {
        QSettings().setValue("language", "de");
        show(m_services);
        openExample("bar.step", 10);
        QTest::keyClick(m_window.get(), Qt::Key_2);
        click(faceTowardsTheEye().first);
        QTRY_VERIFY(!document().selected().region().isEmpty());
        auto* readings = find<StatusReadings>("statusReadings");
        Snapshot busy = snapshot();
        busy.playing = true;
        busy.ratio = 0.012;
        busy.updatesPerSecond = 60;
        busy.stepsPerFrame = 1234;
        busy.objects = 123'456;
        busy.connections = 1'234'567;
        busy.contacts = 23'456;
        busy.broken = 12'345;
        busy.components = 12;
        for (const int width : {1100, 1280, 1920, 2600}) {
            m_window->resize(width, 800);
            QTRY_COMPARE(m_window->width(), width);
            drawn();
            readings->show(busy);
            // Laid out, but nothing else: the simulation would show what it really does.
            QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
            for (QLabel* label : find<QLabel>("navigationHint")->parentWidget()->findChildren<QLabel*>())
                if (label->isVisible() && !label->text().isEmpty()) {
                    const QRect place(label->mapTo(m_window.get(), QPoint()), label->size());
                    QVERIFY2(label->width() >= label->sizeHint().width() && m_window->rect().contains(place),
                             qPrintable(QStringLiteral("%1: %2").arg(width).arg(label->text())));
                }
            QVERIFY(find<QLabel>("ratio")->isVisible());
            QCOMPARE(find<QLabel>("units")->isVisible(), width >= 1920);
            picture(qPrintable(QStringLiteral("status-%1").arg(width)));
        }
        speak("en");
    }

    void whatIsSelectedCanBeRead()
    {
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            m_window->features().preferences->setTheme(theme);
            const QPalette colors = QApplication::palette();
            const double contrast =
                contrastOf(colors.color(QPalette::Highlight), colors.color(QPalette::HighlightedText));
            QVERIFY2(contrast > 4.5, qPrintable(QString::number(contrast)));
        }
    }

    /// Of a screen with twice as many pixels lines take twice as many.
    void linesAreAsWideOnFineScreens()
    {
        openExample("bracket.step", 10);
        document().select({});
        action("grid")->setChecked(false);
        QTest::mouseMove(&view(), QPoint(5, view().height() - 5));
        drawn();
        const int usual = darkPixels(view().grabFramebuffer());
        view().renderWindow()->SetDPI(2 * view().renderWindow()->GetDPI());
        view().requestRender();
        drawn();
        const int wide = darkPixels(view().grabFramebuffer());
        QVERIFY2(usual > 200 && wide > 1.5 * usual, qPrintable(QStringLiteral("%1, %2").arg(usual).arg(wide)));
    }

    void picturesOfPartsAreWithoutTheCube()
    {
        for (const char* name : {"bar", "bracket", "grip", "handle", "lump", "plate"})
            QVERIFY2(!hasCube(QImage(example(qPrintable(QString(name) + ".png")))), name);
        openExample("bracket.step");
        QVERIFY(hasCube(view().grabFramebuffer()));
        const QImage portrait = view().portrait();
        QVERIFY(!hasCube(portrait));
        savePicture(portrait, "bracket");
        drawn();
        QVERIFY2(hasCube(view().grabFramebuffer()), "the view keeps it");
        QTest::qWait(2500); // a picture is taken
        QVERIFY(!hasCube(thumbnails::of(example("bracket.step"))));
    }

    void theSpeedIsSaidInWordsThatAreTrue()
    {
        QCOMPARE(ratioText(0.94), QString("0.94x real time"));
        QCOMPARE(ratioText(1), QString("1.00x real time"));
        QCOMPARE(ratioText(0.04), QString("0.040x real time"));
        QCOMPARE(ratioText(0.0004), QString("<0.001x real time"));
        QCOMPARE(ratioText(0), QString("0.000x real time"));
        openExample("bar.step", 10);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(snapshot().playing && find<QLabel>("ratio")->text() != "Paused");
        QVERIFY2(find<QLabel>("ratio")->text().endsWith("x real time"), qPrintable(find<QLabel>("ratio")->text()));
        QTest::keyClick(m_window.get(), Qt::Key_Space);
    }

private:
    ViewportWidget& view() { return m_window->viewport(); }

    /// The middle of the largest triangle that is seen, and its face.
    std::pair<Vec3, std::uint32_t> faceTowardsTheEye()
    {
        const Part& part = document().content().model->parts[0];
        const Vec3 eye = view().camera().towardsEye();
        std::pair<Vec3, std::uint32_t> found;
        double most = 0;
        for (std::size_t t = 0; t < part.mesh.triangles.size(); ++t) {
            const auto& [a, b, c] = part.mesh.triangles[t];
            const std::vector<Vec3>& v = part.mesh.vertices;
            const double area = (v[b] - v[a]).cross(v[c] - v[a]).dot(eye);
            const Vec3 middle = (v[a] + v[b] + v[c]) / 3;
            const std::uint32_t face = part.mesh.faceOfTriangle[t];
            const PickHit hit = view().hitAt(*view().widgetPosition(middle));
            if (area > most && hit.kind == PickHit::Kind::Body && hit.face == face) {
                most = area;
                found = {middle, face};
            }
        }
        return found;
    }

    Color colorAt(const Vec3& place)
    {
        const QImage seen = view().grabFramebuffer();
        const QColor color = seen.pixelColor((*view().widgetPosition(place) * seen.devicePixelRatio()).toPoint());
        return {color.redF(), color.greenF(), color.blueF()};
    }

    /// Where the material is in the view.
    QRect seenPart()
    {
        QRectF all;
        for (const Vec3& vertex : document().frame()->bodies[0]->places) {
            const QPointF place = *view().widgetPosition(vertex);
            all |= QRectF(place, QSizeF(0.01, 0.01));
        }
        return all.toAlignedRect();
    }

    /// The upper right corner is background where there is no cube: it changes from top to bottom only.
    static bool hasCube(const QImage& image)
    {
        const int width = image.width() / 4;
        for (int y = 2; y < image.height() / 5; ++y)
            for (int x = image.width() - width; x < image.width() - 2; ++x)
                if (std::abs(qGray(image.pixel(x, y)) - qGray(image.pixel(image.width() - width, y))) > 12)
                    return true;
        return false;
    }

    /// Of edges, beside the cube.
    static int darkPixels(const QImage& image)
    {
        int count = 0;
        for (int y = image.height() / 5; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += qGray(image.pixel(x, y)) < 60 ? 1 : 0;
        return count;
    }

    static void savePicture(const QImage& image, const char* name)
    {
        if (const QString folder = qEnvironmentVariable("KNEAD_PICTURES"); !folder.isEmpty())
            image.save(QDir(folder).filePath(QString("portrait-") + name + ".png"));
    }

    static QString textOf(const QWidget& widget)
    {
        const auto* label = qobject_cast<const QLabel*>(&widget);
        return label != nullptr ? label->text() : QString();
    }

    /// What is laid out in a panel: not the insides of fields, lists and scroll bars.
    static bool isRow(const QWidget& widget, const QDockWidget& dock)
    {
        if (widget.isHidden() || !widget.isVisibleTo(dock.widget()) || widget.size().isEmpty() || widget.isWindow())
            return false;
        if (qobject_cast<const QAbstractScrollArea*>(&widget) != nullptr ||
            qobject_cast<const QScrollBar*>(&widget) != nullptr)
            return false;
        for (const QWidget* owner = widget.parentWidget(); owner != dock.widget(); owner = owner->parentWidget()) {
            if (owner == nullptr)
                return false;
            if (qobject_cast<const QComboBox*>(owner) != nullptr || owner->inherits("QLineEdit") ||
                owner->inherits("QSpinBox") || owner->inherits("QAbstractItemView") ||
                owner->inherits("QPlainTextEdit") || owner->inherits("QTextEdit"))
                return false;
        }
        return widget.findChild<QWidget*>(QString(), Qt::FindDirectChildrenOnly) == nullptr;
    }

    /// After the areas around it are scrolled as far as they go. All of its height, if the area is as high.
    static bool canBeSeen(QWidget& widget)
    {
        for (QWidget* owner = widget.parentWidget(); owner != nullptr; owner = owner->parentWidget())
            if (auto* area = qobject_cast<QScrollArea*>(owner))
                area->verticalScrollBar()->setValue(widget.mapTo(area->widget(), QPoint()).y() - 4);
        const QRect seen = widget.visibleRegion().boundingRect();
        return seen.height() >= std::min(widget.height(), 40) - 1 && seen.width() >= std::min(widget.width(), 40) - 1;
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowReadableTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_readable_test.moc"
