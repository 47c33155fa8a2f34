#include "core/deformation/deformation.h"
#include "core/deformation/number_map.h"
#include "core/deformation/number_placement.h"
#include "core/deformation/number_words.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/message/message.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <numbers>

using namespace knead;

namespace {

constexpr double pi = std::numbers::pi;

/// Along x from 1 to 3, toward z.
NumberDeformation deformation(NumberKind kind)
{
    return {.kind = kind, .origin = Vec3(1, 0, 0), .from = 0, .to = 2, .angle = 1.2, .factor = 0.7, .shift = 0.4};
}

bool isNear(const Vec3& a, const Vec3& b, double tolerance = 1e-12)
{
    return (a - b).norm() <= tolerance;
}

/// Of the polyline through what becomes of the x axis from a to b, a little above its exact value less 1e-9 of it.
double lengthOfAxis(const NumberMap& map, double a, double b)
{
    constexpr int pieces = 20'000;
    double length = 0;
    Vec3 before = map.at({a, 0, 0});
    for (int i = 1; i <= pieces; ++i) {
        const Vec3 next = map.at({a + (b - a) * i / pieces, 0, 0});
        length += (next - before).norm();
        before = next;
    }
    return length;
}

Mat3 exactGradient(const SmoothMap& map, const Vec3& at)
{
    constexpr double step = 1e-5;
    Mat3 gradient;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        gradient.col(axis) = (map.at(at + step * Vec3::Unit(axis)) - map.at(at - step * Vec3::Unit(axis))) / (2 * step);
    return gradient;
}

/// A bar of 4 x 0.4 x 0.2 about the x axis.
TriangleMesh bar()
{
    TriangleMesh mesh = shapes::box({4, 0.4, 0.2});
    for (Vec3& vertex : mesh.vertices)
        vertex.x() += 2;
    return mesh;
}

} // namespace

class NumberMapTest : public QObject {
    Q_OBJECT

private slots:
    void theNeutralLineBecomesAnArcOfTheSameLength();
    void whatLiesBehindABendTurnsWithIt();
    void easedBendsHaveTheWholeAngleAndTheSameLength();
    void nothingMovesBeforeTheFirstPlane();
    void whatStaysIsWhereItWas_data();
    void whatStaysIsWhereItWas();
    void placesAreCarriedWithoutJumpsAtThePlanes_data();
    void placesAreCarriedWithoutJumpsAtThePlanes();
    void easedMapsHaveNoCrease_data();
    void easedMapsHaveNoCrease();
    void twistTurnsCrossSections();
    void taperShrinksCrossSections();
    void stretchMovesAlongTheAxis();
    void shearMovesTowardTheSide();
    void scaleGrowsEvenlyBehindTheSecondPlane();
    void volumesAreThoseOfClosedForms();
    void smallAnglesGoOverIntoNone();
    void facesAreCarriedByTheirZone();
    void chainsFollowThroughZones();
    void whatMakesNoMapIsRefused_data();
    void whatMakesNoMapIsRefused();
    void deformationsBeginWhereThePartIsLong();
    void bendsThatFoldAreToldWithTheRadius();
    void theNeutralPlaneOfASheetIsThatOfItsKFactor();
    void eachKindHasItsWords();
};

void NumberMapTest::theNeutralLineBecomesAnArcOfTheSameLength()
{
    NumberDeformation d = deformation(NumberKind::bend);
    const NumberMap map(d);
    const double radius = d.length() / d.angle;
    for (const double share : {0.0, 0.25, 0.5, 1.0}) {
        const double turned = share * d.angle;
        QVERIFY(isNear(map.at({1 + share * d.length(), 0, 0}),
                       {1 + radius * std::sin(turned), 0, radius * (1 - std::cos(turned))}));
    }
    QVERIFY(std::abs(lengthOfAxis(map, 1, 3) - 2) < 1e-8);
    // The line at a height h has the length of the arc at the radius less h.
    d.neutral = 0.3;
    QVERIFY(std::abs(lengthOfAxis(NumberMap(d), 1, 3) - (radius + 0.3) * d.angle) < 1e-8);
    d.side = -Vec3::UnitZ();
    d.neutral = 0;
    QVERIFY(isNear(NumberMap(d).at({3, 0, 0}), {1 + radius * std::sin(1.2), 0, -radius * (1 - std::cos(1.2))}));
}

