#include "support/thread_limit.h" // TBB: before Qt

#include "core/session/deformed_start.h"

#include "core/deformation/number_map.h"
#include "core/geometry/mass_properties.h"
#include "core/message/message.h"
#include "core/session/deformed_faces.h"
#include "core/session/deformed_frame.h"
#include "core/session/face_fixtures.h"
#include "core/session/physical_deforming.h"
#include "core/simulation/moment.h"
#include "core/simulation/replay.h"
#include "support/material_scenes.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace knead;

namespace {

constexpr double length = 0.1;     // of the bars, along x [m]
constexpr double thickness = 0.01; // across [m]
const Vec3 barSize(length, thickness, thickness);

/// A mesh with the faces of a box; no exact shape.
Part bar(const std::string& name, const Vec3& place)
{
    Part part;
    part.name = part.path = name;
    part.mesh = shapes::moved(shapes::box(barSize), {.position = place});
    part.faces.resize(6);
    part.solids = part.shells = 1;
    part.watertight = part.valid = true;
    part.volume = massProperties(part.mesh).volume;
    for (const Vec3& vertex : part.mesh.vertices)
        part.box.extend(vertex);
    return part;
}

Model bars(std::size_t count)
{
    Model model;
    model.file = "bars.step";
    for (std::size_t i = 0; i < count; ++i) {
        model.parts.push_back(bar("bar " + std::to_string(i), {0, 0, 0.1 * static_cast<double>(i)}));
        model.tree.children.push_back({model.parts.back().name, i, {}});
    }
    return model;
}

PreparedModel filled(const Model& model)
{
    ImportChoices choices{.paths = {"bars.step"}, .options = {}};
    choices.spacing = SpacingChoice{SpacingChoice::Kind::Length, thickness / 4};
    return prepareModel(std::make_shared<const Model>(model), choices, {}, TaskControl::none());
}

/// Between the ends of a bar, about its middle, toward z.
NumberDeformation quarterTurn()
{
    return {.kind = NumberKind::bend, .from = -length / 2, .to = length / 2, .angle = std::numbers::pi / 2};
}

DeformationRequest requestOf(const NumberDeformation& deformation, std::vector<bool> which = {})
{
    return {std::make_shared<const std::vector<Deformation>>(std::vector<Deformation>{deformation}), std::move(which)};
}

/// Nothing here has an exact shape.
WrittenModel writeNothing(const ExportJob& /*job*/, TaskControl& /*control*/)
{
    throw Problem(Message("Deformation", "A mesh was written."));
}

PreparedDeformation deformed(const PreparedModel& before, const DeformationRequest& request,
                             const std::vector<FaceFixture>& fixtures = {})
{
    return prepareDeformation(before.content, before.frame, fixtures, request, writeNothing, TaskControl::none());
}

Box boxOf(const std::vector<Vec3>& places)
{
    Box box;
    for (const Vec3& place : places)
        box.extend(place);
    return box;
}

// ---- By physics ----

constexpr double spacing = 2e-3;               // [m]
const Eigen::Vector3i slender(56, 4, 4);       // cells
const double side = spacing * slender.y();     // of the section [m]
const double half = spacing * slender.x() / 2; // of the bar [m]
constexpr double modulus = 1e6;                // [Pa]

Material rubber(double poisson = 0.3)
{
    return {.density = 1100, .youngsModulus = modulus, .poissonRatio = poisson, .dampingRatio = 0.05};
}

Scene sceneOf(const Eigen::Vector3i& cells, const Material& material)
{
    Scene scene;
    scene.bodies.push_back(scenes::box(cells, spacing, material));
    scene.integrator = Integrator::automatic;
    return scene;
}

/// Along x, toward z, with planes so far from the middle.
PhysicalDeformation byPhysics(NumberKind kind, double plane)
{
    return {.numbers = {.kind = kind,
                        .from = -plane,
                        .to = plane,
                        .angle = std::numbers::pi / 6,
                        .factor = 1.05,
                        .shift = plane / 4}};
}

/// Led by grips through states of balance. @return the state at the end
std::shared_ptr<Snapshot> balanced(const Scene& scene, const PhysicalDeformation& deformation)
{
    constexpr int loadSteps = 4;
    const double step = deformation.duration / loadSteps;
    Simulation simulation(scene);
    for (Command& command : addedGrips(deformation, heldEnds(deformation, *simulation.snapshot(), {"bar"})))
        simulation.post(std::move(command));
    EndGrips grips(deformation, 0);
    for (int i = 0; i <= loadSteps; ++i) {
        const EndGrips::Moves moves = grips.follow(simulation.time(), step, step);
        for (FixtureId end = 0; end < 2; ++end)
            if (moves[end])
                simulation.post(MoveFixture{end, moves[end]->velocity, moves[end]->turn});
        if (i < loadSteps && !simulation.findBalance(step).converged)
            throw std::runtime_error("no balance");
    }
    return grips.isOver() ? simulation.snapshot() : nullptr;
}

/// The middle of all objects that began at an x.
Vec3 middleAt(double x, const Aggregate& aggregate, const std::vector<Vec3>& places)
{
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (ObjectIndex i = 0; i < aggregate.size(); ++i)
        if (std::abs(aggregate.lattice.position(i).x() - x) < spacing / 4) {
            sum += places[i];
            ++count;
        }
    return sum / count;
}

DeformedByPhysics run(const Scene& scene, const PhysicalDeformation& deformation)
{
    return deformByPhysics(Simulation(scene), deformation, {"bar"}, {}, std::size_t{1} << 28U, TaskControl::none());
}

std::vector<Vec3> placesIn(const Moment& moment)
{
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < moment.bodies[0].position.size(); ++i)
        places.push_back(moment.bodies[0].position.at(i));
    return places;
}

