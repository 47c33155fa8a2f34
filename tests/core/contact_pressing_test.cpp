#include "core/mechanics/contacts.h"
#include "support/scenes.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <numeric>

using namespace knead;

namespace {

constexpr double spacing = 1e-3;
constexpr int cells = 4;
constexpr double bottom = -0.5 * cells * spacing;
constexpr ContactStep step{.duration = 1e-6};

Material rubber(double adhesion = 0)
{
    Material material;
    material.youngsModulus = 1e6;
    material.adhesion = adhesion;
    return material;
}

/// A cube centered at the origin, or beside it.
struct Cube {
    MaterialMap materials;
    std::shared_ptr<const Aggregate> aggregate;
    ObjectState state;
    StructuralConnections connections;

    explicit Cube(const Vec3& place = Vec3::Zero(), const Material& material = rubber())
        : materials(material, scenes::box({cells, cells, cells}, spacing).aggregate->size())
        , aggregate(scenes::box({cells, cells, cells}, spacing).aggregate)
        , state(objectsAtRest(*aggregate))
        , connections(aggregate, materials)
    {
        state.mass.assign(state.size(), 1e-6);
        state.inverseMass.assign(state.size(), 1e6);
        move(place);
    }

    void move(const Vec3& by)
    {
        for (std::size_t i = 0; i < state.size(); ++i)
            state.position.add(i, by);
    }

    bool isAtBottom(std::size_t i) const
    {
        return aggregate->lattice.position(static_cast<ObjectIndex>(i)).z() < bottom + 0.5 * spacing;
    }

    Contacts::BodyView view(BodyKind kind = BodyKind::deformable) { return {&state, &connections, &materials, kind}; }
};

/// @param depth how far it reaches into a cube at the origin [m]
RigidSurface floorInto(double depth)
{
    RigidSurface floor;
    floor.isFloor = true;
    floor.pose.position = Vec3(0, 0, bottom + depth);
    return floor;
}

Vec3 sumOf(const std::vector<Vec3>& forces)
{
    return std::accumulate(forces.begin(), forces.end(), Vec3(Vec3::Zero()));
}

bool isNear(const Vec3& a, const Vec3& b, double scale)
{
    return (a - b).norm() < 1e-12 * scale;
}

} // namespace

/// What presses on objects, as the colors of the skin show it.
class ContactPressingTest : public QObject {
    Q_OBJECT

private slots:
    void nothingPressesWithoutTouch()
    {
        Cube cube;
        const Contacts contacts({cube.view()}, VicinityMethod::uniformGrid);
        const RigidSurface below = floorInto(-1e-5);
        const auto forces = contacts.pressingForces({&below, 1}, step);
        QCOMPARE(forces.size(), std::size_t{1});
        QCOMPARE(forces[0].size(), cube.state.size());
        for (const Vec3& force : forces[0])
            QVERIFY(force.isZero(0));
    }

    /// The force is that of the stiffening spring (ContactParameters), wherever it is shared out: k d (1 + (d / d0)^4).
    void aFloorPressesTheLowestLayerByItsStiffness()
    {
        Material firm = rubber();
        firm.poissonRatio = 0.4; // springs alone do not stiffen
        Cube cube(Vec3::Zero(), firm);
        const Contacts contacts({cube.view()}, VicinityMethod::uniformGrid);
        const auto press = [&](double depth) {
            const RigidSurface floor = floorInto(depth);
            const auto forces = contacts.pressingForces({&floor, 1}, step);
            for (std::size_t i = 0; i < cube.state.size(); ++i) {
                QVERIFY(cube.isAtBottom(i) ? forces[0][i].z() > 0 : forces[0][i].isZero(0));
                QVERIFY(forces[0][i].head<2>().isZero(0));
            }
        };
        const auto sum = [&](double depth) {
            const RigidSurface floor = floorInto(depth);
            return sumOf(contacts.pressingForces({&floor, 1}, step)[0]).z();
        };
        const double d0 = 0.034 * spacing;
        press(d0);
        const double section = std::pow(cells * spacing, 2);
        const double k = sum(1e-3 * d0) / (1e-3 * d0);
        const double flat = 16 * firm.shearModulus() * section / spacing;
        QVERIFY2(k > 0.6 * flat && k < 1.4 * flat, qPrintable(QString::number(k / flat)));
        QVERIFY(std::abs(sum(d0) / (2 * k * d0) - 1) < 1e-5);
        QVERIFY(std::abs(sum(2 * d0) / (17 * k * 2 * d0) - 1) < 1e-5);
    }

