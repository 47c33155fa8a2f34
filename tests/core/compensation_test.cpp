#include "core/session/compensation.h"

#include "core/message/message.h"
#include "support/shapes.h"
#include "support/space_maps.h"

#include <QtTest>

using namespace knead;

namespace {

constexpr double mm = 1e-3;
const Vec3 sides = Vec3(100, 20, 8) * mm;

/// A plate that sags, and sags more where it is bent upward already: what is made for a straight one is wrong for another.
///   u(Y) = (-2 s Y.z / l, 0, s + 0.06 Y.z),  s = 6 mm (Y.x / l)^2
class Sag final : public maps::PointMap {
public:
    double featureSize() const override { return 0.1; }

protected:
    Vec3 place(const Vec3& point) const override
    {
        const double along = point.x() / sides.x();
        const double s = 6 * mm * along * along;
        return point + Vec3(-2 * s * point.z() / sides.x(), 0, s + 0.06 * point.z());
    }
};

Model plate()
{
    Part part;
    part.name = "Plate";
    part.mesh = shapes::moved(shapes::box(sides), {sides / 2, Quaternion::Identity()});
    part.faces.resize(6);
    part.watertight = true;
    part.box.extend(Vec3::Zero());
    part.box.extend(sides);
    part.volume = sides.prod();
    Model model;
    model.parts.push_back(part);
    return model;
}

std::vector<CompensationRound> compensated(const TargetPoints& points, const CompensationMethod& method,
                                           const SmoothMap& warp)
{
    std::vector<CompensationRound> rounds;
    while (rounds.empty() || !stateAfter(rounds, method).end) {
        CompensationRound round = nextRound(points, rounds, method);
        measureRound(points, warp, method.fitsBest, round);
        rounds.push_back(std::move(round));
    }
    return rounds;
}

CompensationRound ofDeviation(double largest, double factor = 0.8)
{
    return {.factor = factor, .compensation = {Vec3::Zero()}, .deviations = {Vec3(largest, 0, 0)}, .largest = largest};
}

} // namespace

/// A compensation without files: what comes out of a shape is known in closed form.
class CompensationTest : public QObject {
    Q_OBJECT

private slots:
    void aWarpIsTakenBackInFourRounds();
    void theFirstRoundIsTheTarget();
    void rigidMotionsDoNotCountWhereTheBestFitIsAskedFor();
    void onlyFacesThatAreNamedCount();
    void facesThatAreNotThereAreNamed();
    void linearFieldsAreSmooth();
    void noiseIsSmoothedAway();
    void theFactorIsHalvedOnceAndThenItEnds();
    void roundsLearnHowMuchSpringsBack();
};

void CompensationTest::aWarpIsTakenBackInFourRounds()
{
    const TargetPoints points = targetPoints(plate(), {}, 4 * mm);
    const CompensationMethod method{.tolerance = 1e-9, .rounds = 4};
    const std::vector<CompensationRound> rounds = compensated(points, method, Sag());
    QCOMPARE(rounds.size(), std::size_t{4});
    for (const CompensationRound& round : rounds)
        qInfo("round %d: %.5f mm, mean %.5f mm", round.number, round.largest / mm, round.mean / mm);
    QVERIFY(rounds[0].largest > 6 * mm);
    QVERIFY(rounds[1].largest > 0.05 * rounds[0].largest); // one round is not enough
    QVERIFY(rounds[3].largest < 0.05 * rounds[0].largest);
    QVERIFY(rounds[3].mean <= rounds[3].largest);
    QCOMPARE(rounds[3].deviations[rounds[3].worst].norm(), rounds[3].largest);
}

void CompensationTest::theFirstRoundIsTheTarget()
{
    const TargetPoints points = targetPoints(plate(), {}, 4 * mm);
    CompensationRound round = nextRound(points, {}, {.tolerance = mm});
    QVERIFY(!shapeOf(points, round));
    measureRound(points, maps::Identity(), false, round);
    QCOMPARE(round.largest, 0.0);
    QCOMPARE(stateAfter({round}, {.tolerance = mm}).end, CompensationEnd::within);
}

void CompensationTest::rigidMotionsDoNotCountWhereTheBestFitIsAskedFor()
{
    class Turned final : public maps::PointMap {
    public:
        double featureSize() const override { return 1; }

    protected:
        Vec3 place(const Vec3& point) const override
        {
            return Eigen::AngleAxisd(0.3, Vec3(1, 2, 2) / 3) * point + Vec3(0.01, -0.02, 0.005);
        }
    };
    const TargetPoints points = targetPoints(plate(), {}, 6 * mm);
    CompensationRound round = nextRound(points, {}, {.tolerance = mm});
    measureRound(points, Turned(), true, round);
    QVERIFY(round.largest < 1e-12);
    measureRound(points, Turned(), false, round);
    QVERIFY(round.largest > 10 * mm);
}

