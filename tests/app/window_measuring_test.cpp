#include "core/session/comparison.h"
#include "support/window_on_test.h"
#include "ui/dialogs/comparison_dialog.h"
#include "ui/measuring/measurement_words.h"
#include "ui/measuring/measuring.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/probe_panel.h"
#include "ui/probes/probe_set.h"
#include "ui/run_window.h"

#include <QClipboard>
#include <QDockWidget>
#include <QToolButton>
#include <QTreeWidget>

#include <cmath>
#include <numbers>

using namespace knead;

namespace {

constexpr double mm = 1e-3; // [m]

Vec3 at(double x, double y, double z)
{
    return mm * Vec3(x, y, z);
}

} // namespace

/// Measuring as a person does it, with the mouse; numbers are those of the drawings of the examples.
class WindowMeasuringTest : public QObject, WindowOnTest {
    Q_OBJECT

    void measure(const char* name, const std::vector<Vec3>& places)
    {
        const std::size_t before = m_window->measuring().list().all().size();
        if (!action(name)->isChecked())
            action(name)->trigger();
        QVERIFY(action(name)->isChecked());
        for (const Vec3& place : places)
            click(place);
        QCOMPARE(m_window->measuring().list().all().size(), before + 1);
    }

    const Measured& last() { return m_window->measuring().panel().results().back(); }
    QString remark() { return remarkOn(last()); }
    double value(std::size_t reading) { return last().readings.at(reading).now; }
    void compare(double found, double wanted, double relative)
    {
        QVERIFY2(std::abs(found - wanted) <= relative * std::abs(wanted),
                 qPrintable(QString("%1 instead of %2").arg(found).arg(wanted)));
    }

    QToolButton* button(const char* name) { return find<QToolButton>(name); }

    /// A bar held at its left end that sags under little gravity, until it stands still.
    void sag()
    {
        openExample("bar.step", 48);
        Material material;
        material.density = 600;
        material.youngsModulus = 2e5;
        material.shapeDamping = 40;
        document().post(SetMaterial{0, material});
        document().post(SetFloor{});
        for (std::uint32_t face = 0; face < 6; ++face) { // the face in x = 0
            const FilledBody& body = *document().content().bodies[0];
            bool isEnd = true;
            for (std::size_t t = 0; t < body.mesh.triangles.size(); ++t)
                if (body.mesh.faceOfTriangle[t] == face)
                    for (const std::uint32_t v : body.mesh.triangles[t])
                        isEnd = isEnd && std::abs(body.mesh.vertices[v].x()) < 1e-9;
            if (isEnd)
                document().toggleFace(0, face);
        }
        document().post(SetGravity{Vec3(0, 0, -0.5)});
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 1.2, patience);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { show(m_services); }
    void cleanup() { m_window.reset(); }

    void nothingCanBeMeasuredWithoutAPart()
    {
        for (const MeasureLook& look : measureLooks())
            QVERIFY(!action(look.name)->isEnabled());
        QVERIFY(!action("compareWithOriginal")->isEnabled());
        openExample("bracket.step");
        for (const MeasureLook& look : measureLooks()) {
            QVERIFY(action(look.name)->isEnabled());
            QVERIFY(!action(look.name)->toolTip().isEmpty());
        }
    }

    void distancesOfTheBracketAreThoseOfItsDrawing()
    {
        openAndRefill("bracket.step", 16);
        QTest::keyClick(m_window.get(), Qt::Key_M);
        QVERIFY(action("measureDistance")->isChecked());
        measure("measureDistance", {at(0, 0, 0), at(58, 0, 0)});
        compare(value(0), 58 * mm, 1e-6);
        compare(value(1), 58 * mm, 1e-6);
        QVERIFY(value(3) < 1e-9);
        measure("measureDistance", {at(8, 0, 48), at(58, 0, 8)});
        compare(value(0), std::hypot(50, 40) * mm, 1e-6);
        measure("measureDistanceToFace", {at(8, 0, 48), at(45, 30, 8)});
        compare(value(0), std::hypot(6, 40) * mm, 1e-6); // the fillet takes 6 mm of the face
        picture("measure-distance");
        QCOMPARE(document().selection().kind, Selection::Kind::Body);           // clicks went nowhere else
        QCOMPARE(document().history().tree().records().size(), std::size_t{2}); // opened and filled
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(!action("measureDistanceToFace")->isChecked());
        QVERIFY(!m_window->measuring().tool().isPicking());
    }