    void aToolTurnedToTheSidePressesAlongItsFace()
    {
        Cube cube;
        const Contacts contacts({cube.view()}, VicinityMethod::uniformGrid);
        const double size = 10 * cells * spacing;
        RigidSurface tool;
        tool.shape.size = Vec3::Constant(size);
        tool.pose.position = Vec3(-bottom + 0.5 * size - 0.2e-3, 0, 0); // 0.2 mm into the side that looks along x
        const auto forces = contacts.pressingForces({&tool, 1}, step);
        const Vec3 sum = sumOf(forces[0]);
        QVERIFY(sum.x() < -1e-6);
        QVERIFY(isNear(sum, Vec3(sum.x(), 0, 0), sum.norm()));
    }

    /// Of bodies at rest it is what the step itself does to them, which goes another way: with lists of its own.
    void itIsWhatTheStepAddsToBodiesAtRest()
    {
        Cube lower;
        Cube upper(Vec3(0.3 * spacing, 0.1 * spacing, cells * spacing));
        Contacts contacts({lower.view(), upper.view()}, VicinityMethod::uniformGrid);
        upper.move(Vec3(0, 0, -0.2 * spacing)); // into each other by a fifth
        const RigidSurface floor = floorInto(0.1e-3);
        contacts.updateVicinity({&floor, 1}, spacing, spacing);
        const auto forces = contacts.pressingForces({&floor, 1}, step);
        const Contacts::Report report = contacts.computeForces({&floor, 1}, step);
        double largest = 0;
        for (const Vec3& force : forces[1])
            largest = std::max(largest, force.norm());
        QVERIFY(largest > 1e-6);
        const std::array<const ObjectState*, 2> states{&lower.state, &upper.state};
        for (std::size_t b = 0; b < 2; ++b)
            for (std::size_t i = 0; i < forces[b].size(); ++i)
                QVERIFY(isNear(forces[b][i], states[b]->force.at(i), largest));
        QVERIFY(
            isNear(sumOf(forces[0]) + sumOf(forces[1]), -report.loads[0].force, 10)); // what is between them cancels
        QVERIFY(sumOf(forces[1]).z() > 0);
    }

    void lookingChangesNothing()
    {
        Cube cube;
        Contacts contacts({cube.view()}, VicinityMethod::uniformGrid);
        const RigidSurface floor = floorInto(0.2e-3);
        contacts.updateVicinity({&floor, 1}, 0, 0);
        const std::size_t listings = contacts.listings();
        const auto once = contacts.pressingForces({&floor, 1}, step);
        const auto twice = contacts.pressingForces({&floor, 1}, step);
        QVERIFY(once == twice);
        QCOMPARE(contacts.listings(), listings);
        for (std::size_t i = 0; i < cube.state.size(); ++i)
            QVERIFY(cube.state.force.at(i).isZero(0) && cube.state.damping.at(i).isZero(0));
    }

    /// Before a step has listed anything, as after going to a moment.
    void noListIsNeeded()
    {
        Cube lower;
        Cube upper(Vec3(0, 0, 1.5 * cells * spacing));
        const Contacts contacts({lower.view(), upper.view()}, VicinityMethod::uniformGrid);
        upper.move(Vec3(0, 0, -0.55 * cells * spacing));
        const auto forces = contacts.pressingForces({}, step);
        QVERIFY(sumOf(forces[1]).z() > 1e-6);
        QVERIFY(isNear(sumOf(forces[0]), -sumOf(forces[1]), 1));
    }

    void whatStaysInPlaceAndWhatIsJoinedIsNotPressed()
    {
        Cube glue;
        const Contacts still({glue.view(BodyKind::glue)}, VicinityMethod::uniformGrid);
        const RigidSurface floor = floorInto(0.2e-3);
        QVERIFY(sumOf(still.pressingForces({&floor, 1}, step)[0]).isZero(0));

        const auto pressedWith = [](double adhesion) {
            Cube lower(Vec3::Zero(), rubber(adhesion));
            Cube upper(Vec3(0, 0, 1.5 * cells * spacing), rubber(adhesion));
            Contacts contacts({lower.view(), upper.view()}, VicinityMethod::uniformGrid);
            upper.move(Vec3(0, 0, -0.55 * cells * spacing));
            contacts.updateVicinity({}, cells * spacing, 0);
            contacts.computeForces({}, step); // what sticks makes joints
            return sumOf(contacts.pressingForces({}, step)[1]).z();
        };
        QVERIFY(pressedWith(0) > 1e-6);
        QCOMPARE(pressedWith(1e5), 0.0);
    }
};

QTEST_GUILESS_MAIN(ContactPressingTest)
#include "contact_pressing_test.moc"
