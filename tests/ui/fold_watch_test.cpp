#include "ui/document/fold_watch.h"

#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "support/shapes.h"

#include <QtTest>

#include <functional>
#include <numbers>

using namespace knead;

namespace {

/// A bar along x, 100 x 20 x 20 mm, filled as the window fills it.
PreparedModel bar(const std::function<void(TriangleMesh&)>& change = {})
{
    Part part;
    part.name = "bar";
    part.mesh = shapes::box(Vec3(0.1, 0.02, 0.02));
    if (change)
        change(part.mesh);
    part.faces.resize(6);
    part.solids = part.shells = 1;
    part.watertight = part.valid = true;
    part.volume = massProperties(part.mesh).volume;
    Model model;
    model.parts = {part};
    const ImportFiles import = [model](const std::vector<std::string>& paths, const ImportOptions&, TaskControl&) {
        Model result = model;
        result.file = paths.front();
        return result;
    };
    return prepareFiles(import, {{"folder/part.step"}, {}}, {}, TaskControl::none());
}

/// The first frame with other places of the body.
Frame drawnAs(const PreparedModel& content, const std::function<Vec3(const Vec3&)>& map)
{
    Frame frame = *content.frame;
    auto body = std::make_shared<BodyFrame>(*frame.bodies[0]);
    for (Vec3& place : body->places)
        place = map(place);
    frame.bodies[0] = std::move(body);
    return frame;
}

/// The half x > 0 is turned by an angle about an axis across the bar, a little askew.
Vec3 turnedOver(const Vec3& place, double angle)
{
    if (place.x() <= 0)
        return place;
    const Vec3 center(0, 0, 0.004);
    return center + Eigen::AngleAxisd(angle, Vec3(0.1, -1, 0.15).normalized()) * (place - center);
}

} // namespace

class FoldWatchTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsBentIsNotFolded()
    {
        const PreparedModel content = bar();
        QVERIFY(foldsOf(*content.frame).empty());
        for (const double angle : {0.3, 1.5, 2.5})
            QVERIFY(foldsOf(drawnAs(content, [&](const Vec3& p) {
                        const double turn = angle * (p.x() / 0.1 + 0.5);
                        const double radius = 0.1 / angle - p.z();
                        return Vec3(radius * std::sin(turn), p.y(), radius * std::cos(turn));
                    })).empty());
    }

    void whatPassesThroughItselfIsFoundWhereItDoes()
    {
        const PreparedModel content = bar();
        const std::vector<Fold> folds =
            foldsOf(drawnAs(content, [](const Vec3& place) { return turnedOver(place, 3.1); }));
        QCOMPARE(folds.size(), std::size_t{1});
        QCOMPARE(folds[0].body, BodyId{0});
        QVERIFY(folds[0].place.x() < 0.005 && folds[0].place.x() > -0.055);
        QVERIFY(std::abs(folds[0].place.z()) < 0.012);
        QVERIFY(!folds[0].triangles.empty());
        QVERIFY(std::ranges::adjacent_find(folds[0].triangles, std::ranges::greater_equal{}) ==
                folds[0].triangles.end());
        QVERIFY(folds[0].triangles.back() < content.content.bodies[0]->mesh.triangles.size());
    }

    /// What lies on each other may reach into each other a little.
    void roughnessIsNoFold()
    {
        const PreparedModel content = bar();
        const double spacing = content.content.spacing;
        auto body = std::make_shared<FilledBody>();
        body->aggregate = content.content.bodies[0]->aggregate;
        body->mesh = refine(shapes::box(Vec3(0.1, 0.02, 0.02)), spacing);
        const std::size_t lower = body->mesh.vertices.size();
        const TriangleMesh first = body->mesh;
        for (const Vec3& vertex : first.vertices)
            body->mesh.vertices.emplace_back(vertex + Vec3(0, 0, 0.05));
        for (const TriangleMesh::Triangle& t : first.triangles)
            body->mesh.triangles.push_back({static_cast<std::uint32_t>(t[0] + lower),
                                            static_cast<std::uint32_t>(t[1] + lower),
                                            static_cast<std::uint32_t>(t[2] + lower)});
        const auto folds = [&](double overlap) {
            auto drawn = std::make_shared<BodyFrame>();
            drawn->places = body->mesh.vertices;
            for (std::size_t v = lower; v < drawn->places.size(); ++v)
                drawn->places[v] = Eigen::AngleAxisd(0.15, Vec3::UnitZ()) *
                                   Vec3(drawn->places[v] - Vec3(0, 0, 0.03 + overlap * spacing));
            Frame frame = *content.frame;
            frame.filled[0] = body;
            frame.bodies[0] = std::move(drawn);
            return foldsOf(frame).size();
        };
        QCOMPARE(folds(0.02), std::size_t{0});
        QCOMPARE(folds(0.3), std::size_t{1});
    }

    /// What does not deform has no folds of its own.
    void rigidBodiesAreLeftOut()
    {
        const PreparedModel content = bar();
        Frame frame = drawnAs(content, [](const Vec3& place) { return turnedOver(place, 3.1); });
        Snapshot rigid = *frame.snapshot;
        rigid.bodies[0].kind = BodyKind::rigid;
        frame.snapshot = std::make_shared<const Snapshot>(std::move(rigid));
        QVERIFY(foldsOf(frame).empty());
    }
};

QTEST_GUILESS_MAIN(FoldWatchTest)
#include "fold_watch_test.moc"