void NumberMapTest::whatLiesBehindABendTurnsWithIt()
{
    const NumberDeformation d = deformation(NumberKind::bend);
    const NumberMap map(d);
    const Mat3 turn = Eigen::AngleAxisd(-d.angle, Vec3::UnitY()).toRotationMatrix();
    const Vec3 begin = map.at({3, 0, 0});
    for (const Vec3& rest : {Vec3(0.5, 0, 0), Vec3(0, 0.3, 0), Vec3(1, -0.2, 0.4), Vec3(7, 1, -1)})
        QVERIFY(isNear(map.at(Vec3(3, 0, 0) + rest), begin + turn * rest));
}

void NumberMapTest::easedBendsHaveTheWholeAngleAndTheSameLength()
{
    NumberDeformation d = deformation(NumberKind::bend);
    d.eases = true;
    for (const double angle : {-2.0, 0.3, pi, 2 * pi}) {
        d.angle = angle;
        const NumberMap map(d);
        QVERIFY(std::abs(lengthOfAxis(map, 1, 3) - 2) < 1e-7);
        const Vec3 way = map.at({4, 0, 0}) - map.at({3, 0, 0});
        QVERIFY(isNear(way, {std::cos(angle), 0, std::sin(angle)}));
        // The middle has half of the angle, since the quintic is symmetric.
        const Vec3 middle = exactGradient(map, {2, 0, 0}).col(0);
        QVERIFY(isNear(middle, {std::cos(angle / 2), 0, std::sin(angle / 2)}, 1e-8));
    }
}

void NumberMapTest::nothingMovesBeforeTheFirstPlane()
{
    for (const NumberKindWords& words : numberKindWords())
        for (const bool eases : {false, true}) {
            NumberDeformation d = deformation(words.kind);
            d.eases = eases;
            for (const Vec3& place : {Vec3(1, 0.2, 0.3), Vec3(-5, 1, 2), Vec3(0.999, -1, 0)})
                QVERIFY(isNear(NumberMap(d).at(place), place, 1e-14));
        }
}

namespace {

void kindsAndEases()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<bool>("eases");
    for (const NumberKindWords& words : numberKindWords())
        for (const bool eases : {false, true})
            QTest::addRow("%s%s", words.word, eases ? ", eased" : "") << static_cast<int>(words.kind) << eases;
}

} // namespace

void NumberMapTest::whatStaysIsWhereItWas_data()
{
    kindsAndEases();
}

void NumberMapTest::whatStaysIsWhereItWas()
{
    QFETCH(int, kind);
    QFETCH(bool, eases);
    NumberDeformation d = deformation(static_cast<NumberKind>(kind));
    d.eases = eases;
    for (const double stays : {0.0, 0.3, 0.5, 1.0}) {
        d.stays = stays;
        const NumberMap map(d);
        for (const double height : {0.0, 0.1})
            QVERIFY(isNear(map.at({1 + 2 * stays, 0.2, height}), {1 + 2 * stays, 0.2, height}));
    }
    d.stays = 1; // then all behind the second plane does
    QVERIFY(isNear(NumberMap(d).at({9, 0.1, -0.2}), {9, 0.1, -0.2}));
}

void NumberMapTest::placesAreCarriedWithoutJumpsAtThePlanes_data()
{
    kindsAndEases();
}

void NumberMapTest::placesAreCarriedWithoutJumpsAtThePlanes()
{
    QFETCH(int, kind);
    QFETCH(bool, eases);
    NumberDeformation d = deformation(static_cast<NumberKind>(kind));
    d.eases = eases;
    const NumberMap map(d);
    for (const double plane : {1.0, 3.0}) {
        const Vec3 at(plane, 0.2, -0.3);
        QVERIFY(isNear(map.at(at - Vec3(1e-12, 0, 0)), map.at(at + Vec3(1e-12, 0, 0)), 1e-11));
    }
}

void NumberMapTest::easedMapsHaveNoCrease_data()
{
    kindsAndEases();
}

void NumberMapTest::easedMapsHaveNoCrease()
{
    QFETCH(int, kind);
    QFETCH(bool, eases);
    NumberDeformation d = deformation(static_cast<NumberKind>(kind));
    d.eases = eases;
    const NumberMap map(d);
    double jump = 0;
    for (const double plane : {1.0, 3.0}) {
        const Vec3 at(plane, 0.3, 0.2);
        const Mat3 before = exactGradient(map, at - Vec3(2e-5, 0, 0));
        const Mat3 behind = exactGradient(map, at + Vec3(2e-5, 0, 0));
        jump = std::max(jump, (before - behind).norm());
    }
    if (eases)
        QVERIFY2(jump < 1e-3, qPrintable(QString::number(jump)));
    else
        QVERIFY2(jump > 1e-2, qPrintable(QString::number(jump)));
}

