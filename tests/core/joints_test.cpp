#include "core/mechanics/joints.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <limits>

using namespace knead;

namespace {

constexpr double length = 2e-3;

Joint joint()
{
    return {.first = {0, 0},
            .second = {1, 0},
            .nominalLength = length,
            .stiffness = 1000,
            .tolerance = std::numeric_limits<double>::infinity(),
            .yieldStrain = std::numeric_limits<double>::infinity(),
            .ductility = std::numeric_limits<double>::infinity()};
}

/// Two bodies of one object each, some way apart along x.
struct Ends {
    std::array<ObjectState, 2> bodies;
    Joints joints;

    explicit Ends(const Joint& joint)
    {
        joints.add({joint});
        for (ObjectState& body : bodies) {
            body.position.resize(1);
            body.velocity.resize(1);
            body.force.resize(1);
            body.damping.resize(1);
            body.mass.assign(1, 1e-6);
            body.inverseMass.assign(1, 1e6);
        }
    }

    Joints::Report at(double distance, bool isTrial = false)
    {
        for (ObjectState& body : bodies) {
            body.force.setZero();
            body.damping.setZero();
        }
        bodies[1].position.set(0, Vec3(distance, 0, 0));
        const std::array<ObjectState*, 2> states{&bodies[0], &bodies[1]};
        return joints.computeForces(states, {.duration = 1e-5, .stickSpeed = isTrial ? 1e-3 : 0, .isTrial = isTrial});
    }

    double pull() const { return bodies[0].force.at(0).x(); }
};

} // namespace

class JointsTest : public QObject {
    Q_OBJECT

private slots:
    void pullsAndPushesAlongItself()
    {
        Ends ends(joint());
        QCOMPARE(ends.at(length).energy, 0.0);
        const double stretch = 1e-4;
        const double energy = ends.at(length + stretch).energy;
        QVERIFY(std::abs(ends.pull() - 1000 * stretch) < 1e-12);
        QVERIFY(ends.bodies[1].force.at(0) == -ends.bodies[0].force.at(0));
        QVERIFY(std::abs(energy - 500 * stretch * stretch) < 1e-15);
        ends.at(length - stretch);
        QVERIFY(ends.pull() < 0);
    }

    void endsAboveItsToleranceAndNotInATrial()
    {
        Joint weak = joint();
        weak.tolerance = 0.1;
        Ends ends(weak);
        QCOMPARE(ends.at(length + 0.99e-4).ended, std::size_t{0});
        QCOMPARE(ends.at(length + 1.01e-4, true).ended, std::size_t{0});
        QVERIFY(ends.joints.connects({0, 0}, {1, 0}));
        const Joints::Report report = ends.at(length + 1.01e-4);
        QCOMPARE(report.ended, std::size_t{1});
        QVERIFY(std::abs(report.fracture - 500 * 1.01e-4 * 1.01e-4) < 1e-12);
        QVERIFY(!ends.joints.connects({1, 0}, {0, 0}));
        QCOMPARE(ends.pull(), 0.0);
    }

    /// Its nominal length goes after what is beyond yield; what it stored of that is lost.
    void flowsBeyondYield()
    {
        Joint soft = joint();
        soft.yieldStrain = 0.01;
        Ends ends(soft);
        QCOMPARE(ends.at(1.009 * length).plastic, 0.0);
        const double before = 500 * std::pow(0.1 * length, 2);
        const Joints::Report report = ends.at(1.1 * length);
        QVERIFY(report.plastic > 0.9 * before && std::abs(report.plastic + report.energy - before) < 1e-12);
        QVERIFY(ends.pull() > 0 && ends.pull() < 1.2 * 1000 * 0.01 * length);
    }

    /// However far it is drawn out, it does not stay for ever: it ends at its ductility.
    void isWornOutByItsFlow()
    {
        Joint soft = joint();
        soft.yieldStrain = 0.01;
        soft.ductility = 1;
        Ends ends(soft);
        double distance = length;
        for (int step = 0; step < 1000 && ends.joints.connects({0, 0}, {1, 0}); ++step)
            ends.at(distance *= 1.01);
        QVERIFY(!ends.joints.connects({0, 0}, {1, 0}));
        QVERIFY2(std::abs(std::log(distance / length) - 1) < 0.05,
                 qPrintable(QString::number(std::log(distance / length))));
    }

    /// What only sticks gives way to what has grown together, and not the other way round.
    void healedOnesTakeThePlaceOfOthers()
    {
        Joints joints;
        joints.add({joint()});
        Joint healed = joint();
        healed.healed = true;
        healed.stiffness = 7;
        std::swap(healed.first, healed.second);
        joints.add({healed});
        QCOMPARE(joints.all().size(), std::size_t{1});
        QCOMPARE(joints.find({0, 0}, {1, 0})->stiffness, 7.0);
        joints.add({joint()});
        QCOMPARE(joints.find({0, 0}, {1, 0})->stiffness, 7.0);
    }
};

QTEST_APPLESS_MAIN(JointsTest)
#include "joints_test.moc"