    void anglesAndRadiiOfTheBracketAreThoseOfItsDrawing()
    {
        openExample("bracket.step");
        measure("measureAngle", {at(8, 0, 48), at(0, 0, 48), at(0, 0, 0)});
        compare(value(0), std::numbers::pi / 2, 1e-6);
        measure("measureAngleOfFaces", {at(45, 25, 8), at(8, 8, 40)});
        compare(value(0), std::numbers::pi / 2, 1e-6);
        QVERIFY(remark().isEmpty());
        measure("measureRadiusOfFace", {at(52 - 4.5 * std::numbers::sqrt2 / 2, 14 + 4.5 * std::numbers::sqrt2 / 2, 6)});
        compare(value(0), 4.5 * mm, 1e-4);
        compare(value(1), 9 * mm, 1e-4);
        measure("measureRadiusOfFace", {at(10.5, 25, 46)}); // the bushing
        compare(value(0), 10 * mm, 1e-4);
        const double corner = 12 * (1 - std::numbers::sqrt2 / 2);
        measure("measureRadius", {at(58, 0, 8), at(70 - corner, corner, 8), at(70, 12, 8)});
        compare(value(0), 12 * mm, 0.1); // the middle one is where the mouse was
        picture("measure-radius");
        measure("measureRadiusOfFace", {at(45, 25, 8)});
        QVERIFY(last().readings.empty());
        QVERIFY(remark().contains("flat"));
        measure("measureAngleOfFaces", {at(45, 25, 8), at(10.5, 25, 46)});
        QVERIFY2(remark().startsWith("The face is not flat: it is up to "), qPrintable(remark()));
        measure("measureRadius", {at(58, 0, 8), at(58, 0, 8), at(58, 0, 8)});
        QVERIFY(last().readings.empty());
        QCOMPARE(remark(), QString("The three places lie on a line: pick others, further around."));
    }

    void sizeVolumeAndMassOfTheBracketAreThoseOfItsDrawing()
    {
        openExample("bracket.step");
        const double pi = std::numbers::pi;
        measure("measureBox", {at(45, 25, 8)});
        compare(value(0), 70 * mm, 1e-9);
        compare(value(1), 50 * mm, 1e-9);
        compare(value(2), 60 * mm, 1e-9);
        measure("measureMass", {at(45, 25, 8)});
        const double volume = 70 * 50 * 8 + 8 * 50 * 52                    // plates
                              + 36 * (1 - pi / 4) * 50                     // inner corner
                              - 4 * 144 * (1 - pi / 4) * 8                 // outer corners
                              - 2 * pi * 4.5 * 4.5 * 8 - pi * 10 * 10 * 8; // holes
        compare(value(0), volume * 1e-9, 1e-6);
        compare(value(1), 600 * volume * 1e-9, 1e-6); // sponge rubber
        compare(value(3), 25 * mm, 1e-6);             // it is as wide to the left as to the right
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        picture("measure-mass");
    }

    void marksFollowABarThatSagsAsBeamsDo()
    {
        sag();
        measure("measurePoint", {document().frame()->bodies[0]->places[farCorner()]});
        const double gravity = 0.5;
        const double sagging = 12 * 600 * gravity * std::pow(0.16, 4) / (8 * 2e5 * 0.02 * 0.02); // q L^4 / 8 E I
        compare(value(0), sagging, 0.12); // of a lattice with six cells across
        const Vec3 moved = document().frame()->bodies[0]->places[farCorner()] -
                           document().content().bodies[0]->mesh.vertices[farCorner()];
        compare(value(0), moved.norm(), 1e-6);
        measure("measureMass", {document().frame()->bodies[0]->places[farCorner()] + at(-40, 8, 0)});
        compare(last().readings[0].rest, 64e-6, 1e-9);
        compare(value(0), 64e-6, 0.01); // bending keeps the volume
        compare(value(1), 0.0384, 1e-9);
        QVERIFY(value(4) < last().readings[4].rest - 0.3 * sagging);
        action("measureMass")->trigger();
        QVERIFY(!m_window->measuring().tool().isPicking());
        auto* rows = find<QTreeWidget>("measurements");
        QTest::mouseClick(rows->viewport(), Qt::LeftButton, {}, showMeOf(*rows, *rows->topLevelItem(0)));
        QVERIFY(looksAt(m_window->measuring().panel().results()[0].mark.points.front()));
        picture("measure-sag");

        // Reset: everything is as it was.
        action("reset")->trigger();
        QTRY_VERIFY(std::abs(m_window->measuring().panel().results()[0].readings[0].now) < 1e-9);
    }