void NumberMapTest::twistTurnsCrossSections()
{
    const NumberDeformation d = deformation(NumberKind::twist);
    const NumberMap map(d);
    const Vec3 rest(0, 0.3, -0.2);
    for (const double share : {0.5, 1.0}) {
        const Mat3 turn = Eigen::AngleAxisd(share * d.angle, Vec3::UnitX()).toRotationMatrix();
        const Vec3 on(1 + 2 * share, 0, 0);
        QVERIFY(isNear(map.at(on + rest), on + turn * rest));
    }
    const Mat3 turn = Eigen::AngleAxisd(d.angle, Vec3::UnitX()).toRotationMatrix();
    QVERIFY(isNear(map.at(Vec3(8, 0, 0) + rest), Vec3(8, 0, 0) + turn * rest));
}

void NumberMapTest::taperShrinksCrossSections()
{
    const NumberMap map(deformation(NumberKind::taper));
    QVERIFY(isNear(map.at({2, 0.2, 0.4}), {2, 0.85 * 0.2, 0.85 * 0.4}));
    QVERIFY(isNear(map.at({3, 0.2, 0.4}), {3, 0.7 * 0.2, 0.7 * 0.4}));
    QVERIFY(isNear(map.at({5, 0.2, 0.4}), {5, 0.7 * 0.2, 0.7 * 0.4}));
}

void NumberMapTest::stretchMovesAlongTheAxis()
{
    const NumberMap map(deformation(NumberKind::stretch));
    QVERIFY(isNear(map.at({2, 0.2, 0.4}), {1.7, 0.2, 0.4}));
    QVERIFY(isNear(map.at({5, 0.2, 0.4}), {5 - 0.6, 0.2, 0.4}));
}

void NumberMapTest::shearMovesTowardTheSide()
{
    const NumberMap map(deformation(NumberKind::shear));
    QVERIFY(isNear(map.at({2, 0.2, 0.4}), {2, 0.2, 0.6}));
    QVERIFY(isNear(map.at({5, 0.2, 0.4}), {5, 0.2, 0.8}));
}

/// What lies behind becomes similar; between, the length of a stretch is the mean of its factors.
void NumberMapTest::scaleGrowsEvenlyBehindTheSecondPlane()
{
    for (const bool eases : {false, true}) {
        NumberDeformation d = deformation(NumberKind::scale);
        d.eases = eases;
        const NumberMap map(d);
        QVERIFY(isNear(map.at({3, 0, 0}), {1 + 2 * 0.85, 0, 0}));
        const Vec3 rest(1.5, 0.3, -0.2);
        QVERIFY(isNear(map.at(Vec3(3, 0, 0) + rest), Vec3(1 + 2 * 0.85, 0, 0) + 0.7 * rest));
    }
}

