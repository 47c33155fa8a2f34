// A session as a field: where the places of its parts went.
#include "core/session/session_field.h"

#include "core/skin/former_shape.h"
#include "support/scenes.h"
#include "support/shapes.h"

#include <QtTest>

#include <algorithm>

using namespace knead;

namespace {

constexpr double spacing = 0.002;
const Vec3 size(0.03, 0.01, 0.008);

FilledModel filled(const std::shared_ptr<const Aggregate>& aggregate)
{
    auto model = std::make_shared<Model>();
    Part& part = model->parts.emplace_back();
    part.name = "bar";
    part.mesh = shapes::box(size);
    part.watertight = true;
    FilledModel content;
    content.bodies = {filledBody(*model, 0, "bar", aggregate, TaskControl::none())};
    content.model = std::move(model);
    content.spacing = spacing;
    return content;
}

std::shared_ptr<const Aggregate> barOf(double fineness)
{
    return std::make_shared<const Aggregate>(fill(shapes::box(size), {.spacing = fineness}));
}

/// Where a bend and a stretch would take a place.
Vec3 bent(const Vec3& x)
{
    return {1.05 * x.x(), x.y() + 2 * x.x() * x.x(), x.z() - 0.1 * x.x()};
}

std::vector<Vec3> bentPlaces(std::vector<Vec3> places)
{
    std::ranges::transform(places, places.begin(), bent);
    return places;
}

FramePointer frameOf(const FilledModel& content, const std::shared_ptr<const Aggregate>& aggregate,
                     std::vector<Vec3> positions, std::vector<BrokenConnection> broken = {})
{
    auto snapshot = std::make_shared<Snapshot>();
    Snapshot::BodyState& state = snapshot->bodies.emplace_back();
    state.positions = std::move(positions);
    state.aggregate = aggregate;
    if (!broken.empty())
        state.broken = std::make_shared<const std::vector<BrokenConnection>>(std::move(broken));
    snapshot->materials.emplace_back();
    return prepareFrame(content.bodies, std::move(snapshot), nullptr);
}

/// All connections across a plane x = `where`.
std::vector<BrokenConnection> cutAt(const Aggregate& aggregate, double where)
{
    std::vector<BrokenConnection> broken;
    aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex upper) {
        if ((aggregate.lattice.position(lower).x() < where) != (aggregate.lattice.position(upper).x() < where))
            broken.push_back({{d, lower}});
    });
    return broken;
}

double largestDifference(const DisplacementField& field)
{
    double largest = 0;
    for (std::size_t i = 0; i < field.nodes.size(); ++i)
        largest = std::max(largest, (field.nodes[i] + field.displacements[i] - bent(field.nodes[i])).norm());
    return largest;
}

} // namespace

class SessionFieldTest : public QObject {
    Q_OBJECT

private slots:
    void placesWentWhereTheObjectsWent()
    {
        const auto aggregate = barOf(spacing);
        const FilledModel content = filled(aggregate);
        const FramePointer frame = frameOf(content, aggregate, bentPlaces(aggregate->lattice.positions()));
        const SessionField session = sessionField(content, *frame, TaskControl::none());
        QCOMPARE(session.bodies.size(), std::size_t{1});
        QVERIFY(session.leftOut.empty());
        const DisplacementField& field = session.bodies[0].field;
        QVERIFY(field.nodes.size() > content.bodies[0]->mesh.vertices.size()); // and objects inside
        QVERIFY2(largestDifference(field) < 2e-6, qPrintable(QString::number(largestDifference(field))));
        std::vector<std::array<double, 3>> places;
        for (const Vec3& node : field.nodes)
            places.push_back({node.x(), node.y(), node.z()});
        std::ranges::sort(places);
        QVERIFY(std::ranges::adjacent_find(places) == places.end());
        QCOMPARE(joinedField(session).nodes.size(), field.nodes.size());
    }

    /// Half of the way before the body was filled anew, and half of it after that.
    void placesAreThoseOfTheOpenedPart()
    {
        const auto first = barOf(spacing);
        const FilledModel content = filled(first);
        const Vec3 half(0, 0, 0.003);
        const auto former = std::make_shared<const FormerShape>(first, std::vector<Vec3>(first->size(), half));
        auto later = std::make_shared<Aggregate>(*first); // the same lattice, moved
        later->lattice.origin += half;
        later->former = former;
        std::vector<Vec3> now = later->lattice.positions();
        for (Vec3& place : now)
            place += half;
        const SessionField session = sessionField(content, *frameOf(content, later, now), TaskControl::none());
        const DisplacementField& field = session.bodies[0].field;
        QVERIFY(!field.isEmpty());
        const Box around(-0.5 * size - Vec3::Constant(1e-9), size + Vec3::Constant(1e-9));
        for (std::size_t i = 0; i < field.nodes.size(); ++i) {
            QVERIFY((field.displacements[i] - 2 * half).norm() < 1e-9);
            QVERIFY(around.contains(field.nodes[i]));
        }
    }

    void ofABodyInPiecesItIsTheLargest()
    {
        const auto aggregate = barOf(spacing);
        const FilledModel content = filled(aggregate);
        const double low = aggregate->lattice.positions().front().x();
        const double where = boxOfPlaces(content.bodies[0]->mesh.vertices).min().x() + 0.35 * size.x();
        std::vector<Vec3> places = aggregate->lattice.positions();
        for (Vec3& place : places)
            place.x() += place.x() < where ? -0.01 : 0.002;
        const SessionField session =
            sessionField(content, *frameOf(content, aggregate, places, cutAt(*aggregate, where)), TaskControl::none());
        QCOMPARE(session.leftOut.size(), std::size_t{1});
        const DisplacementField& field = session.bodies[0].field;
        QVERIFY(!field.isEmpty() && low < where);
        for (std::size_t i = 0; i < field.nodes.size(); ++i) {
            QVERIFY(std::abs(field.displacements[i].x() - 0.002) < 1e-5);
            QVERIFY(field.nodes[i].x() > where - spacing);
        }
    }
};

QTEST_APPLESS_MAIN(SessionFieldTest)
#include "session_field_test.moc"