    void theOriginalIsComparedAndReported()
    {
        sag();
        measure("measurePoint", {document().frame()->bodies[0]->places[farCorner()]});
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        action("compareWithOriginal")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(find<QDialog>("comparisonDialog") != nullptr, patience);
        auto* table = find<QTreeWidget>("comparison");
        QCOMPARE(table->topLevelItemCount(), 1);
        picture("compare");
        TaskControl& control = TaskControl::none();
        const Comparison comparison =
            compareWithOriginal(document().content(), *document().frame(), snapshot(), control);
        const BodyComparison& bar = comparison.bodies[0];
        const Vec3 moved = document().frame()->bodies[0]->places[farCorner()] -
                           document().content().bodies[0]->mesh.vertices[farCorner()];
        compare(bar.largestDisplacement, moved.norm(), 0.01);
        QVERIFY(bar.largestDistance <= bar.largestDisplacement && bar.meanDistance < bar.largestDistance);
        compare(bar.largestDistance, std::abs(moved.z()), 0.02); // the tip is below the end of the original
        // Top and bottom are 0.4 of it away in the mean; the other sides slide within their planes.
        QVERIFY(bar.meanDistance > 0.1 * bar.largestDistance);
        // The view flies to where it is farthest, by the mouse and by keys.
        auto* shown = find<MarksOverlay>("shownPlace");
        for (const bool byKeys : {false, true}) {
            Camera elsewhere;
            elsewhere.target = Vec3(1, 1, 1);
            m_window->viewport().jumpTo(elsewhere);
            QVERIFY(!looksAt(bar.farthest));
            QTreeWidgetItem* row = table->topLevelItem(0);
            if (byKeys) {
                table->setCurrentItem(row);
                QTest::keyClick(table, Qt::Key_Return);
            } else {
                QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, showMeOf(*table, *row));
            }
            QVERIFY2(looksAt(bar.farthest), byKeys ? "by keys" : "by the mouse");
            QVERIFY(shown->isVisible());
            QCOMPARE(shown->marks().front().mark.points.front(), bar.farthest);
        }
        picture("compare-shown");
        find<QDialog>("comparisonDialog")->activateWindow(); // there may be no window manager that does it
        QTRY_VERIFY(find<QDialog>("comparisonDialog")->isActiveWindow());
        QTest::keyClick(find<QDialog>("comparisonDialog"), Qt::Key_Escape);
        QTRY_VERIFY(find<QDialog>("comparisonDialog") == nullptr);