/// A bar whose middle lies on the neutral plane keeps its volume, by Pappus; one that does not gets its part of another radius.
void NumberMapTest::volumesAreThoseOfClosedForms()
{
    const TriangleMesh fine = refine(bar(), 0.04, 400'000);
    const auto volumeAfter = [&](const NumberDeformation& d) {
        TriangleMesh now = fine;
        NumberMap(d).evaluate(fine.vertices, now.vertices);
        return massProperties(now).volume;
    };
    const double section = 0.4 * 0.2;
    NumberDeformation d = deformation(NumberKind::bend);
    QVERIFY(std::abs(volumeAfter(d) - section * 4) < 1e-4 * section * 4);
    d.neutral = 0.1;
    QVERIFY(std::abs(volumeAfter(d) - section * (4 + 0.1 * d.angle)) < 1e-4 * section * 4);
    d.eases = true;
    QVERIFY(std::abs(volumeAfter(d) - section * (4 + 0.1 * d.angle)) < 1e-4 * section * 4);
    QVERIFY(std::abs(volumeAfter(deformation(NumberKind::twist)) - section * 4) < 1e-3 * section * 4);
    QVERIFY(std::abs(volumeAfter(deformation(NumberKind::shear)) - section * 4) < 1e-12);
    QVERIFY(std::abs(volumeAfter(deformation(NumberKind::stretch)) - section * (2 + 2 * 0.7)) < 1e-12);
    const double square = (1 + 0.7 + 0.49) / 3; // mean of the square of the factor
    QVERIFY(std::abs(volumeAfter(deformation(NumberKind::taper)) - section * (1 + 2 * square + 0.49)) < 1e-6);
    const double cube = (1 + 0.7) * (1 + 0.49) / 4; // and of its cube
    QVERIFY(std::abs(volumeAfter(deformation(NumberKind::scale)) - section * (1 + 2 * cube + 0.343)) < 1e-4);
}

void NumberMapTest::smallAnglesGoOverIntoNone()
{
    NumberDeformation d = deformation(NumberKind::bend);
    for (const double angle : {0.0, 1e-12, 1e-6, 0.99e-4, 1.01e-4, 1e-3}) {
        d.angle = angle;
        const Vec3 end = NumberMap(d).at({3, 0, 0});
        QVERIFY(isNear(end, {3 - 2 * angle * angle / 6, 0, angle * (1 - angle * angle / 12)}, 1e-12));
    }
}

void NumberMapTest::facesAreCarriedByTheirZone()
{
    const NumberMap map(deformation(NumberKind::twist));
    const std::vector<Vec3> before{{-1, 0, 0}, {1, 0, 1}};
    const std::vector<Vec3> between{{1, 0, 0}, {3, 0.2, 0}};
    const std::vector<Vec3> behind{{3, 0, 0}, {4, 0.2, 0}};
    const std::vector<Vec3> across{{2, 0, 0}, {4, 0.2, 0}};
    QVERIFY(&map.ofFace(across) == &map);
    QVERIFY(isNear(map.ofFace(before).at({2.5, 0.1, 0.2}), {2.5, 0.1, 0.2}));
    // Within it is what the map is, and goes on with the same slope behind.
    const SmoothMap& zone = map.ofFace(between);
    QVERIFY(isNear(zone.at({2, 0.1, 0.2}), map.at({2, 0.1, 0.2})));
    const Mat3 turn = Eigen::AngleAxisd(2 * 1.2, Vec3::UnitX()).toRotationMatrix();
    QVERIFY(isNear(zone.at({5, 0.1, 0.2}), Vec3(5, 0, 0) + turn * Vec3(0, 0.1, 0.2)));
    QVERIFY(isNear(map.ofFace(behind).at({5, 0.1, 0.2}), map.at({5, 0.1, 0.2})));
    NumberDeformation eased = map.deformation();
    eased.eases = true;
    const NumberMap smooth(eased);
    QVERIFY(&smooth.ofFace(before) == &smooth);
}

void NumberMapTest::chainsFollowThroughZones()
{
    const NumberDeformation bend = deformation(NumberKind::bend);
    const NumberDeformation twist = deformation(NumberKind::twist);
    const std::vector<Deformation> both{bend, twist};
    const auto chain = mapOf(both);
    const Vec3 place(2.2, 0.1, 0.3);
    QVERIFY(isNear(chain->at(place), NumberMap(twist).at(NumberMap(bend).at(place))));
    const std::vector<Vec3> before{{-1, 0, 0}, {0.5, 0, 0.5}};
    QVERIFY(isNear(chain->ofFace(before).at({9, 9, 9}), {9, 9, 9}));
    QVERIFY(&chain->ofFace(before) == &chain->ofFace(before));
}

void NumberMapTest::whatMakesNoMapIsRefused_data()
{
    QTest::addColumn<NumberDeformation>("wrong");
    const auto row = [](const char* name, const std::function<void(NumberDeformation&)>& change) {
        NumberDeformation d = deformation(NumberKind::stretch);
        change(d);
        QTest::newRow(name) << d;
    };
    row("planes in one place", [](auto& d) { d.to = d.from; });
    row("planes the other way around", [](auto& d) { d.to = d.from - 1; });
    row("no direction", [](auto& d) { d.axis = Vec3::Zero(); });
    row("an axis that is too long", [](auto& d) { d.axis = Vec3(2, 0, 0); });
    row("a side along the axis", [](auto& d) { d.side = d.axis; });
    row("a slanting side", [](auto& d) { d.side = Vec3(1, 0, 1).normalized(); });
    row("a factor of nothing", [](auto& d) { d.factor = 0; });
    row("a factor below nothing", [](auto& d) { d.factor = -1; });
    row("stays outside", [](auto& d) { d.stays = 1.5; });
    row("no number", [](auto& d) { d.angle = std::numeric_limits<double>::quiet_NaN(); });
    row("no place", [](auto& d) { d.origin.x() = std::numeric_limits<double>::infinity(); });
    row("a gentle fold", [](auto& d) {
        d.eases = true;
        d.factor = 0.4;
    });
}

void NumberMapTest::whatMakesNoMapIsRefused()
{
    QFETCH(NumberDeformation, wrong);
    QVERIFY_THROWS_EXCEPTION(Problem, NumberMap(wrong).featureSize());
}

void NumberMapTest::deformationsBeginWhereThePartIsLong()
{
    const NumberDeformation d = suggestedDeformation(NumberKind::bend, Box(Vec3(0, -2, 1), Vec3(3, 10, 2)));
    QCOMPARE(d.axis, Vec3(0, 1, 0));
    QCOMPARE(d.side, Vec3(0, 0, 1));
    QCOMPARE(d.origin, Vec3(1.5, 4, 1.5));
    QCOMPARE(d.from, -3.0);
    QCOMPARE(d.to, 3.0);
    QVERIFY(isNear(NumberMap(d).at({7, 8, 9}), {7, 8, 9})); // nothing yet
    const NumberDeformation cube = suggestedDeformation(NumberKind::twist, Box(Vec3::Zero(), Vec3::Ones()));
    QVERIFY(std::abs(cube.axis.dot(cube.side)) == 0);
}

void NumberMapTest::bendsThatFoldAreToldWithTheRadius()
{
    NumberDeformation d = deformation(NumberKind::bend);
    const TriangleMesh mesh = bar();
    QVERIFY(!foldOf(d, mesh)); // radius 1.67
    const HeightRange heights = heightsBetweenPlanes(d, mesh);
    QVERIFY(std::abs(heights.least + 0.1) < 1e-12 && std::abs(heights.most - 0.1) < 1e-12);
    QVERIFY(std::abs(smallestRadius(d, heights) - 0.1) < 1e-12);
    d.angle = 2 / 0.1001;
    QVERIFY(!foldOf(d, mesh));
    d.angle = 2 / 0.0999;
    QVERIFY(foldOf(d, mesh));
    QVERIFY(foldOf(d, mesh)->english().find("reaches 100 mm") != std::string::npos);
    d.neutral = 0.05; // nearer to the inner side
    QVERIFY(!foldOf(d, mesh));
    d.angle = -d.angle;
    QVERIFY(foldOf(d, mesh));
    d.angle = 2 / 0.11;
    d.neutral = 0;
    d.eases = true; // sharper in its middle
    QVERIFY(foldOf(d, mesh));
    d.origin.x() = 10; // nothing lies there
    QVERIFY(heightsBetweenPlanes(d, mesh).isEmpty());
    QVERIFY(!foldOf(d, mesh));
}

void NumberMapTest::theNeutralPlaneOfASheetIsThatOfItsKFactor()
{
    NumberDeformation d = deformation(NumberKind::bend);
    const HeightRange heights{-0.1, 0.1};
    QCOMPARE(neutralOfSheet(d, heights, 0.5), 0.0);
    QVERIFY(std::abs(neutralOfSheet(d, heights, 0.3) - 0.04) < 1e-15); // it bends toward the upper side
    d.angle = -1;
    QVERIFY(std::abs(neutralOfSheet(d, heights, 0.3) + 0.04) < 1e-15);
}

void NumberMapTest::eachKindHasItsWords()
{
    for (const NumberKindWords& words : numberKindWords()) {
        QVERIFY(numberKindOf(words.word) == words.kind);
        QCOMPARE(&wordsOf(words.kind), &words);
        for (const NumberParameter& parameter : words.parameters) {
            NumberDeformation d;
            parameter.set(d, 0.5);
            QVERIFY(std::abs(parameter.typed(d) - 0.5) < 1e-15);
        }
    }
    QVERIFY(!numberKindOf("no such kind"));
    NumberDeformation d;
    wordsOf(NumberKind::bend).parameters.front().set(d, 180);
    QVERIFY(std::abs(d.angle - pi) < 1e-15);
}

QTEST_GUILESS_MAIN(NumberMapTest)
#include "number_map_test.moc"
