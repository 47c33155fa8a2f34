#include "core/document/history_replay.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "io/formats/mesh_writer.h"
#include "support/projects_on_test.h"
#include "support/same_values.h"
#include "ui/deforming/deform_feature.h"
#include "ui/measuring/measuring.h"
#include "ui/panels/model_tree.h"
#include "ui/panels/quantity_field.h"
#include "ui/probes/probe_set.h"
#include "ui/run_window.h"
#include "ui/selection/selection_model.h"
#include "ui/theme.h"
#include "ui/viewport/viewport_widget.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

using namespace knead;

/// Parts deformed by numbers and by a field, with mouse and keys.
class WindowDeformTest : public QObject, ProjectsOnTest {
    Q_OBJECT

    static constexpr double cells = 24; // along the bar
    static constexpr double quarter = std::numbers::pi / 2;

    const History& tree() { return document().history().tree(); }
    QString presentName() { return QString::fromStdString(tree().record(tree().current()).name); }
    const Model& model() { return *document().content().model; }
    const Part& bar() { return model().parts.at(0); }

    ModelTree& modelTree() { return *m_window->findChild<ModelTree*>(); }

    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(m_window.get(), key, modifiers); }

    void openBar() { openExample("bar.step", cells); }

    /// Types into a field, as a person does.
    void type(const char* name, const QString& text)
    {
        auto* field = find<QuantityField>(name);
        QVERIFY2(field != nullptr && field->isVisible(), name);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY2(!field->hasProblem(), qPrintable(field->tip()));
    }

    /// Until the view shows what is said.
    void previewed()
    {
        QTRY_VERIFY_WITH_TIMEOUT(m_window->viewport().isLookingBack(), patience);
        QTest::qWait(0);
    }

    Box seenBox()
    {
        Box box;
        for (const auto& body : m_window->viewport().shownFrame()->bodies)
            for (const Vec3& place : body->places)
                box.extend(place);
        return box;
    }

    void begin(const char* name)
    {
        QVERIFY2(action(name)->isEnabled(), name);
        action(name)->trigger();
        QVERIFY(action("deform")->isChecked());
    }

    /// Enter in the view, and until the parts are filled again.
    void apply()
    {
        const std::size_t entries = tree().records().size();
        m_window->viewport().setFocus();
        QTest::keyClick(&m_window->viewport(), Qt::Key_Return);
        QTRY_VERIFY2_WITH_TIMEOUT(tree().records().size() > entries && isIdle(), qPrintable(problem()), patience);
        QVERIFY(!action("deform")->isChecked());
        QVERIFY(!m_window->viewport().isLookingBack());
    }

    /// @param other it is dragged to, in pixels from where it is
    void drag(DeformHandle handle, const QPoint& way)
    {
        ViewportWidget& view = m_window->viewport();
        const auto& frames = m_window->features().deforming->handles().frames();
        QVERIFY(frames.has_value());
        const QPoint from = view.widgetPosition(frames->placeOf(handle))->toPoint();
        QTest::mouseMove(&view, from);
        QTest::mousePress(&view, Qt::LeftButton, {}, from);
        for (const double share : {0.25, 0.5, 0.75, 1.0})
            QTest::mouseMove(&view, from + (share * QPointF(way)).toPoint());
        QTest::mouseRelease(&view, Qt::LeftButton, {}, from + way);
    }

    /// Every file has the same two steps: u = (0, 0, x / 20) at the nodes of a grid around the bar. The first one cannot be read.
    Services servicesWithShear()
    {
        return servicesWith([](const Vec3& node) { return Vec3(0, 0, 0.05 * node.x()); });
    }
    Services servicesWith(const std::function<Vec3(const Vec3& node)>& displacement)
    {
        Services services = m_services;
        services.readField = [displacement](const std::string& path, const FieldChoice& choice, const TriangleMesh&,
                                            TaskControl&) {
            FieldFile read{.path = path, .format = "table", .steps = {"1", "2"}, .names = {"DISP"}, .name = "DISP"};
            read.step = choice.step.value_or(1);
            if (read.step == 0)
                throw Problem(Message::verbatim("The first step is damaged."));
            read.unit = choice.unit.empty() ? "mm" : choice.unit;
            for (int x = 0; x <= 12; ++x)
                for (int y = 0; y <= 4; ++y)
                    for (int z = 0; z <= 4; ++z) {
                        const Vec3 node(0.02 * x - 0.12, 0.015 * y - 0.03, 0.015 * z - 0.03);
                        read.field.nodes.push_back(node);
                        read.field.displacements.push_back(displacement(node));
                    }
            read.warnings.push_back(Message::verbatim("Two nodes were left out."));
            return read;
        };
        return services;
    }

    /// u = (0, 0, x^2 / 1 m), in millimetres, with words above its columns.
    void writeWarp()
    {
        QFile table(file("warp.csv"));
        QVERIFY(table.open(QFile::WriteOnly));
        table.write("x,y,z,dx,dy,dz\n");
        for (int x = 0; x <= 16; ++x)
            for (int y = 0; y <= 2; ++y)
                for (int z = 0; z <= 2; ++z)
                    table.write(qPrintable(
                        QString("%1,%2,%3,0,0,%4\n").arg(10 * x).arg(10 * y).arg(10 * z).arg(0.001 * 100 * x * x)));
        table.close();
    }

    /// As a machine that measures writes it.
    static void writeScan(const TriangleMesh& mesh, const QString& path)
    {
        writeMeshes(path.toStdString(), {MeshBody{"scan", Color{}, refine(mesh, mesh.empty() ? 1 : 0.004)}});
    }

    QByteArray read(const QString& name)
    {
        QFile from(name);
        return from.open(QFile::ReadOnly) ? from.readAll() : QByteArray();
    }

    double value(const char* name) { return find<QuantityField>(name)->value(); }

    void choosePhysics()
    {
        auto* how = find<QComboBox>("deformHow");
        how->setCurrentIndex(1);
        emit how->activated(1);
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare(qEnvironmentVariableIsEmpty("KNEAD_PICTURES") ? Eyes::none : Eyes::open);
    }

    void init() { ProjectsOnTest::begin(); }
    void cleanup() { m_window.reset(); }

    /// A quarter of a circle, by Pappus as much material; undone, redone, saved and read again.
    void aBarIsBentByTypingAnAngle()
    {
        openBar();
        const Box before = document().content().box;
        const double volume = bar().volume;
        const std::size_t faces = bar().faces.size();
        begin("deformBend");
        picture("deform-begun");
        type("deformAngle", "90");
        const double length = before.sizes().x();
        const double radius = length / quarter;
        QVERIFY(std::abs(value("deformRadius") - radius) < 1e-6 * radius);
        previewed();
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(seenBox().sizes().x() - (radius + before.sizes().z() / 2)) < 1e-3 * length,
                                 patience);
        picture("deform-bend");
        apply();
        QCOMPARE(presentName(), QString("Bent by 90\u00B0"));
        const auto isBent = [&] {
            return std::abs(bar().volume / volume - 1) < 1e-3 &&
                   std::abs(bar().box.sizes().x() - (radius + before.sizes().z() / 2)) < 1e-3 * length &&
                   std::abs(bar().box.sizes().z() - (radius + before.sizes().z() / 2)) < 1e-3 * length;
        };
        QVERIFY2(
            isBent(),
            qPrintable(
                QString("%1 %2 %3").arg(bar().volume / volume).arg(bar().box.sizes().x()).arg(bar().box.sizes().z())));
        QVERIFY(bar().faces.size() >= faces && bar().exact && bar().watertight && bar().valid);
        QVERIFY(std::abs(document().content().spacing * cells / length - 1) < 1e-9);
        picture("deform-bent");

        key(Qt::Key_Z, Qt::ControlModifier);
        wait();
        QVERIFY(bar().box.isApprox(before, 1e-6) && bar().volume == volume);
        QCOMPARE(bar().faces.size(), faces);
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        wait();
        QVERIFY(isBent());

        saveTo(file("bent.knead"));
        const std::uint64_t saved = hash();
        newWindow(m_services);
        openProject(file("bent.knead"));
        QVERIFY(isBent() && bar().exact);
        QCOMPARE(hash(), saved);
        QCOMPARE(presentName(), QString("Bent by 90\u00B0"));
        key(Qt::Key_Z, Qt::ControlModifier);
        wait();
        QVERIFY(bar().box.isApprox(before, 1e-6));
    }

    void planesAndAnglesAreDragged()
    {
        openBar();
        rest();
        begin("deformBend");
        previewed();
        rest();
        const double from = value("deformFrom");
        const double to = value("deformTo");
        const Box box = document().content().box;
        const ViewportWidget& view = m_window->viewport();
        const QPointF one = *view.widgetPosition(box.min());
        const QPointF other = *view.widgetPosition(box.min() + Vec3(box.sizes().x(), 0, 0));
        drag(DeformHandle::to, (0.3 * (one - other)).toPoint());
        QVERIFY2(value("deformTo") < to - 0.15 * (to - from) && value("deformTo") > from, "the plane did not follow");
        QCOMPARE(value("deformFrom"), from);
        const double angle = value("deformAngle");
        drag(DeformHandle::value, {0, -40});
        QVERIFY2(std::abs(value("deformAngle") - angle) > 0.02, "the angle did not follow");
        picture("deform-dragged");
        type("deformAngle", "60");
        apply();
        QVERIFY(std::abs(bar().box.sizes().x() / box.sizes().x() - 1) > 0.02);
    }

    void escLeavesEverythingAsItIs()
    {
        openBar();
        const std::size_t entries = tree().records().size();
        const FramePointer frame = document().frame();
        begin("deformTwist");
        previewed();
        picture("deform-twist");
        QVERIFY(m_window->viewport().shownFrame() != frame);
        m_window->viewport().setFocus();
        QTest::keyClick(&m_window->viewport(), Qt::Key_Escape);
        QVERIFY(!action("deform")->isChecked() && !m_window->viewport().isLookingBack());
        QCOMPARE(m_window->viewport().shownFrame()->bodies, document().frame()->bodies);
        QCOMPARE(tree().records().size(), entries);
    }

    /// The task that was to do it, too.
    void cancelGivesUpWhatIsBeingApplied()
    {
        openBar();
        const std::size_t entries = tree().records().size();
        begin("deformStretch");
        previewed();
        QTest::mouseClick(find<QPushButton>("applyDeform"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->tasks().isRunning(), patience);
        QTest::mouseClick(find<QPushButton>("cancelDeform"), Qt::LeftButton);
        QVERIFY(!m_window->tasks().isRunning() && !action("deform")->isChecked());
        wait();
        QCOMPARE(tree().records().size(), entries);
    }

    void itEndsWhenTimeRuns()
    {
        openBar();
        begin("deformTwist");
        previewed();
        action("play")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!action("deform")->isChecked(), patience);
        QVERIFY(document().isPlaying() && !m_window->viewport().isLookingBack());
        document().pause();
    }

    /// A sentence with the radius that would do.
    void aBendThatFoldsIsRefused()
    {
        openBar();
        begin("deformBend");
        type("deformRadius", "8 mm");
        auto* told = find<QLabel>("deformProblem");
        QVERIFY(told->isVisible());
        QVERIFY2(told->text().contains("at least a radius of"), qPrintable(told->text()));
        QTRY_VERIFY_WITH_TIMEOUT(!find<QToolButton>("pressButton")->isVisible(), patience);
        QVERIFY(!find<QPushButton>("applyDeform")->isEnabled());
        picture("deform-folds");
        m_window->viewport().setFocus();
        QTest::keyClick(&m_window->viewport(), Qt::Key_Return);
        QVERIFY(!m_window->tasks().isRunning());
        type("deformAngle", "30");
        QVERIFY(!told->isVisible() && find<QPushButton>("applyDeform")->isEnabled());
    }

    /// The dent of a block is in what is stretched: it has lost more than the bar alone would.
    void whatWasKneadedIsDeformedToo()
    {
        openBar();
        action("pressIt")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.3, patience);
        key(Qt::Key_Space);
        waitForGesture();
        const auto present = [this] {
            Box box;
            for (const auto& body : document().frame()->bodies)
                for (const Vec3& place : body->places)
                    box.extend(place);
            return box;
        };
        const Box kneaded = present();
        QVERIFY(!kneaded.isApprox(document().content().box, 1e-3));
        begin("deformStretch");
        type("deformFactor", "1.5");
        apply();
        QCOMPARE(presentName(), QString("Stretched to 1.5"));
        const Box now = document().content().box;
        const double size = kneaded.sizes().maxCoeff();
        for (int axis = 0; axis < 3; ++axis) {
            const double wanted = kneaded.sizes()[axis] * (kneaded.sizes()[axis] == size ? 1.5 : 1);
            QVERIFY2(std::abs(now.sizes()[axis] - wanted) < 0.01 * size,
                     qPrintable(QString("%1: %2 %3").arg(axis).arg(now.sizes()[axis]).arg(wanted)));
        }
    }

    void fixturesToolsAndGravityStay()
    {
        openBar();
        const Box box = document().content().box;
        document().toggleFace(0, faceAt(box.min().x()));
        key(Qt::Key_B);
        QTRY_COMPARE_WITH_TIMEOUT(snapshot().tools.size(), std::size_t{1}, patience);
        key(Qt::Key_G);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().gravity.norm() > 0, patience);
        wait();
        const Vec3 gravity = snapshot().gravity;
        QCOMPARE(snapshot().fixtures.size(), std::size_t{1});
        begin("deformShear");
        picture("deform-shear");
        type("deformShift", "10 mm");
        SceneOptions options = m_window->viewport().options();
        options.hiddenParts = {0};
        m_window->viewport().setOptions(options);
        apply();
        QCOMPARE(m_window->viewport().options().hiddenParts, std::set<std::size_t>{0});
        QCOMPARE(snapshot().fixtures.size(), std::size_t{1});
        QVERIFY(snapshot().gravity == gravity);
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QCOMPARE(document().fixtures().list().size(), std::size_t{1});
        const FaceFixture& fixture = document().fixtures().list()[0];
        for (const std::uint32_t face : fixture.faces)
            for (std::size_t t = 0; t < bar().mesh.triangles.size(); ++t)
                if (bar().mesh.faceOfTriangle[t] == face)
                    for (const Vec3& corner : cornersOf(bar().mesh.vertices, bar().mesh.triangles[t]))
                        QVERIFY(std::abs(corner.x() - box.min().x()) < 1e-6);
        key(Qt::Key_Z, Qt::ControlModifier);
        wait();
        QCOMPARE(document().fixtures().list().size(), std::size_t{1});
    }

    /// A field that is that of a function comes back as it.
    void aFieldDeformsTheBar()
    {
        newWindow(servicesWithShear());
        openBar();
        const Box before = document().content().box;
        const double volume = bar().volume;
        m_window->features().deforming->openField(file("result.csv"));
        waitForTasks();
        previewed();
        QVERIFY(action("deform")->isChecked());
        QCOMPARE(find<QComboBox>("fieldStep")->currentIndex(), 1);
        QVERIFY(find<QLabel>("fieldSentences")->text().contains("left out"));
        QVERIFY(m_window->viewport().scale().has_value());
        picture("deform-field");
        auto* step = find<QComboBox>("fieldStep");
        step->setCurrentIndex(0);
        emit step->activated(0);
        QTRY_VERIFY_WITH_TIMEOUT(problem().contains("damaged"), patience);
        QCOMPARE(step->currentIndex(), 1); // which the field is still of
        closeBanner();
        type("fieldFactor", "-2");
        type("fieldExaggeration", "5");
        QTest::mouseClick(find<QCheckBox>("fieldColors"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->viewport().scale().has_value(), patience);
        apply();
        QCOMPARE(presentName(), QString("Deformed by result.csv, times -2"));
        QVERIFY(std::abs(bar().volume / volume - 1) < 1e-3); // of a shear
        const double rise = 2 * 0.05 * before.sizes().x();
        QVERIFY2(std::abs(bar().box.sizes().z() - before.sizes().z() - rise) < 1e-3 * before.sizes().x(),
                 qPrintable(QString::number(bar().box.sizes().z() - before.sizes().z())));
    }

    /// Whatever the view exaggerates: half of it would do.
    void aFieldThatFoldsIsRefused()
    {
        newWindow(servicesWith([](const Vec3& node) { return Vec3(-0.75 * node.x(), 0, 0); }));
        openBar();
        m_window->features().deforming->openField(file("result.csv"));
        waitForTasks();
        auto* told = find<QLabel>("deformProblem");
        type("fieldExaggeration", "0.1");
        type("fieldFactor", "2");
        QTRY_VERIFY_WITH_TIMEOUT(told->isVisible(), patience);
        QVERIFY2(told->text().contains("inside out"), qPrintable(told->text()));
        m_window->viewport().setFocus();
        QTest::keyClick(&m_window->viewport(), Qt::Key_Return);
        QVERIFY(!m_window->tasks().isRunning() && problem().contains("inside out"));
        closeBanner();
        type("fieldFactor", "1");
        QVERIFY(!told->isVisible() && find<QPushButton>("applyDeform")->isEnabled());
    }

    /// What stays is chosen in the part as it is, with clicks.
    void facesThatAreChosenStay()
    {
        newWindow(servicesWithShear());
        openBar();
        const Box before = document().content().box;
        m_window->features().deforming->openField(file("result.csv"));
        waitForTasks();
        previewed();
        QTRY_VERIFY_WITH_TIMEOUT(seenBox().max().z() > before.max().z() + 1e-3, patience);
        auto* choose = find<QPushButton>("fieldKeep");
        QTest::mouseClick(choose, Qt::LeftButton);
        QVERIFY(!m_window->viewport().isLookingBack());
        this->rest();
        const Vec3 center = before.center();
        click({center.x(), center.y(), before.max().z()});
        QTRY_COMPARE_WITH_TIMEOUT(document().selected().region().count(), std::size_t{1}, patience);
        QTest::mouseClick(choose, Qt::LeftButton);
        QCOMPARE(find<QLabel>("fieldKept")->text(), QString("1"));
        previewed();
        const auto& rest = document().frame()->bodies[0]->places;
        const auto largestWayAbove = [&](double height) {
            double largest = 0;
            const auto& now = m_window->viewport().shownFrame()->bodies[0]->places;
            for (std::size_t i = 0; i < rest.size(); ++i)
                if (rest[i].z() >= height)
                    largest = std::max(largest, (now[i] - rest[i]).norm());
            return largest;
        };
        QTRY_VERIFY_WITH_TIMEOUT(largestWayAbove(before.max().z() - 1e-9) < 1e-9, patience);
        QVERIFY(largestWayAbove(before.min().z()) > 1e-3);
        picture("deform-kept");
    }

    void aTableIsReadAndFits()
    {
        writeWarp();
        openBar();
        const double volume = bar().volume;
        m_window->features().deforming->openField(file("warp.csv"));
        waitForTasks();
        QVERIFY2(action("deform")->isChecked(), qPrintable(problem()));
        previewed();
        QTRY_VERIFY_WITH_TIMEOUT(find<QLabel>("fieldLargest")->text() == "25.6 mm", patience);
        picture("deform-table");
        apply();
        QCOMPARE(presentName(), QString("Deformed by warp.csv"));
        QVERIFY(std::abs(bar().volume / volume - 1) < 1e-3 && bar().exact && bar().watertight);
        QVERIFY(std::abs(bar().box.max().z() - (0.020 + 0.0256)) < 1e-4);
    }

    /// The project has the parts of its first start and those that were deformed; a recipe takes these from it.
    void recipesTakeDeformedPartsFromTheProject()
    {
        openBar();
        begin("deformTaper");
        type("deformFactor", "0.5");
        apply();
        saveTo(file("tapered.knead"));
        const Project project = m_services.projects.read(bytesOf(file("tapered.knead")), TaskControl::none());
        QCOMPARE(project.starts.size(), std::size_t{2});
        QVERIFY(!project.starts[0].model && project.starts[1].model);
        QVERIFY(shownModel(project)->parts[0].volume < 0.8 * project.model->parts[0].volume);
    }

    /// Carried out, it comes to the same parts and objects, to the bit.
    void whatWasDeformedIsARecipe()
    {
        writeWarp();
        openBar();
        begin("deformBend");
        type("deformAngle", "40");
        apply();
        m_window->features().deforming->openField(file("warp.csv"));
        waitForTasks();
        previewed();
        auto* choose = find<QPushButton>("fieldKeep");
        QTest::mouseClick(choose, Qt::LeftButton);
        document().selected().select(regionOf(Level::Face, 0, {faceAt(bar().box.min().x())}));
        QTest::mouseClick(choose, Qt::LeftButton);
        QCOMPARE(find<QLabel>("fieldKept")->text(), QString("1"));
        type("fieldFactor", "-0.5");
        QTest::mouseClick(find<QCheckBox>("fieldLockY"), Qt::LeftButton);
        previewed();
        apply();
        const Project project = document().project();
        QCOMPARE(project.starts.size(), std::size_t{3});
        QCOMPARE(project.starts[2].deformations.size(), std::size_t{2});
        const std::string path = file("deformed.recipe.json").toStdString();
        const std::vector<Message> remarks = m_services.recipes.write(path, project, {});
        QVERIFY2(remarks.empty(), (remarks.empty() ? std::string() : remarks.front().english()).c_str());
        const QString text = QString::fromUtf8(read(file("deformed.recipe.json")));
        for (const char* said : {"bar.step", "\"angle_deg\": 40", "\"field\": \"warp.csv\"", "\"factor\": -0.5",
                                 "\"locked\": [\"y\"]", "\"kept_faces\"", "\"fade_mm\"", "\"separately\": true"})
            QVERIFY2(text.contains(said), qPrintable(text.left(2000)));
        const RecipeStart again = m_services.recipes.open(path, TaskControl::none());
        QCOMPARE(again.model->parts[0].faces.size(), bar().faces.size());
        QVERIFY(again.model->parts[0].mesh.vertices == bar().mesh.vertices);
        QVERIFY(same::values(again.start.scene.bodies[0].aggregate, project.starts[2].scene.bodies[0].aggregate));

        saveTo(file("deformed.knead"));
        newWindow(m_services);
        openProject(file("deformed.knead"));
        QVERIFY(m_services.recipes.write(path, document().project(), {}).empty());
        QCOMPARE(QString::fromUtf8(read(file("deformed.recipe.json"))), text);
    }

    /// Grips lead both ends while the middle finds its shape: one entry, with what was seen, which is undone and can be repeated. What
    /// is given up on the way has changed nothing.
    void aBarIsBentByPhysics()
    {
        openBar();
        const Box before = document().content().box;
        begin("deformBend");
        type("deformAngle", "30");
        choosePhysics();
        QVERIFY(find<QCheckBox>("deformLetsGo")->isVisible() && !find<QCheckBox>("deformEases")->isVisible());
        type("deformDuration", "0.2 s");
        previewed();
        picture("deform-by-physics");
        const std::size_t entries = tree().records().size();
        m_window->viewport().setFocus();
        QTest::keyClick(&m_window->viewport(), Qt::Key_Return);
        key(Qt::Key_Escape);
        wait();
        QCOMPARE(tree().records().size(), entries);
        QVERIFY(!action("deform")->isChecked() && document().frame()->snapshot->fixtures.empty());

        begin("deformBend");
        type("deformAngle", "30");
        choosePhysics();
        type("deformDuration", "0.2 s");
        previewed();
        apply();
        QCOMPARE(tree().records().size(), entries + 1);
        QCOMPARE(presentName(), QString("Bent by 30\u00B0 by physics"));
        QVERIFY(document().film().framesOf(tree().current()).size() > 3);
        wait();
        const Snapshot& now = *document().frame()->snapshot;
        QCOMPARE(now.fixtures.size(), std::size_t{2});
        QCOMPARE(QString::fromStdString(now.fixtures[1].name), QString("bend: second end"));
        QVERIFY(seenBox().max().z() > before.max().z() + 0.02);
        picture("deformed-by-physics");
        const Project project = document().project();
        HistoryReplay again(project, HistoryReplay::From::starts, document().history().packing());
        QVERIFY(again.repeat(project.current, TaskControl::none()).isSame);
        key(Qt::Key_Z, Qt::ControlModifier);
        wait();
        QVERIFY(document().frame()->snapshot->fixtures.empty());
        QVERIFY((seenBox().max() - before.max()).norm() < 1e-6);
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        wait();
        QCOMPARE(document().frame()->snapshot->fixtures.size(), std::size_t{2});

        begin("deformTaper");
        choosePhysics();
        QVERIFY(find<QLabel>("deformProblem")->text().contains("do it exactly"));
    }

    /// What is on the skin goes along, what is hidden stays hidden, and undo brings back what was there before.
    void measurementsAndProbesGoAlong()
    {
        openBar();
        const Box box = document().content().box;
        const Vec3 end(box.max().x(), box.center().y(), box.center().z());
        const std::optional<SkinPlace> tip = nearestPlace(end, document().content().bodies);
        const std::optional<SkinPlace> root =
            nearestPlace(Vec3(box.min().x(), end.y(), end.z()), document().content().bodies);
        QVERIFY(tip && root);
        MeasurementList& list = m_window->measuring().list();
        list.add(MeasureKind::distance, {*root, *tip});
        list.add(MeasureKind::point, {*tip});
        m_window->probes().add(*tip);
        modelTree().hideParts({0});
        const auto places = [&] {
            std::vector<Vec3> all;
            for (const SkinPlace& place :
                 {list.all()[0].places[1], list.all()[1].places[0], m_window->probes().all()[0].place}) {
                const FilledBody& body = *document().content().bodies[place.body];
                all.push_back(placeOf(place, body, body.mesh.vertices));
            }
            return all;
        };
        const auto isHidden = [&] {
            return m_window->viewport().options().hiddenParts == std::set<std::size_t>{0} &&
                   modelTree().hiddenParts() == std::set<std::size_t>{0};
        };
        begin("deformShear");
        type("deformShift", "10 mm");
        apply();
        QCOMPARE(list.all().size(), std::size_t{2});
        QCOMPARE(m_window->probes().all().size(), std::size_t{1});
        QCOMPARE(list.all()[0].number, 1);
        const Vec3 moved = end + Vec3(0, 0, bar().box.sizes().z() - box.sizes().z());
        for (const Vec3& place : places())
            QVERIFY2((place - moved).norm() < 1e-5,
                     qPrintable(QString("%1 %2 %3").arg(place.x()).arg(place.y()).arg(place.z())));
        QVERIFY(isHidden());
        list.add(MeasureKind::point, {list.all()[0].places[0]});

        key(Qt::Key_Z, Qt::ControlModifier);
        wait();
        QCOMPARE(list.all().size(), std::size_t{2});
        QCOMPARE(m_window->probes().all().size(), std::size_t{1});
        for (const Vec3& place : places())
            QVERIFY((place - end).norm() < 1e-9);
        QVERIFY(isHidden());
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        wait();
        QCOMPARE(list.all().size(), std::size_t{3});
        for (const Vec3& place : places())
            QVERIFY((place - moved).norm() < 1e-5);
        openBar();
        QVERIFY(list.all().empty() && m_window->probes().all().empty());
        QVERIFY(modelTree().hiddenParts().empty());
    }

    /// What was done in another session, and a scan of the part.
    void projectsAndScansAreFields()
    {
        openBar();
        begin("deformBend");
        type("deformAngle", "20");
        apply();
        const Box bent = document().content().box;
        writeScan(bar().mesh, file("scan.stl"));
        openBar();
        const double size = document().content().box.sizes().x();
        m_window->features().deforming->openField(file("scan.stl"));
        waitForTasks();
        QVERIFY2(action("deform")->isChecked(), qPrintable(problem()));
        QVERIFY(find<QCheckBox>("fieldInPlace")->isVisible() && !find<QCheckBox>("fieldInPlace")->isChecked());
        QTest::mouseClick(find<QCheckBox>("fieldInPlace"), Qt::LeftButton);
        waitForTasks();
        QVERIFY(find<QCheckBox>("fieldInPlace")->isChecked());
        previewed();
        apply();
        QCOMPARE(presentName(), QString("Deformed by scan.stl"));
        const Box scanned = document().content().box;
        QVERIFY2((scanned.max() - bent.max()).norm() < 0.02 * size,
                 qPrintable(QString::number((scanned.max() - bent.max()).norm() / size)));

        openBar();
        action("pressIt")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.3, patience);
        key(Qt::Key_Space);
        waitForGesture();
        saveTo(file("pressed.knead"));
        Box pressed;
        for (const auto& body : document().frame()->bodies)
            pressed.extend(boxOfPlaces(body->places));
        openBar();
        m_window->features().deforming->openField(file("pressed.knead"));
        waitForTasks();
        QVERIFY2(action("deform")->isChecked(), qPrintable(problem()));
        QVERIFY(!find<QCheckBox>("fieldInPlace")->isVisible() && !find<QComboBox>("fieldUnit")->isEnabled());
        previewed();
        apply();
        QVERIFY2((document().content().box.max() - pressed.max()).norm() < 0.01 * size,
                 qPrintable(QString::number((document().content().box.max() - pressed.max()).norm() / size)));
    }

    void picturesInBothThemes()
    {
        if (qEnvironmentVariableIsEmpty("KNEAD_PICTURES"))
            return;
        openExample("bracket.step", 16);
        for (const Theme theme : {Theme::Dark, Theme::Light}) {
            m_window->features().preferences->setTheme(theme);
            for (const char* kind : {"deformBend", "deformTwist", "deformTaper", "deformStretch", "deformScale"}) {
                begin(kind);
                previewed();
                QTest::qWait(500);
                picture(qPrintable(QString("deform-%1-%2").arg(theme == Theme::Dark ? "dark" : "light", kind)));
            }
            action("deform")->setChecked(false);
        }
    }

private:
    /// Of the bar: the face that lies across x there.
    std::uint32_t faceAt(double x)
    {
        const TriangleMesh& mesh = bar().mesh;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto corners = cornersOf(mesh.vertices, mesh.triangles[t]);
            if (std::ranges::all_of(corners, [x](const Vec3& corner) { return std::abs(corner.x() - x) < 1e-9; }))
                return mesh.faceOfTriangle[t];
        }
        return 0;
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowDeformTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_deform_test.moc"