void CompensationTest::onlyFacesThatAreNamedCount()
{
    const TargetPoints all = targetPoints(plate(), {}, 4 * mm);
    const TargetPoints some = targetPoints(plate(), {{"Plate", {5}}}, 4 * mm);
    Box top;
    for (std::size_t i = 0; i < some.places.size(); ++i)
        if (some.counts[i])
            top.extend(some.places[i]);
    QVERIFY(top.isApprox(Box(Vec3(0, 0, sides.z()), sides)));
    for (std::size_t i = 0; i < all.places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if ((all.places[i] - all.places[j]).norm() < 2 * mm)
                QFAIL("two places are too close to each other");
}

void CompensationTest::facesThatAreNotThereAreNamed()
{
    QVERIFY_THROWS_EXCEPTION(Problem, targetPoints(plate(), {{"Lid", {0}}}, 4 * mm));
    QVERIFY_THROWS_EXCEPTION(Problem, targetPoints(plate(), {{"Plate", {17}}}, 4 * mm));
    QVERIFY_THROWS_EXCEPTION(Problem, targetPoints(plate(), {}, 0.01 * mm));
    QVERIFY_THROWS_EXCEPTION(Problem, targetPoints(Model{}, {}, 4 * mm));
}

void CompensationTest::linearFieldsAreSmooth()
{
    const TargetPoints points = targetPoints(plate(), {}, 6 * mm);
    Mat3 slope;
    slope << 1, 2, 3, -1, 0, 4, 2, 2, -5;
    std::vector<Vec3> linear;
    for (const Vec3& place : points.places)
        linear.push_back(slope * place + Vec3(1, 2, 3));
    const std::vector<Vec3> same = smoothed(points.places, linear, 15 * mm);
    for (std::size_t i = 0; i < linear.size(); ++i)
        QVERIFY((same[i] - linear[i]).norm() < 1e-9);
}

void CompensationTest::noiseIsSmoothedAway()
{
    const TargetPoints points = targetPoints(plate(), {}, 4 * mm);
    std::vector<Vec3> noise;
    for (std::size_t i = 0; i < points.places.size(); ++i)
        noise.push_back(Vec3::Constant(i % 2 == 0 ? 1 : -1));
    double squares = 0;
    for (const Vec3& left : smoothed(points.places, noise, 16 * mm))
        squares += left.squaredNorm() / 3;
    QVERIFY(squares < 0.2 * static_cast<double>(noise.size()));
}

void CompensationTest::theFactorIsHalvedOnceAndThenItEnds()
{
    const CompensationMethod method{.tolerance = 0.1, .rounds = 9, .factor = 0.8};
    std::vector<CompensationRound> rounds{ofDeviation(4), ofDeviation(2)};
    QCOMPARE(stateAfter(rounds, method).factor, 0.8);
    rounds.push_back(ofDeviation(3));
    CompensationState state = stateAfter(rounds, method);
    QVERIFY(state.isHalved && !state.end);
    QCOMPARE(state.best, std::size_t{1});
    QCOMPARE(state.factor, 0.4);
    const TargetPoints one{.places = {Vec3::Zero()}, .counts = {true}, .spacing = 1};
    QCOMPARE(nextRound(one, rounds, method).compensation[0], Vec3(-0.8, 0, 0)); // from the best one
    rounds[2].factor = 1.2;                                                     // learned: it is this that was too much
    QCOMPARE(stateAfter(rounds, method).factor, 0.6);
    rounds[2].factor = 0.8;
    rounds.push_back(ofDeviation(1, 0.4));
    state = stateAfter(rounds, method);
    QVERIFY(!state.isHalved && !state.end && state.best == 3);
    QCOMPARE(state.factor, 0.4);
    rounds.push_back(ofDeviation(1.5));
    state = stateAfter(rounds, method);
    QCOMPARE(state.end, CompensationEnd::diverged);
    QCOMPARE(state.best, std::size_t{3});
    QCOMPARE(stateAfter({ofDeviation(4), ofDeviation(3)}, {.tolerance = 1, .rounds = 2}).end, CompensationEnd::rounds);
}

/// Of what is taken back a part comes out: 0.55 in one, 1.4 in the other.
void CompensationTest::roundsLearnHowMuchSpringsBack()
{
    class Spring final : public maps::PointMap {
    public:
        explicit Spring(double share)
            : m_share(share)
        {
        }
        double featureSize() const override { return 0.1; }

    protected:
        Vec3 place(const Vec3& point) const override { return m_share * point + Vec3(0.01, 0.02, 0); }

    private:
        double m_share;
    };
    const TargetPoints points = targetPoints(plate(), {}, 4 * mm);
    for (const double share : {0.55, 1.4}) {
        const std::vector<CompensationRound> rounds =
            compensated(points, {.tolerance = 1e-9, .rounds = 6}, Spring(share));
        QCOMPARE(rounds[1].factor, 1.0);
        QVERIFY(rounds[1].largest > 0.3 * rounds[0].largest);
        QVERIFY2(std::abs(rounds[2].factor * share - 1) < 1e-6, qPrintable(QString::number(rounds[2].factor)));
        QVERIFY2(rounds[2].largest < 1e-6 * rounds[0].largest, qPrintable(QString::number(rounds[2].largest)));
    }
}

QTEST_APPLESS_MAIN(CompensationTest)
#include "compensation_test.moc"