        const QTemporaryDir folder;
        for (const char* name : {"report.html", "report.pdf"}) {
            m_window->features().comparison->write(folder.filePath(name), comparison);
            QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        }
        QFile html(folder.filePath("report.html"));
        QVERIFY(html.open(QFile::ReadOnly));
        const QString text = QString::fromUtf8(html.readAll());
        QVERIFY(text.contains("bar.step") && text.contains("data:image/png") && text.contains("Largest distance"));
        QVERIFY(text.contains("Point 1"));
        QVERIFY(text.contains(formatReading(bar.largestDistance, Quantity::Length)));
        QFile pdf(folder.filePath("report.pdf"));
        QVERIFY(pdf.open(QFile::ReadOnly));
        QVERIFY(pdf.read(5) == "%PDF-");
        QVERIFY(pdf.size() > 20'000); // with its picture
        if (const QString pictures = qEnvironmentVariable("KNEAD_PICTURES"); !pictures.isEmpty())
            for (const char* name : {"report.html", "report.pdf"})
                QFile::copy(folder.filePath(name), QDir(pictures).filePath(name));

        // A place that cannot be written to: a sentence, and nothing is left there.
        m_window->features().comparison->write(folder.filePath("none/report.pdf"), comparison);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QCOMPARE(m_window->banner().sentence(),
                 QString("report.pdf: the file cannot be written (No such file or directory); choose another place or "
                         "make room."));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 2);
    }

    void whatWasMeasuredIsCopiedWrittenAndDeleted()
    {
        openExample("bar.step");
        measure("measureDistance", {at(0, 0, 0), at(160, 0, 0)});
        measure("measureBox", {at(80, 0, 10)});
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(find<QDockWidget>("measureDock")->isVisible());
        QTest::mouseClick(button("measureCopy"), Qt::LeftButton);
        const QString copied = QApplication::clipboard()->text();
        QVERIFY2(copied.contains("Distance 1\tDistance\t160 mm\t160 mm"), qPrintable(copied));
        const QTemporaryDir folder;
        m_window->features().measuring->write(folder.filePath("all.csv"));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QFile file(folder.filePath("all.csv"));
        QVERIFY(file.open(QFile::ReadOnly));
        const QStringList lines = QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 1 + 4 + 3);
        QCOMPARE(lines[0], QString("Measurement,Reading,Unit,Now,At rest,Change"));
        QCOMPARE(lines[1], QString("\"Distance 1\",\"Distance\",mm,160,160,0"));

        auto* rows = find<QTreeWidget>("measurements");
        QCOMPARE(rows->topLevelItemCount(), 2);
        rows->setFocus();
        rows->setCurrentItem(rows->topLevelItem(0));
        QTest::keyClick(rows, Qt::Key_Delete);
        QCOMPARE(rows->topLevelItemCount(), 1);
        QCOMPARE(rows->topLevelItem(0)->text(0), QString("Bounding box 1"));

        // Filled anew the body keeps what was measured; another document has nothing.
        m_window->features().imports->refill(document().size() / 12);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QCOMPARE(m_window->measuring().list().all().size(), std::size_t{1});
        openExample("bracket.step");
        QCOMPARE(m_window->measuring().list().all().size(), std::size_t{0});
    }

    void aComparisonGoesWithItsPart()
    {
        openExample("bar.step");
        action("compareWithOriginal")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(find<QDialog>("comparisonDialog") != nullptr, patience);
        find<QDialog>("comparisonDialog")->activateWindow(); // there may be no window manager that does it
        QTRY_VERIFY(find<QDialog>("comparisonDialog")->isActiveWindow());
        QTest::keyClick(find<QDialog>("comparisonDialog"), Qt::Key_Escape);
        QTRY_VERIFY(find<QDialog>("comparisonDialog") == nullptr);
        m_window->activateWindow();
        action("compareWithOriginal")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(find<QDialog>("comparisonDialog") != nullptr, patience);
        openExample("bracket.step");
        QTRY_VERIFY(find<QDialog>("comparisonDialog") == nullptr);
    }

    /// Places of the one before are not looked for on the new one, which has fewer triangles.
    void anotherPartIsOpenedWhileOneMeasures()
    {
        openExample("bracket.step", 40);
        const FilledBody& bracket = *document().content().bodies[0];
        const SkinPlace last{0, static_cast<std::uint32_t>(bracket.mesh.triangles.size() - 1), Vec3(1, 0, 0)};
        m_window->probes().add(last);
        action("measureDistance")->trigger();
        m_window->measuring().list().add(MeasureKind::point, {last});
        const Vec3 place = placeOf(last, bracket, document().frame()->bodies[0]->places);
        click(place);
        QTest::mouseMove(&m_window->viewport(), m_window->viewport().rect().center());
        openExample("bar.step", 8);
        QVERIFY(document().content().bodies[0]->mesh.triangles.size() <= last.triangle);
        QVERIFY(!m_window->measuring().tool().isPicking());
        QVERIFY(m_window->measuring().list().all().empty());
        QVERIFY(m_window->probes().all().empty());
        QVERIFY(m_window->measuring().overlay().marks().empty());
    }

    void oneModeOfTheMouseAtATime()
    {
        openExample("bar.step");
        action("measurePoint")->trigger();
        action("pull")->trigger();
        QVERIFY(!action("measurePoint")->isChecked() && action("pull")->isChecked());
        action("measurePoint")->trigger();
        QVERIFY(action("measurePoint")->isChecked() && !action("pull")->isChecked());
        action("fixFaces")->trigger();
        QVERIFY(!action("measurePoint")->isChecked() && action("fixFaces")->isChecked());
        action("placeProbe")->trigger();
        QVERIFY(action("placeProbe")->isChecked() && !action("fixFaces")->isChecked());
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(!action("placeProbe")->isChecked());
    }

    void whatIsHiddenOrCutOffIsNotMeasured()
    {
        openExample("bar.step");
        measure("measurePoint", {at(160, 0, 0)});
        QCOMPARE(m_window->measuring().overlay().marks().size(), std::size_t{2}); // with that in the making
        SceneOptions options = m_window->viewport().options();
        options.hiddenParts = {0};
        m_window->viewport().setOptions(options);
        QVERIFY(m_window->measuring().overlay().marks().size() < 2);
        click(at(160, 0, 0));
        QCOMPARE(m_window->measuring().list().all().size(), std::size_t{1});

        options.hiddenParts.clear();
        options.section.plane = CutPlane{Vec3::UnitX(), 0.08}; // the far half is gone
        m_window->viewport().setOptions(options);
        click(at(160, 0, 0));
        QCOMPARE(m_window->measuring().list().all().size(), std::size_t{1});
        click(at(0, 0, 0));
        QCOMPARE(m_window->measuring().list().all().size(), std::size_t{2});
    }

    void namesFollowTheLanguage()
    {
        openExample("bar.step");
        m_window->probes().add({0, 0, Vec3(1, 0, 0)});
        measure("measureDistance", {at(0, 0, 0), at(160, 0, 0)});
        Preferences chosen = readPreferences();
        for (const char* code : {"de", "en"}) {
            chosen.language = code;
            m_window->features().preferences->set(chosen);
            QTRY_COMPARE(find<QTreeWidget>("measurements")->topLevelItem(0)->text(0),
                         nameOf(m_window->measuring().list().all()[0]));
            QCOMPARE(find<QTreeWidget>("probes")->topLevelItem(0)->text(0), ProbePanel::tr("Probe %1").arg(1));
            QVERIFY(m_window->measuring().tool().prompt().startsWith(action("measureDistance")->text()));
        }
    }

    void aClickBesideThePartIsASentence()
    {
        openExample("bar.step");
        action("measurePoint")->trigger();
        ViewportWidget& view = m_window->viewport();
        QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(30, view.height() - 30));
        QVERIFY(m_window->banner().sentence().contains("click on a part"));
        click(at(160, 0, 0));
        QCOMPARE(m_window->measuring().list().all().size(), std::size_t{1});
        QVERIFY2(problem().isEmpty(), qPrintable(problem()));
    }

    void facesOfAMeshAreRefusedInASentence()
    {
        openExample("bar.step");
        const QTemporaryDir folder;
        m_window->features().exports->exportTo(folder.filePath("bar.stl"));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        m_window->open(QStringList(folder.filePath("bar.stl")));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        rest();
        action("measureRadiusOfFace")->trigger();
        const FilledBody& body = *document().content().bodies[0];
        Box box;
        for (const Vec3& vertex : body.mesh.vertices)
            box.extend(vertex);
        click(Vec3(box.center().x(), box.min().y(), box.center().z()));
        QVERIFY2(m_window->banner().sentence().contains("without CAD faces"),
                 qPrintable(m_window->banner().sentence()));
    }

private:
    /// Vertex of the bar at (160, 0, 20) mm.
    std::uint32_t farCorner()
    {
        const auto& vertices = document().content().bodies[0]->mesh.vertices;
        for (std::uint32_t v = 0; v < vertices.size(); ++v)
            if ((vertices[v] - at(160, 0, 20)).norm() < 1e-9)
                return v;
        return 0;
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowMeasuringTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_measuring_test.moc"
