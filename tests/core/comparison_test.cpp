#include "core/session/comparison.h"

#include "core/message/message.h"

#include "core/geometry/mass_properties.h"
#include "core/session/measurement.h"
#include "support/material_scenes.h"
#include "support/shapes.h"

#include <QtTest>

using namespace knead;

namespace {

Part boxAt(const std::string& name, const Vec3& size, double x)
{
    Part part;
    part.name = part.path = name;
    part.mesh = shapes::moved(shapes::box(size), {.position = {x, 0, 0}});
    for (const Vec3& vertex : part.mesh.vertices)
        part.box.extend(vertex);
    const MassProperties properties = massProperties(part.mesh);
    part.volume = properties.volume;
    part.area = 2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
    part.watertight = true;
    return part;
}

Model modelOf(std::vector<Part> parts)
{
    Model model;
    model.parts = std::move(parts);
    return model;
}

const Vec3 size(0.02, 0.01, 0.005);

} // namespace

/// Files beside each other. What a project is beside its original is in window_measuring_test and measure_command_test.
class ComparisonTest : public QObject {
    Q_OBJECT

private slots:
    void partsOfOneNameAreTakenOnce()
    {
        const Model model = modelOf({boxAt("bolt", size, 0), boxAt("bolt", size, 0.06), boxAt("bolt", size, 0.12)});
        const Comparison comparison = compareModels(model, model, TaskControl::none());
        QCOMPARE(comparison.bodies.size(), std::size_t{3});
        for (const BodyComparison& body : comparison.bodies)
            QVERIFY(body.largestDistance < 1e-12);
        QVERIFY(comparison.onlyBefore.empty() && comparison.onlyNow.empty());
    }

    void whatBelongsToNothingIsNamed()
    {
        Part open = boxAt("open", size, 0.2);
        open.watertight = false;
        const Model original = modelOf({open, boxAt("lid", size, 0), boxAt("pin", size, 0.06)});
        const Model changed = modelOf({boxAt("pin", size, 0.06)});
        const Comparison comparison = compareModels(original, changed, TaskControl::none());
        QCOMPARE(comparison.bodies.size(), std::size_t{1});
        QVERIFY(comparison.bodies[0].largestDistance < 1e-12);
        QCOMPARE(comparison.onlyBefore, std::vector<std::string>{"lid"});
        QVERIFY_THROWS_EXCEPTION(Problem, compareModels(modelOf({open}), changed, TaskControl::none()));
    }

    /// A part that lost a half lies nowhere far from the whole one; the whole one does from it.
    void bothDirectionsCount()
    {
        const Model whole = modelOf({boxAt("bar", {0.1, 0.01, 0.01}, 0)});
        const Model half = modelOf({boxAt("bar", {0.05, 0.01, 0.01}, -0.025)});
        for (const auto& [a, b] : {std::pair(&whole, &half), std::pair(&half, &whole)}) {
            const Comparison comparison = compareModels(*a, *b, TaskControl::none());
            QVERIFY(std::abs(comparison.bodies.at(0).largestDistance - 0.05) < 1e-9);
            QVERIFY(std::abs(comparison.bodies[0].farthest.x() - 0.05) < 1e-9);
            QVERIFY(std::isnan(comparison.bodies[0].largestDisplacement));
        }
    }

    /// One looks back to when a body was whole, and its surface has the sides of a cut since.
    void whatHasComeApartSinceIsComparedAsItWas()
    {
        auto model = std::make_shared<Model>(modelOf({boxAt("bar", size, 0)}));
        model->parts[0].solids = 1;
        PreparedModel prepared =
            prepareModel(model, {.paths = {"bar"}, .spacing = SpacingChoice{SpacingChoice::Kind::Length, 1.25e-3}},
                         scenes::clay(), TaskControl::none());
        Simulation& simulation = prepared.simulation;
        simulation.post(Cut{.body = 0, .point = Vec3(0.1e-3, 0, 0), .normal = Vec3::UnitX()});
        simulation.applyCommands();
        const FramePointer cut = prepareFrame(prepared.content.bodies, simulation.snapshot(), nullptr);
        FilledModel apart = prepared.content;
        apart.bodies = cut->filled;
        QVERIFY(apart.bodies[0]->mesh.vertices.size() > prepared.content.bodies[0]->mesh.vertices.size());
        const double volume = size.prod();
        for (const FilledModel& content : {prepared.content, apart})
            for (const FramePointer& shown : {prepared.frame, cut}) {
                const Snapshot& present = *cut->snapshot;
                const Comparison comparison = compareWithOriginal(content, *shown, present, TaskControl::none());
                QVERIFY(comparison.bodies.at(0).largestDistance < 1e-7);
                QVERIFY(std::abs(comparison.bodies[0].now.volume / volume - 1) < 1e-3);
                const TriangleMesh& mesh = content.bodies[0]->mesh;
                std::size_t found = 0; // all but what lies in a cut that is not there yet
                for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
                    const Measurement moved{.kind = MeasureKind::point, .places = {{0, t, Vec3::Constant(1.0 / 3)}}};
                    found += measured(moved, content, *shown, present).readings.empty() ? 0 : 1;
                }
                const bool isCutSince = mesh.triangles.size() > shown->filled[0]->mesh.triangles.size();
                QVERIFY(isCutSince ? found > mesh.triangles.size() / 2 : found == mesh.triangles.size());
            }
    }
};

QTEST_APPLESS_MAIN(ComparisonTest)
#include "comparison_test.moc"