/// Of what grips hold from where the formula takes it [m].
double farthestOfHeld(const Scene& scene, const PhysicalDeformation& deformation,
                      const std::vector<std::optional<Fixture>>& grips, const std::vector<Vec3>& places)
{
    const NumberMap map(deformation.numbers);
    double farthest = 0;
    for (const auto& grip : grips)
        for (const ObjectIndex object : grip ? grip->objects : std::vector<ObjectIndex>())
            farthest = std::max(farthest,
                                (map.at(scene.bodies[0].aggregate->lattice.position(object)) - places[object]).norm());
    return farthest;
}

} // namespace

class DeformedStartTest : public QObject {
    Q_OBJECT

    PreparedModel m_before = filled(bars(1));

private slots:
    /// By Pappus: the line of the centroids keeps its length.
    void aBentBarIsFilledWithAsMuchMaterial()
    {
        const PreparedDeformation after = deformed(m_before, requestOf(quarterTurn()));
        const Part& part = after.prepared.content.model->parts[0];
        const double radius = length / (std::numbers::pi / 2);
        QVERIFY(std::abs(part.volume / (length * thickness * thickness) - 1) < 2e-3);
        QVERIFY(std::abs(part.box.sizes().x() - (radius + thickness / 2)) < 1e-5);
        QVERIFY(std::abs(part.box.sizes().z() - (radius + thickness / 2)) < 1e-5);
        QCOMPARE(part.faces.size(), std::size_t{6});
        QCOMPARE(after.prepared.content.spacing, m_before.content.spacing);
        QVERIFY(after.prepared.content.bodies[0]->aggregate->size() > 100);
        QCOMPARE(after.prepared.content.bodies[0]->name, m_before.content.bodies[0]->name);
    }

    /// The end at the second plane is the middle of the turned face.
    void fixturesStayOnTheirFaces()
    {
        FaceFixture fixture{.key = 3, .name = "Fixture 1", .body = 0, .faces = {1}, .id = {}}; // +x
        const PreparedDeformation after = deformed(m_before, requestOf(quarterTurn()), {fixture});
        QCOMPARE(after.prepared.fixtures.size(), std::size_t{1});
        QCOMPARE(after.prepared.fixtures[0].faces, std::vector<std::uint32_t>{1});
        QCOMPARE(after.prepared.scene.fixtures.size(), std::size_t{1});
        const Fixture& held = after.prepared.scene.fixtures[0];
        const Aggregate& aggregate = *after.prepared.content.bodies[0]->aggregate;
        const double radius = length / (std::numbers::pi / 2);
        for (const ObjectIndex object : held.objects)
            QVERIFY((aggregate.lattice.position(object) - Vec3(-length / 2 + radius, 0, radius)).norm() < thickness);
    }

