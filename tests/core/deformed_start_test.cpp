#include "core/session/deformed_start.h"

#include "core/geometry/mass_properties.h"
#include "core/message/message.h"
#include "core/session/deformed_faces.h"
#include "core/session/deformed_frame.h"
#include "core/session/face_fixtures.h"
#include "support/shapes.h"

#include <QtTest>

#include <algorithm>
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
};

QTEST_GUILESS_MAIN(DeformedStartTest)
#include "deformed_start_test.moc"
