#include "core/session/comparison.h"
#include "support/views_on_test.h"
#include "ui/dialogs/comparison_dialog.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/materials/material_swatch.h"
#include "ui/measuring/marks_overlay.h"
#include "ui/panels/export_panel.h"
#include "ui/panels/timeline_axis.h"
#include "ui/run_window.h"
#include "ui/viewport/scene_style.h"
#include "ui/viewport/side_view.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QSettings>
#include <QTextLayout>
#include <QTreeWidget>

#include <algorithm>

using namespace knead;

/// What people saw in pictures of the window and did not like: it does not come back.
class WindowAppearanceTest : public QObject, ViewsOnTest {
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
        choosePreferences(Eyes::open);
        show(m_services);
    }

    void cleanup() { m_window.reset(); }

    void sentencesOfTheExportReportAreWhole()
    {
        ExportReport report;
        report.file = "bracket.step";
        report.warnings = {Message::verbatim(wordsOf(60))};
        PartExportReport part;
        part.name = "Bracket";
        part.reason = Message::verbatim(wordsOf(50));
        report.parts = {part};
        ExportPanel panel;
        panel.show({report});
        auto* tree = panel.findChild<QTreeWidget*>("exportedParts");
        for (const int width : {1900, 940, 500, 1200}) { // wider again: lower again
            panel.resize(width, 400);
            panel.setVisible(true);
            QTest::qWait(50);
            const QTreeWidgetItem* sentences[] = {tree->topLevelItem(0)->child(0), tree->topLevelItem(1)};
            for (const QTreeWidgetItem* sentence : sentences) {
                const QRect row = tree->visualItemRect(sentence);
                const int room = std::max(tree->viewport()->width(), tree->header()->length()) - row.left();
                const int lines = linesOf(sentence->text(0), tree->font(), room - 30);
                const int lineHeight = QFontMetrics(tree->font()).lineSpacing();
                QVERIFY2(
                    row.height() >= lines * lineHeight && row.height() < (lines + 2) * lineHeight,
                    qPrintable(QStringLiteral("%1 high for %2 lines at %3").arg(row.height()).arg(lines).arg(width)));
            }
            if (width == 940)
                keep(panel.grab().toImage(), "export-report");
        }
    }

    /// What is only expected is no reason to worry.
    void theFirstExampleOpensWithoutWarnings()
    {
        openExample("bar.step", 160); // more than machines keep up with
        document().select({Selection::Kind::Body, 0});
        auto* ratio = find<QLabel>("expectedRatio");
        QTRY_VERIFY(ratio->isVisible() && !ratio->text().isEmpty());
        QCOMPARE(ratio->property("role").toString(), QString());
    }

    void oneOrManyPartsAreSaidRight()
    {
        const auto said = [](std::size_t parts, std::size_t sound) { return ExportPanel::verdict(sound, parts); };
        QCOMPARE(said(1, 1), QString("The part is sound."));
        QCOMPARE(said(1, 0), QString("The part is not sound."));
        QCOMPARE(said(3, 3), QString("All parts are sound."));
        QCOMPARE(said(3, 2), QString("One of 3 parts is not sound."));
        QCOMPARE(said(3, 1), QString("2 of 3 parts are not sound."));
    }

    void theExportDialogIsAsHighAsItsWords()
    {
        ExportDialog dialog({}, false, m_window.get());
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        const auto* about = dialog.findChild<QLabel*>("exportAbout");
        QCOMPARE(about->height(), about->heightForWidth(about->width()));
        const int above = about->y() - dialog.findChild<QComboBox*>("exportFormat")->geometry().bottom();
        const int below = dialog.findChild<QComboBox*>("exportParts")->y() - about->geometry().bottom();
        QVERIFY2(above < 16 && below < 16, qPrintable(QStringLiteral("%1, %2").arg(above).arg(below)));
        keep(dialog.grab().toImage(), "export-dialog");
    }

    void theExportDialogGrowsWithTheWordsOfAnotherFormat()
    {
        QSettings().setValue("export/format", "OBJ (.obj)");
        ExportDialog dialog({}, false, m_window.get());
        QSettings().remove("export/format");
        auto* format = dialog.findChild<QComboBox*>("exportFormat");
        QCOMPARE(format->currentText(), QString("OBJ (.obj)"));
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        const auto* about = dialog.findChild<QLabel*>("exportAbout");
        const int fewWords = about->height();
        QTest::keyClicks(format, "STEP");
        QCOMPARE(format->currentText(), QString("STEP (.step)"));
        QTRY_VERIFY(about->height() > fewWords);
        QCOMPARE(about->height(), about->heightForWidth(about->width()));
        QVERIFY(dialog.findChild<QWidget*>("exportAp214")->height() >=
                dialog.findChild<QWidget*>("exportAp214")->sizeHint().height());
    }

    void theComparisonIsAsHighAsItsTable()
    {
        Comparison comparison;
        for (const std::size_t parts : {1U, 5U, 200U}) {
            comparison.bodies.resize(parts);
            for (BodyComparison& body : comparison.bodies) {
                body.name = "Bar";
                body.rest.volume = body.now.volume = 1e-6;
            }
            ComparisonDialog dialog(comparison, m_window.get());
            dialog.show();
            QVERIFY(QTest::qWaitForWindowExposed(&dialog));
            auto* table = dialog.findChild<QTreeWidget*>("comparison");
            const QRect last = table->visualItemRect(table->topLevelItem(table->topLevelItemCount() - 1));
            const int spare = table->viewport()->height() - last.bottom();
            QVERIFY2(parts == 200 ? dialog.height() < 500 : spare >= 0 && spare < 2 * last.height(),
                     qPrintable(QStringLiteral("%1 of %2").arg(spare).arg(dialog.height())));
            QCOMPARE(dialog.focusWidget()->objectName(), QString("writeReport"));
        }
    }

    void whereOneLooksHidesNoNumber()
    {
        TimelineAxis axis([](History::Entry) { return QString(); });
        axis.resize(400, axis.sizeHint().height());
        Timeline timeline;
        timeline.ticks = {{}};
        timeline.present = timeline.end = 1;
        axis.show(timeline);
        const QImage before = axis.grab().toImage();
        axis.lookAt(0.5);
        const QImage after = axis.grab().toImage();
        QVERIFY(before != after);
        const int ruler = qRound(14 * before.devicePixelRatio());
        QCOMPARE(before.copy(0, 0, before.width(), ruler), after.copy(0, 0, after.width(), ruler));
    }

    void swatchesKeepTheirColorWhenSelected()
    {
        const auto isSame = [](const QIcon& icon) {
            return icon.pixmap(32, 32, QIcon::Selected).toImage() == icon.pixmap(32, 32, QIcon::Normal).toImage();
        };
        QVERIFY(isSame(materialSwatch(m_services.materials.front())));
        openExample("bracket.step", 10);
        const auto rows = find<QTreeWidget>("modelTree")->findItems("Bushing", Qt::MatchExactly | Qt::MatchRecursive);
        QCOMPARE(rows.size(), 1);
        QVERIFY(isSame(rows.front()->icon(0)));
    }

    void aSelectedPartStandsOutWhateverItsColor()
    {
        openExample("bracket.step", 10);
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            m_window->features().preferences->setTheme(theme);
            const Color other = (theme == Theme::Light ? lightScene() : darkScene()).selectedOther;
            const auto marked = [&] {
                QTest::mouseMove(&view(), QPoint(5, view().height() - 5));
                drawn();
                return countOf(view().grabFramebuffer(), other);
            };
            document().select({});
            const int before = marked();
            document().select({Selection::Kind::Body, 0});
            keep(view().grabFramebuffer(), theme == Theme::Light ? "selected-part-light" : "selected-part-dark");
            QVERIFY2(marked() > before + 200, "a blue part has yellow edges");
        }
    }

    void theOnlyPartStandsOutWhenSelected()
    {
        openExample("bar.step", 10);
        const auto picture = [&] {
            QTest::mouseMove(&view(), QPoint(5, view().height() - 5));
            QTest::qWait(150);
            return view().grabFramebuffer();
        };
        document().select({Selection::Kind::Body, 0});
        const QImage selected = picture();
        document().select({});
        const QImage plain = picture();
        const SceneStyle style = lightScene();
        const int usual = countOf(selected, style.selectedEdge) - countOf(plain, style.selectedEdge);
        const int other = countOf(selected, style.selectedOther) - countOf(plain, style.selectedOther);
        QVERIFY(std::max(usual, other) > 200);
    }

    /// Of what it marks, the line around it, and not only its fill.
    void aSelectedFaceStandsOutWhenItsPartIsColored()
    {
        openExample("bracket.step", 10);
        const Color other = lightScene().selectedOther;
        const auto marked = [&] {
            QTest::mouseMove(&view(), QPoint(5, view().height() - 5));
            drawn();
            return countOf(view().grabFramebuffer(), other);
        };
        document().selected().setLevel(Level::Face);
        const int before = marked();
        const auto& faces = document().content().bodies[0]->mesh.faceOfTriangle;
        Region::Items every(faces.begin(), faces.end());
        std::ranges::sort(every);
        every.erase(std::ranges::unique(every).begin(), every.end());
        Region::Items half;
        for (std::size_t i = 0; i < every.size(); i += 2) // around all of them there is no line
            half.push_back(every[i]);
        document().selected().select(regionOf(Level::Face, 0, half));
        QVERIFY2(marked() > before + 200, "on a blue part it is yellow");
        for (std::size_t part = 0; part < document().content().model->parts.size(); ++part)
            document().colorPart(part, Color{0.7, 0.7, 0.7});
        const int gray = marked();
        QVERIFY2(gray <= before, qPrintable(QString::number(gray)));
    }

    /// Of a ball in front of the background: beside its rim lie pixels that are partly of both.
    void rimsOfToolsAreSmooth()
    {
        openExample("lump.step", 10);
        action("grid")->setChecked(false);
        document().addTool(ToolKind::ball);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        document().select({});
        QTest::keyClick(m_window.get(), Qt::Key_F);
        QTest::mouseMove(&view(), QPoint(5, view().height() - 5));
        rest();
        const QImage seen = view().grabFramebuffer();
        keep(seen, "ball");
        const double scale = seen.devicePixelRatio();
        const ToolState& ball = snapshot().tools[0];
        const QPointF top =
            scale * *view().widgetPosition(ball.pose.position + ball.size.z() / 2 * view().camera().up());
        const QPointF middle = scale * *view().widgetPosition(ball.pose.position);
        const auto grayAt = [&seen](int x, int y) { return seen.pixelColor(x, y).blueF(); };
        int rows = 0;
        int smooth = 0;
        for (int y = qRound(top.y()) + 3; y < qRound((top.y() + middle.y()) / 2); ++y) {
            const double ground = grayAt(2, y);
            int x = qRound(middle.x());
            while (x > 0 && std::abs(grayAt(x, y) - ground) > 0.9 * std::abs(grayAt(x + 4, y) - ground))
                --x; // out of the ball
            const double within = std::abs(grayAt(x + 3, y) - ground);
            const double at = std::abs(grayAt(x, y) - ground);
            ++rows;
            smooth += at > 0.12 * within && at < 0.88 * within ? 1 : 0;
        }
        QVERIFY2(rows > 10 && smooth > rows / 2, qPrintable(QStringLiteral("%1 of %2").arg(smooth).arg(rows)));
    }

    void forcesAreWrittenBesideTheMiddleOfTheirTool()
    {
        QWidget widget;
        widget.resize(400, 300);
        ForceLabels labels(&widget);
        for (const double tip : {-60.0, 0.0, 60.0}) {
            labels.place({{.place = Vec3(tip, 0, 0), .tool = 1, .force = 2, .middle = Vec3::Zero()}},
                         [](const Vec3& place) { return std::optional(QPointF(200 + place.x(), 150)); });
            const QRect label = widget.findChild<QLabel*>("forceLabel1")->geometry();
            QVERIFY(tip < 0 ? label.right() < 200 + tip : label.left() > 200 + tip);
        }
    }

    void whatIsMeasuredIsMarkedInEachView()
    {
        openExample("bracket.step", 10);
        closeBanner();
        press(Qt::Key_F4, Qt::ShiftModifier);
        QTRY_VERIFY(views().sideView(ViewSlot::front) != nullptr);
        rest();
        SideView& front = *views().sideView(ViewSlot::front);
        QTest::keyClick(m_window.get(), Qt::Key_M);
        QVERIFY(action("measureDistance")->isChecked());
        const Box box = document().content().box;
        const QPoint at = front.widgetPosition({box.center().x(), box.min().y(), box.min().z() + 0.003})->toPoint();
        QTest::mouseMove(&front, at);
        QTest::mouseMove(&front, at + QPoint(1, 0));
        const auto* marks = front.findChild<MarksOverlay*>();
        QVERIFY(marks != nullptr);
        QTRY_COMPARE(marks->marks().size(), std::size_t{1});
        QTRY_COMPARE(marks->marks()[0].mark.points.size(), std::size_t{1});
        const QPointF seen = *front.widgetPosition(marks->marks()[0].mark.points[0]);
        QVERIFY(QLineF(seen, at).length() < 12); // there, or at a corner close by
        picture("measuring-aside");
        QTest::mouseMove(&views().name(ViewSlot::top), QPoint(2, 2)); // out of it
        QTRY_VERIFY(marks->marks().empty() || marks->marks()[0].mark.points.empty());
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QTRY_VERIFY(marks->marks().empty());
    }

    void picturesOfExamplesTakeTheColorsOfTheWindow()
    {
        for (const char* name : {"bar", "bracket", "grip", "handle", "lump", "plate"}) {
            const QImage image(example(qPrintable(QString(name) + ".png")));
            QCOMPARE(image.pixelColor(0, 0).alpha(), 0);
            QCOMPARE(image.pixelColor(image.rect().center()).alpha(), 255);
        }
    }

private:
    static std::string wordsOf(int count)
    {
        std::string words;
        for (int i = 0; i < count; ++i)
            words += "sentence ";
        return words + "ends.";
    }

    static int linesOf(const QString& text, const QFont& font, int width)
    {
        QTextLayout layout(text, font);
        int lines = 0;
        layout.beginLayout();
        for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine(), ++lines)
            line.setLineWidth(width);
        layout.endLayout();
        return lines;
    }

    static int countOf(const QImage& image, const Color& color)
    {
        int count = 0;
        for (int y = image.height() / 6; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QColor seen = image.pixelColor(x, y);
                count += differenceOf({seen.redF(), seen.greenF(), seen.blueF()}, color) < 0.3 ? 1 : 0;
            }
        return count;
    }

    static void keep(const QImage& image, const char* name)
    {
        if (const QString folder = qEnvironmentVariable("KNEAD_PICTURES"); !folder.isEmpty())
            image.save(QDir(folder).filePath(QString("looks-") + name + ".png"));
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowAppearanceTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_appearance_test.moc"