    void onlyTheChosenPartIsDeformed()
    {
        const PreparedModel before = filled(bars(2));
        const std::vector<Part>& rest = before.content.model->parts;
        NumberDeformation turn = quarterTurn();
        turn.origin += rest[1].box.center() - rest[0].box.center();
        const PreparedDeformation after = deformed(before, requestOf(turn, {false, true}));
        const std::vector<Part>& parts = after.prepared.content.model->parts;
        QVERIFY(parts[0].mesh.vertices == rest[0].mesh.vertices);
        QVERIFY(parts[1].box.sizes().x() < 0.8 * length);
        QVERIFY(after.report.parts.empty());
    }

    /// What reaches below the floor would be thrown up.
    void theFloorGoesDownWithThePart()
    {
        NumberDeformation down = quarterTurn();
        down.angle = -down.angle;
        const PreparedDeformation after = deformed(m_before, requestOf(down));
        QCOMPARE(*after.prepared.scene.floorHeight, after.prepared.content.box.min().z());
        const PreparedDeformation up = deformed(m_before, requestOf(quarterTurn()));
        QVERIFY(*up.prepared.scene.floorHeight <= *m_before.scene.floorHeight);
    }

    /// Split in two, each half of a face is still of it; and numbers may be others.
    void facesAreFoundAgainByWhereTheyLie()
    {
        const TriangleMesh before = shapes::box(barSize);
        TriangleMesh now = before;
        for (std::uint32_t t = 0; t < now.triangles.size(); ++t)
            now.faceOfTriangle[t] = static_cast<std::uint32_t>(now.triangles.size()) - 1 - t;
        const std::vector<std::uint32_t> origin = facesBefore(now, now.triangles.size(), before);
        for (std::uint32_t face = 0; face < origin.size(); ++face)
            QCOMPARE(origin[face], before.faceOfTriangle[now.triangles.size() - 1 - face]);
    }

    void aPreviewIsWhatTheMapMakesOfTheSurface()
    {
        const NumberDeformation bend = quarterTurn();
        const auto map = mapOf(Deformation(bend));
        const DeformedFrame seen = deformedFrame(m_before.frame, *map, {});
        const std::vector<Vec3>& rest = m_before.frame->bodies[0]->places;
        for (std::size_t i = 0; i < rest.size(); i += 7)
            QVERIFY((seen.frame->bodies[0]->places[i] - map->at(rest[i])).norm() < 1e-15);
        QVERIFY(!seen.fold);
        const double farthest = *std::ranges::max_element(seen.ways[0]);
        QVERIFY(std::abs(seen.largestWay - farthest) < 1e-12 && farthest > length / 2);
        QVERIFY(deformedFrame(m_before.frame, *map, {false}).frame->bodies[0] == m_before.frame->bodies[0]);
        QCOMPARE(boxOf(seen.frame->bodies[0]->places).sizes().y(), thickness);
    }

    /// The innermost fiber of a bar shrinks to nothing where the radius of its middle is half of its thickness.
    void aFoldIsSeenInThePreview()
    {
        NumberDeformation bend = quarterTurn();
        for (const double share : {0.98, 1.02}) {
            bend.angle = length / (share * thickness / 2);
            const DeformedFrame seen = deformedFrame(m_before.frame, *mapOf(Deformation(bend)), {});
            QCOMPARE(seen.fold.has_value(), share < 1);
        }
    }

    /// The rigid motion is that of the map with a share of the whole.
    void rigidEndsGoAsTheFormulaSays()
    {
        for (const NumberKind kind : {NumberKind::bend, NumberKind::twist, NumberKind::stretch, NumberKind::shear})
            for (const double stays : {0.0, 0.3, 1.0}) {
                NumberDeformation whole = byPhysics(kind, half).numbers;
                whole.origin = Vec3(0.01, 0.02, 0.03);
                whole.neutral = kind == NumberKind::bend ? 1e-3 : 0;
                whole.stays = stays;
                NumberDeformation part = whole;
                part.angle *= 0.4;
                part.factor = 1 + 0.4 * (whole.factor - 1);
                part.shift *= 0.4;
                const NumberMap map(part);
                for (const bool isFirst : {true, false}) {
                    const NumberEnd end = isFirst ? NumberEnd::first : NumberEnd::second;
                    const EndPlace rest = endPlace(whole, end, 0);
                    const EndPlace now = endPlace(whole, end, 0.4);
                    const Vec3 arm(isFirst ? -2e-3 : 3e-3, 4e-3, -5e-3);
                    const Vec3 gone = now.place + Eigen::AngleAxisd(now.angle, turnAxis(whole)) * arm;
                    QVERIFY((map.at(rest.place + arm) - gone).norm() < 1e-15);
                }
            }
    }

