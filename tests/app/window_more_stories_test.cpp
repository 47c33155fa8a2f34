// More of what designers come for, from an empty window to a file that is read back.
#include "core/geometry/mass_properties.h"
#include "io/importer.h"
#include "support/shapes.h"
#include "support/story_on_test.h"
#include "ui/interaction/sculpt_hand.h"
#include "ui/run_window.h"

#include <QFileInfo>
#include <QPushButton>

#include <limits>
#include <map>
#include <numbers>

using namespace knead;

namespace {

/// Share of the edges within faces at which a surface turns by more than an angle [rad]: 0 where each face is smooth.
double sharpShare(const TriangleMesh& mesh, double angle)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> around; // triangles at an edge
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const auto [a, b] = std::minmax(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]);
            around[{a, b}].push_back(t);
        }
    const auto normal = [&](std::size_t t) {
        const auto& [a, b, c] = mesh.triangles[t];
        return (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).normalized();
    };
    std::size_t within = 0;
    std::size_t sharp = 0;
    for (const auto& [edge, triangles] : around) {
        if (triangles.size() != 2 || mesh.faceOfTriangle[triangles[0]] != mesh.faceOfTriangle[triangles[1]])
            continue;
        ++within;
        if (normal(triangles[0]).dot(normal(triangles[1])) < std::cos(angle))
            ++sharp;
    }
    return within == 0 ? 1 : static_cast<double>(sharp) / static_cast<double>(within);
}

/// A text STL, in millimetres.
void writeStl(const QString& path, const TriangleMesh& mesh)
{
    QFile file(path);
    QVERIFY(file.open(QFile::WriteOnly));
    QTextStream text(&file);
    text << "solid die\n";
    for (const auto& triangle : mesh.triangles) {
        text << "facet normal 0 0 0\nouter loop\n";
        for (const std::uint32_t v : triangle)
            text << "vertex " << 1e3 * mesh.vertices[v].x() << ' ' << 1e3 * mesh.vertices[v].y() << ' '
                 << 1e3 * mesh.vertices[v].z() << '\n';
        text << "endloop\nendfacet\n";
    }
    text << "endsolid die\n";
}

/// Counts what a mouse does, be it where it may.
class MouseWatch final : public QObject {
public:
    MouseWatch() { qApp->installEventFilter(this); }
    int count() const { return m_count; }

protected:
    bool eventFilter(QObject* /*watched*/, QEvent* event) override
    {
        switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonRelease:
        case QEvent::MouseButtonDblClick:
        case QEvent::MouseMove:
        case QEvent::Wheel:
            ++m_count;
            break;
        default:
            break;
        }
        return false;
    }

private:
    int m_count = 0;
};

} // namespace

