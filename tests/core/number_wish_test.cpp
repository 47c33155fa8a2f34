#include "core/deformation/number_map.h"
#include "core/deformation/number_wish.h"
#include "core/message/message.h"
#include "support/shapes.h"

#include <QtTest>

#include <numbers>

using namespace knead;

namespace {

/// A bar from 10 to 110 along x, 20 wide along y around 5, 4 thick along z from 0.
std::vector<Vec3> bar()
{
    std::vector<Vec3> places;
    for (const double x : {10.0, 110.0})
        for (const double y : {-5.0, 15.0})
            for (const double z : {0.0, 4.0})
                places.emplace_back(x, y, z);
    return places;
}

constexpr double quarter = std::numbers::pi / 2;

} // namespace

class NumberWishTest : public QObject {
    Q_OBJECT

private slots:
    /// Along the longest side, through the middle, from end to end.
    void whatIsLeftOpenFollowsFromThePart()
    {
        const NumberDeformation d = numberDeformation({.amount = quarter}, bar());
        QVERIFY(d.axis == Vec3::UnitX() && d.side == Vec3::UnitZ());
        QVERIFY((d.origin - Vec3(0, 5, 2)).norm() < 1e-12);
        QCOMPARE(d.from, 10.0);
        QCOMPARE(d.to, 110.0);
        QCOMPARE(d.neutral, 0.0);
        QCOMPARE(d.angle, quarter);
        QCOMPARE(d.kind, NumberKind::bend);
    }

    void directionsAreMadeOfUnitLengthAndPerpendicular()
    {
        const NumberDeformation d =
            numberDeformation({.amount = 1, .axis = Vec3(0, 3, 0), .side = Vec3(0, 1, 2)}, bar());
        QVERIFY((d.axis - Vec3::UnitY()).norm() < 1e-12 && (d.side - Vec3::UnitZ()).norm() < 1e-12);
        QVERIFY(numberDeformation({.amount = 1, .axis = Vec3::UnitZ()}, bar()).side == Vec3::UnitX());
        const NumberDeformation tilted = numberDeformation({.amount = 1, .axis = Vec3(1, 1, 1)}, bar());
        QVERIFY(std::abs(tilted.axis.dot(tilted.side)) < 1e-12);
        QVERIFY(std::abs(tilted.side.norm() - 1) < 1e-12);
        QVERIFY_EXCEPTION_THROWN(numberDeformation({.axis = Vec3::Zero()}, bar()), Problem);
        QVERIFY_EXCEPTION_THROWN(numberDeformation({.axis = Vec3::UnitX(), .side = Vec3::UnitX()}, bar()), Problem);
    }

    void planesCountFromTheOriginThatIsGiven()
    {
        const NumberDeformation d =
            numberDeformation({.kind = NumberKind::stretch, .amount = 2, .origin = Vec3(60, 0, 0), .to = 20}, bar());
        QCOMPARE(d.from, -50.0);
        QCOMPARE(d.to, 20.0);
        QCOMPARE(d.factor, 2.0);
    }

    /// The line through the middle becomes an arc of this radius, and keeps its length.
    void aRadiusSaysWhereTheBendEnds()
    {
        const NumberDeformation d = numberDeformation({.amount = -quarter, .from = 20, .radius = 30}, bar());
        QVERIFY(std::abs(d.to - (20 + 30 * quarter)) < 1e-12);
        const NumberMap map(d);
        const Vec3 center = Vec3(20, 5, 2 - 30); // it bends away from the side
        for (const double share : {0.0, 0.4, 1.0})
            QVERIFY(std::abs((map.at(Vec3(20 + share * 30 * quarter, 5, 2)) - center).norm() - 30) < 1e-9);
    }

    /// What lies a quarter of the thickness from the inside keeps its length, whichever way it bends.
    void aKFactorCountsFromTheInside()
    {
        for (const double angle : {quarter, -quarter}) {
            const NumberDeformation d = numberDeformation({.amount = angle, .kFactor = 0.25}, bar());
            const double z = angle > 0 ? 3 : 1;
            const NumberMap map(d);
            double length = 0;
            Vec3 last = map.at(Vec3(10, 5, z));
            for (int i = 1; i <= 1000; ++i) {
                const Vec3 next = map.at(Vec3(10 + 0.1 * i, 5, z));
                length += (next - last).norm();
                last = next;
            }
            QVERIFY(std::abs(length - 100) < 1e-3);
        }
    }

    void contradictionsAreRefused()
    {
        for (const NumberWish& wish :
             {NumberWish{.amount = 1, .to = 5, .radius = 3}, NumberWish{.amount = 1, .radius = -3},
              NumberWish{.amount = 1, .neutral = 0, .kFactor = 0.5}, NumberWish{.amount = 1, .kFactor = 1.5},
              NumberWish{.kind = NumberKind::twist, .amount = 1, .radius = 3},
              NumberWish{.kind = NumberKind::shear, .amount = 1, .kFactor = 0.4}})
            QVERIFY_EXCEPTION_THROWN(numberDeformation(wish, bar()), Problem);
    }
};

QTEST_APPLESS_MAIN(NumberWishTest)
#include "number_wish_test.moc"