    /// Whatever the steps, and from a moment in the midst of it.
    void gripsEndTheirWayExactly()
    {
        const PhysicalDeformation bend = byPhysics(NumberKind::bend, half);
        for (const double from : {0.0, 0.37}) {
            EndGrips grips = from == 0 ? EndGrips(bend, 0) : EndGrips(bend, 0, from);
            double time = from;
            for (int step = 0; step < 400 && !grips.isOver(); ++step) {
                const double length = std::array{1.0 / 60, 1.0 / 120, 1.0 / 240}.at(static_cast<std::size_t>(step % 3));
                grips.follow(time, length, EndGrips::leastHorizon);
                time += length;
            }
            QVERIFY(grips.isOver() && time < 1.5);
            const EndPlace end = endPlace(bend.numbers, NumberEnd::second, 1);
            QVERIFY((grips.placeOf(NumberEnd::second).place - end.place).norm() < 1e-9 * half);
            QVERIFY(std::abs(grips.placeOf(NumberEnd::second).angle - end.angle) < 1e-8);
            QCOMPARE(grips.placeOf(NumberEnd::first).angle, 0.0);
        }
    }

    /// M = E I kappa: a long bar between grips is an arc of a circle, but near these, which keep sections as they are.
    void aBarBetweenGripsHasOneCurvature()
    {
        const Scene scene = sceneOf(slender, rubber());
        const PhysicalDeformation bend = byPhysics(NumberKind::bend, half - 1.5 * side);
        const auto now = balanced(scene, bend);
        QVERIFY(now != nullptr);
        const std::vector<Vec3>& places = now->bodies[0].positions;
        QVERIFY(farthestOfHeld(scene, bend, {now->fixtures[0], now->fixtures[1]}, places) < 1e-15);
        const double curvature = bend.numbers.angle / bend.numbers.length();
        const Aggregate& aggregate = *scene.bodies[0].aggregate;
        for (int cell = -10; cell <= 10; cell += 2) {
            const Vec3 before = middleAt((cell - 2) * spacing, aggregate, places);
            const Vec3 at = middleAt(cell * spacing, aggregate, places);
            const Vec3 after = middleAt((cell + 2) * spacing, aggregate, places);
            const Vec3 turned = (at - before).cross(at - after);
            const double measured =
                2 * turned.norm() / (at - before).norm() / (after - at).norm() / (after - before).norm();
            QVERIFY2(std::abs(measured / curvature - 1) < 0.01, qPrintable(QString::number(measured / curvature)));
        }
        // The moment of both grips about the middle of the bar as it is.
        const Vec3 middle = middleAt(0, aggregate, places);
        const double expected = modulus * std::pow(side, 4) / 12 * curvature;
        for (const std::size_t end : {0, 1}) {
            const Vec3 moment =
                now->fixtureMoments[end] + (now->fixtureCenters[end] - middle).cross(now->fixtureForces[end]);
            QVERIFY2(std::abs(moment.norm() / expected - 1) < 0.03,
                     qPrintable(QString::number(moment.norm() / expected)));
        }
    }