class WindowMoreStoriesTest : public QObject, StoryOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepareStories();
    }

    void cleanup() { m_window.reset(); }

    /// The grip of a handle is drawn out at a side and turned at its end, with two brushes; both faces and volume stay.
    void aHandleIsPulledAndTwisted()
    {
        beginStory("handle");
        openByHand(example("handle.step"));
        const Box box = boxOfBody(0);
        choose("materialPreset", "Mod", "Modeling clay");
        QTRY_VERIFY(snapshot().materials[0].yieldStress > 0);
        stage("clay");
        key(Qt::Key_F6);
        QVERIFY(action("pull")->isChecked());
        const std::size_t side = vertexSeen(0.5);
        stroke(placeOf(side), QPoint(70, 0), 0.5, "pulling");
        stage("pulled");
        const double pulled = moveOf(side).norm();
        QVERIFY2(pulled > 10 * millimeter, qPrintable(QString::number(pulled)));

        key(Qt::Key_W);
        QVERIFY(action("sculptTwist")->isChecked() && !action("pull")->isChecked());
        for (int n = 0; n < 6; ++n)
            key(Qt::Key_BracketRight);
        const Vec3 end = placeOf(vertexAt({box.center().x(), box.center().y(), box.max().z()}));
        const double before = turnAbove(box.max().z() - 2 * millimeter);
        stroke(end, QPoint(90, 0), 0.8, "twisting");
        stage("twisted");
        const double turned = turnAbove(box.max().z() - 2 * millimeter) - before;
        QVERIFY2(turned < -15 * std::numbers::pi / 180, qPrintable(QString::number(turned))); // clockwise, as drawn
        key(Qt::Key_Escape);
        endStory();
        exportByHand(file("handle.step"));
        stage("exported");
        const std::vector<Part> parts = readBack("handle.step", 2);
        verifyVolumes(parts, document().content().model->parts);
        QCOMPARE(parts[0].faces.size(), document().content().model->parts[0].faces.size());
    }

    /// A grip of clay is cut in two with a knife that is told by its handle how far to go; both pieces are solids of the file.
    void aGripIsCutInTwo()
    {
        beginStory("halves");
        openByHand(example("grip.step"));
        choose("materialPreset", "Mod", "Modeling clay");
        QTRY_VERIFY(snapshot().materials[0].toughness > 0);
        const double whole = document().content().model->parts[0].volume;
        const Box box = boxOfBody(0);
        addTool("knife");
        const std::pair<const char*, const char*> numbers[] = {
            {"toolSizeX", "60 mm"}, {"toolSizeY", "2 mm"}, {"toolSizeZ", "40 mm"}, {"toolSpeed", "80 mm/s"}};
        for (const auto& [field, text] : numbers)
            type(field, text);
        placeTool(0, rounded({box.center().x(), box.center().y(), box.max().z() + 21 * millimeter}));
        key(Qt::Key_0);
        key(Qt::Key_F);
        waitForView();
        stage("knife");
        play();
        const QPoint arrow = placeOfArrow(GizmoPart::moveZ);
        QTest::mouseMove(&view(), arrow);
        QTest::mousePress(&view(), Qt::LeftButton, {}, arrow);
        QVERIFY(m_window->hands().gizmo().isDragging());
        QTest::keyClicks(&view(), "-30");
        stage("typed");
        QTest::keyClick(&view(), Qt::Key_Return);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, arrow);
        waitUntil([&] { return tool(0).pose.position.z() < box.max().z() + 8 * millimeter; });
        stage("half-way");
        waitUntil([&] { return snapshot().components == 2; });
        stage("cut");
        pause();
        key(Qt::Key_Delete);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{0});
        stage("pieces");
        endStory();
        exportByHand(file("halves.step"));
        stage("exported");
        const std::vector<Part> parts = readBack("halves.step", 2);
        QVERIFY(std::abs((parts[0].volume + parts[1].volume) / whole - 1) < 0.01);
        for (const Part& part : parts) {
            QCOMPARE(part.solids, 1);
            QVERIFY2(part.volume > 0.4 * whole && part.volume < 0.6 * whole, part.name.c_str());
        }
    }

    /// A ring from another file is added, made rigid, and pressed into clay with a plate: the dent is a ring.
    void ASecondPartLeavesItsFormInTheFirst()
    {
        beginStory("die");
        openByHand(example("lump.step"));
        const Box lump = boxOfBody(0);
        const double ring = 11 * millimeter;
        const double tube = 4 * millimeter;
        TriangleMesh die = shapes::torus(ring, tube, 48, 20);
        const Vec3 center(lump.center().x(), lump.center().y(), lump.max().z() + tube + 0.2 * millimeter);
        for (Vec3& vertex : die.vertices)
            vertex += center;
        writeStl(file("die.stl"), die);
        answerFileDialog(file("die.stl"));
        command("add part");
        QTRY_VERIFY_WITH_TIMEOUT(isIdle() && document().content().bodies.size() == 2, patience);
        waitForView();
        comeBack();
        stage("added");
        click({lump.center().x(), lump.min().y(), lump.center().z()}); // the new one is selected
        QTRY_COMPARE(document().selection(), (Selection{Selection::Kind::Body, 0}));
        choose("materialPreset", "Mod", "Modeling clay");
        QTRY_VERIFY(snapshot().materials[0].yieldStress > 0);
        stage("clay");
        click(center + Vec3(0, -ring, tube));
        QTRY_COMPARE(document().selection(), (Selection{Selection::Kind::Body, 1}));
        choose("bodyKind", "R", "Rigid");
        QTRY_VERIFY(snapshot().bodies[1].kind == BodyKind::rigid);
        stage("rigid");
        addTool("plate");
        const std::pair<const char*, const char*> numbers[] = {{"toolSizeX", "36 mm"},
                                                               {"toolSizeY", "36 mm"},
                                                               {"toolSizeZ", "4 mm"},
                                                               {"toolForceLimit", "1 kN"},
                                                               {"toolSpeed", "40 mm/s"}};
        for (const auto& [field, text] : numbers)
            type(field, text);
        const double above = center.z() + tube + 2.5 * millimeter;
        placeTool(0, rounded({center.x(), center.y(), above}));
        key(Qt::Key_0);
        key(Qt::Key_F);
        waitForView();
        stage("plate");
        const std::size_t pressed = vertexAt({center.x() + ring, center.y(), lump.max().z()});
        play();
        hold(Qt::Key_PageDown, [&] { return moveOf(pressed).z() < -3 * millimeter; });
        stage("pressed");
        hold(Qt::Key_PageUp, [&] { return tool(0).pose.position.z() > above + 20 * millimeter; });
        pause();
        stage("lifted");
        click(center + Vec3(0, -ring, tube - 3 * millimeter));
        QTRY_COMPARE(document().selection(), (Selection{Selection::Kind::Body, 1}));
        key(Qt::Key_H);
        waitForView();
        stage("dent");
        endStory();
        exportByHand(file("dented.step"));
        stage("exported");
        const std::vector<Part> parts = readBack("dented.step", 2);
        verifyVolumes(parts, document().content().model->parts);
        // Deepest under the ring, and there where the ring is.
        const auto onCircle = [&](const TriangleMesh& mesh, double radius, Side side) {
            constexpr int places = 24;
            double sum = 0;
            for (int n = 0; n < places; ++n) {
                const double angle = 2 * std::numbers::pi * n / places;
                sum += heightAt(mesh, center + radius * Vec3(std::cos(angle), std::sin(angle), 0), side);
            }
            return sum / places;
        };
        const double under = onCircle(parts[0].mesh, ring, Side::top);
        const double within = heightAt(parts[0].mesh, center, Side::top);
        const double beside = onCircle(parts[0].mesh, ring + 2 * tube, Side::top);
        const double ofRing = onCircle(parts[1].mesh, ring, Side::bottom);
        qInfo("Under the ring %.2f mm, within %.2f mm, beside it %.2f mm; the ring %.2f mm.", under / millimeter,
              within / millimeter, beside / millimeter, ofRing / millimeter);
        QVERIFY(lump.max().z() - under > 3 * millimeter);
        QVERIFY(within - under > 1.5 * millimeter);
        QVERIFY(beside - under > 1.5 * millimeter);
        // Bodies touch where their objects do, half a spacing from the skin of each.
        const double spacing = document().content().bodies[0]->aggregate->lattice.spacing;
        QVERIFY2(std::abs(under - ofRing) < spacing, qPrintable(QString::number(spacing / millimeter)));
    }

    /// From the first page to the file without a mouse.
    void theKeyboardAloneDoes()
    {
        beginStory("keys");
        const MouseWatch mouse;
        tabTo("example_lump");
        stage("on-an-example");
        press(Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty() && isIdle(), patience);
        waitForView();
        QVERIFY(view().hasFocus());
        stage("open");
        tabTo("materialPreset");
        stage("on-materials");
        pressLetters("Mod");
        QTRY_VERIFY(snapshot().materials[0].yieldStress > 0);
        stage("clay");
        press(Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(find<QLineEdit>("paletteField")->hasFocus());
        pressLetters("ball");
        press(Qt::Key_Return);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        QTRY_VERIFY(view().hasFocus());
        press(Qt::Key_F);
        waitForView();
        stage("ball");
        press(Qt::Key_Space);
        QTRY_VERIFY(snapshot().playing);
        const Box box = boxOfBody(0);
        const std::size_t under = vertexAt({tool(0).pose.position.x(), tool(0).pose.position.y(), box.max().z()});
        hold(Qt::Key_PageDown, [&] { return moveOf(under).z() < -4 * millimeter; });
        stage("pressed");
        hold(Qt::Key_PageUp, [&] { return tool(0).pose.position.z() > box.max().z() + tool(0).size.x() / 2; });
        press(Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        waitForGesture();
        press(Qt::Key_1);
        waitForView();
        stage("front");
        press(Qt::Key_0);
        waitForView();
        const std::uint64_t dented = hash();
        press(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(hash() != dented && document().isSettled(), patience);
        stage("undone");
        press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(hash() == dented && document().isSettled(), patience);
        const double depth = -moveOf(under).z();
        stage("redone");
        answerFileDialog(file("keys.step"));
        press(Qt::Key_E, Qt::ControlModifier);
        QTRY_VERIFY(find<QDialog>("exportDialog") != nullptr && find<QDialog>("exportDialog")->isVisible());
        find<QDialog>("exportDialog")->activateWindow();
        QTRY_VERIFY(find<QDialog>("exportDialog")->isActiveWindow());
        QTRY_VERIFY(find<QDialog>("exportDialog")->isAncestorOf(QApplication::focusWidget()));
        stage("export-dialog");
        press(Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file("keys.step")) && isIdle(), patience);
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QVERIFY(view().hasFocus());
        stage("exported");
        const std::vector<Part> parts = readBack("keys.step", 1);
        verifyVolumes(parts, document().content().model->parts);
        const double written = box.max().z() - heightAt(parts[0].mesh, tool(0).pose.position, Side::top);
        QVERIFY2(depth > 3 * millimeter && std::abs(written - depth) < 0.1 * millimeter,
                 qPrintable(QString("%1 and %2").arg(depth).arg(written)));
        QCOMPARE(mouse.count(), 0);
        endStory();
    }

private:
    Box boxOfBody(std::size_t body)
    {
        Box box;
        for (const Vec3& vertex : document().content().bodies[body]->mesh.vertices)
            box.extend(vertex);
        return box;
    }

    enum class Side { bottom, top };

    /// Where the surface of a part is above a place, at its top or at its bottom [m].
    static double heightAt(const TriangleMesh& mesh, const Vec3& place, Side side)
    {
        const double sign = side == Side::top ? 1 : -1;
        double best = -std::numeric_limits<double>::infinity();
        for (const auto& [a, b, c] : mesh.triangles) {
            const Vec3 u = mesh.vertices[b] - mesh.vertices[a];
            const Vec3 v = mesh.vertices[c] - mesh.vertices[a];
            const Vec3 to = place - mesh.vertices[a];
            const double area = u.x() * v.y() - u.y() * v.x();
            if (std::abs(area) < 1e-16) // it stands upright
                continue;
            const double s = (to.x() * v.y() - to.y() * v.x()) / area;
            const double t = (u.x() * to.y() - u.y() * to.x()) / area;
            if (s >= -1e-9 && t >= -1e-9 && s + t <= 1 + 1e-9)
                best = std::max(best, sign * (mesh.vertices[a].z() + s * u.z() + t * v.z()));
        }
        return sign * best;
    }

    /// To whole tenths of a millimeter, as one types them.
    static Vec3 rounded(const Vec3& place)
    {
        return (place / (0.1 * millimeter)).array().round().matrix() * 0.1 * millimeter;
    }

    QPoint placeOfArrow(GizmoPart arrow)
    {
        const Gizmo handles = *m_window->hands().gizmo().gizmo();
        const Pixel pixel = handles.pixelOf(0.85 * Gizmo::shaftEnd * Vec3::Unit(axisOf(arrow)));
        return {qRound(pixel.x), qRound(pixel.y)};
    }

    /// Goes where the keyboard is.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QWidget* there = QApplication::activePopupWidget();
        if (there == nullptr)
            there = QApplication::focusWidget();
        if (there == nullptr)
            there = m_window.get();
        QTest::keyClick(there, key, modifiers);
    }
    void pressLetters(const char* letters)
    {
        QTest::qWait(2 * QApplication::keyboardInputInterval()); // what was typed before is forgotten
        QTest::keyClicks(QApplication::focusWidget(), letters);
    }

    void tabTo(const char* name)
    {
        int count = 0;
        for (; count < 20; ++count) {
            if (QApplication::focusWidget() != nullptr && QApplication::focusWidget()->objectName() == name)
                break;
            press(Qt::Key_Tab);
        }
        QVERIFY2(count < 20, name); // a person would give up
    }

    /// A vertex of the first body that is seen, at a share of its height, as near to the eye as any there.
    std::size_t vertexSeen(double share)
    {
        const auto& vertices = document().frame()->bodies[0]->places;
        const Box box = boxOfBody(0);
        const double height = box.min().z() + share * box.sizes().z();
        const Vec3 eye = view().camera().towardsEye();
        std::size_t best = 0;
        double nearest = -1e9;
        for (std::size_t v = 0; v < vertices.size(); ++v)
            if (std::abs(vertices[v].z() - height) < 2 * millimeter && vertices[v].dot(eye) > nearest) {
                nearest = vertices[v].dot(eye);
                best = v;
            }
        return best;
    }

    /// By what angle the material above a height has turned about z, on average [rad].
    double turnAbove(double height)
    {
        const auto& rest = document().content().bodies[0]->mesh.vertices;
        const auto& now = document().frame()->bodies[0]->places;
        Vec3 restMiddle = Vec3::Zero();
        Vec3 nowMiddle = Vec3::Zero();
        double count = 0;
        for (std::size_t v = 0; v < rest.size(); ++v)
            if (rest[v].z() > height) {
                restMiddle += rest[v];
                nowMiddle += now[v];
                ++count;
            }
        restMiddle /= count;
        nowMiddle /= count;
        double across = 0;
        double along = 0;
        for (std::size_t v = 0; v < rest.size(); ++v)
            if (rest[v].z() > height) {
                const Vec3 a = rest[v] - restMiddle;
                const Vec3 b = now[v] - nowMiddle;
                across += a.x() * b.y() - a.y() * b.x();
                along += a.x() * b.x() + a.y() * b.y();
            }
        return std::atan2(across, along);
    }

    /// Draws a brush from a place of the part, at the pace of a hand.
    void stroke(const Vec3& from, const QPoint& way, double time, const char* name)
    {
        const SculptHand& hand = m_window->hands().sculpting();
        constexpr int steps = 6;
        const QPoint pixel = view().widgetPosition(from)->toPoint();
        QTest::mouseMove(&view(), pixel);
        QTest::mousePress(&view(), Qt::LeftButton, {}, pixel);
        QVERIFY2(hand.isStroking(), name);
        const double begin = snapshot().time;
        for (int step = 1; step <= steps; ++step) {
            QTest::mouseMove(&view(), pixel + way * step / steps);
            waitUntil([&] { return snapshot().time > begin + time * step / steps; });
        }
        stage(name);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, pixel + way);
        QTRY_VERIFY_WITH_TIMEOUT(!snapshot().playing, patience);
        waitForGesture();
        QVERIFY2(snapshot().health.ok, snapshot().health.message.english().c_str());
    }

    /// Reads a file back: its parts are sound, closed and smooth.
    std::vector<Part> readBack(const char* name, std::size_t count)
    {
        constexpr double sharp = std::numbers::pi / 6; // [rad]
        std::vector<Part> parts = importFile(bytesOf(file(name))).parts;
        const auto check = [&] {
            QCOMPARE(parts.size(), count);
            for (const Part& part : parts) {
                QVERIFY2(part.valid && part.watertight && isWatertight(part.mesh), part.name.c_str());
                QVERIFY2(sharpShare(part.mesh, sharp) < 0.02, part.name.c_str());
            }
        };
        check();
        parts.resize(count); // who goes on after a failure finds as many
        return parts;
    }

    /// None has lost or won material.
    static void verifyVolumes(const std::vector<Part>& now, const std::vector<Part>& before)
    {
        QCOMPARE(now.size(), before.size());
        for (std::size_t p = 0; p < now.size(); ++p)
            QVERIFY2(std::abs(now[p].volume / before[p].volume - 1) < 0.01,
                     qPrintable(QString("%1 of %2 m^3").arg(now[p].volume).arg(before[p].volume)));
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    WatchedApplication application(argc, argv);
    WindowMoreStoriesTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_more_stories_test.moc"