    /// By nu times as much, where the grips are far away.
    void aStretchedBarGetsThinner()
    {
        const double poisson = 0.3;
        const Scene scene = sceneOf({24, 6, 6}, rubber(poisson));
        const auto now = balanced(scene, byPhysics(NumberKind::stretch, 11 * spacing));
        QVERIFY(now != nullptr);
        const Aggregate& aggregate = *scene.bodies[0].aggregate;
        const std::vector<Vec3>& places = now->bodies[0].positions;
        const auto x = [&](int cell) { return middleAt(cell * spacing, aggregate, places).x(); };
        const double strain = (x(4) - x(-4)) / (8 * spacing) - 1;
        double width = 0;
        int count = 0;
        for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
            const Vec3 rest = aggregate.lattice.position(i);
            if (std::abs(rest.x()) < spacing / 4 && std::abs(rest.y()) > 2.75 * spacing) {
                width += std::abs(places[i].y());
                ++count;
            }
        }
        const double thinner = 1 - 2 * width / count / (6 * spacing);
        QVERIFY(std::abs(strain / 0.05 - 1) < 0.04); // grips keep the sections at the ends from getting thinner
        QVERIFY2(std::abs(thinner / strain / poisson - 1) < 0.03, qPrintable(QString::number(thinner / strain)));
        const double force = -now->fixtureForces[1].x();
        QVERIFY(std::abs(force / (modulus * std::pow(6 * spacing, 2) * strain) - 1) < 0.05);
    }

    /// Recorded, it comes to the same bits again, on any number of threads; what was seen leads to its end.
    void clayKeepsItsVolumeAndItsRecording()
    {
        const Scene scene = sceneOf({20, 4, 4}, scenes::clay());
        PhysicalDeformation bend = byPhysics(NumberKind::bend, 5 * spacing);
        bend.numbers.angle *= 2;
        bend.duration = 0.5;
        const DeformedByPhysics done = run(scene, bend);
        const Moment& end = *done.gesture.moment;
        const Aggregate& aggregate = *scene.bodies[0].aggregate;
        const std::vector<Vec3> places = placesIn(end);
        QVERIFY(farthestOfHeld(scene, bend, end.fixtures, places) < 1e-10);
        const double before = scenes::blockVolume(aggregate, Simulation(scene).snapshot()->bodies[0].positions);
        QVERIFY(std::abs(scenes::blockVolume(aggregate, places) / before - 1) < 5e-3);
        QVERIFY(done.film.underWay().size() > 10);
        QCOMPARE(done.film.underWay().back()->step, end.steps.count);
        for (const int threads : {1, 4})
            onThreads(threads, [&] {
                QCOMPARE(replay(Simulation(scene), done.gesture.commands, end.steps.count).stateHash(),
                         done.gesture.hash);
            });
    }

    /// Rubber is straight again, but for what the held end keeps.
    void whatIsLetGoSpringsBack()
    {
        const Scene scene = sceneOf({20, 4, 4}, rubber());
        PhysicalDeformation bend = byPhysics(NumberKind::bend, 6 * spacing);
        bend.duration = 0.2;
        bend.letsGo = true;
        bend.numbers.stays = 1;
        const DeformedByPhysics done = run(scene, bend);
        const Moment& end = *done.gesture.moment;
        QVERIFY(!end.fixtures[0] && end.fixtures[1]);
        const std::vector<Vec3> places = placesIn(end);
        double farthest = 0;
        for (ObjectIndex i = 0; i < places.size(); ++i)
            farthest = std::max(farthest, (places[i] - scene.bodies[0].aggregate->lattice.position(i)).norm());
        QVERIFY2(farthest < 0.1 * spacing, qPrintable(QString::number(farthest)));
    }

    void whatGripsCannotDoIsSaid_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* name, NumberKind kind, double from, double to, const char* words) {
            QTest::newRow(name) << static_cast<int>(kind) << from << to << QString(words);
        };
        row("taper", NumberKind::taper, -0.01, 0.01, "do it exactly");
        row("beside", NumberKind::twist, 0.06, 0.08, "\"bar\" lies wholly beyond");
        row("one side", NumberKind::twist, 0, 0.05, "\"bar\" does not reach both");
        row("too near", NumberKind::shear, 0, 0.003, "two spacings");
        row("fold", NumberKind::bend, -0.002, 0.002, "would fold");
    }
    void whatGripsCannotDoIsSaid()
    {
        QFETCH(int, kind);
        QFETCH(double, from);
        QFETCH(double, to);
        QFETCH(QString, words);
        PhysicalDeformation wanted = byPhysics(static_cast<NumberKind>(kind), half);
        wanted.numbers.from = from;
        wanted.numbers.to = to;
        wanted.numbers.angle *= 3;
        try {
            run(sceneOf({20, 4, 4}, rubber()), wanted);
            QFAIL("it was done");
        } catch (const Problem& problem) {
            QVERIFY2(QString(problem.what()).contains(words), problem.what());
        }
    }

    /// A plane at the end of a bar has nothing beyond: its last layer is held.
    void planesMayBeAtTheEnds()
    {
        const Scene scene = sceneOf({20, 4, 4}, rubber());
        const auto rest = Simulation(scene).snapshot();
        for (const double plane : {10 * spacing, 10.4 * spacing}) {
            const std::vector<HeldEnds> held = heldEnds(byPhysics(NumberKind::twist, plane), *rest, {"bar"});
            QCOMPARE(held.size(), std::size_t{1});
            QCOMPARE(held[0].first.size(), std::size_t{25});
            QCOMPARE(held[0].second.size(), std::size_t{25});
        }
    }
};

QTEST_GUILESS_MAIN(DeformedStartTest)
#include "deformed_start_test.moc"
