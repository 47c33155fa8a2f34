#include "core/integration/anderson_mixing.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace knead;

namespace {

constexpr std::size_t objects = 40;

double distance(const VectorArray& a, const VectorArray& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += (a.at(i) - b.at(i)).squaredNorm();
    return std::sqrt(sum);
}

/// Where the iterations should come to.
VectorArray goal()
{
    VectorArray goal(objects);
    for (std::size_t i = 0; i < objects; ++i) {
        const auto n = static_cast<double>(i);
        goal.set(i, Vec3(std::sin(n), std::cos(2 * n), 1 + n / 7));
    }
    return goal;
}

/// v + f(v) with an error that is multiplied by one of a few numbers each time, near 1 the largest.
VectorArray step(const VectorArray& v, const VectorArray& goal)
{
    constexpr std::array shares{0.97, 0.8, 0.5, -0.3};
    VectorArray next(v.size());
    for (std::size_t i = 0; i < v.size(); ++i)
        next.set(i, goal.at(i) + shares[i % shares.size()] * (v.at(i) - goal.at(i)));
    return next;
}

} // namespace

class AndersonMixingTest : public QObject {
    Q_OBJECT

private slots:
    void theFirstIterationIsAsItWas()
    {
        AndersonMixing mixing;
        const VectorArray start(objects);
        const VectorArray plain = step(start, goal());
        VectorArray next = plain;
        mixing.accelerate(start, next);
        QCOMPARE(distance(next, plain), 0.0);
    }

    /// A linear iteration with four different factors ends after four differences.
    void asManyDifferencesAsFactorsEndIt()
    {
        AndersonMixing mixing;
        const VectorArray wanted = goal();
        VectorArray v(objects);
        VectorArray plain(objects);
        const double start = distance(v, wanted);
        for (int iteration = 0; iteration < 6; ++iteration) {
            VectorArray next = step(v, wanted);
            mixing.accelerate(v, next);
            v = std::move(next);
            plain = step(plain, wanted);
        }
        QVERIFY(distance(plain, wanted) > 0.3 * start);
        QVERIFY2(distance(v, wanted) < 1e-6 * start, qPrintable(QString::number(distance(v, wanted) / start)));
    }

    /// Of more iterations than it remembers, too.
    void staysAtTheGoal()
    {
        AndersonMixing mixing;
        const VectorArray wanted = goal();
        VectorArray v(objects);
        for (int iteration = 0; iteration < 40; ++iteration) {
            VectorArray next = step(v, wanted);
            mixing.accelerate(v, next);
            v = std::move(next);
        }
        QVERIFY(distance(v, wanted) < 1e-9 * distance(VectorArray(objects), wanted));
    }

    void forgetsWhatWasBeforeARestart()
    {
        AndersonMixing mixing;
        VectorArray v(objects);
        for (int iteration = 0; iteration < 3; ++iteration) {
            VectorArray next = step(v, goal());
            mixing.accelerate(v, next);
            v = std::move(next);
        }
        mixing.restart();
        VectorArray next = step(v, VectorArray(objects));
        const VectorArray plain = next;
        mixing.accelerate(v, next);
        QCOMPARE(distance(next, plain), 0.0);
    }

    /// Iterations that all go the same way say nothing new: the differences are nearly the same.
    void equalDifferencesDoNotBlowUp()
    {
        AndersonMixing mixing;
        VectorArray v(objects);
        for (int iteration = 0; iteration < 10; ++iteration) {
            VectorArray next = v;
            for (std::size_t i = 0; i < objects; ++i)
                next.add(i, Vec3(1, 0, 0));
            mixing.accelerate(v, next);
            v = std::move(next);
            for (std::size_t i = 0; i < objects; ++i)
                QVERIFY(v.at(i).allFinite());
        }
        QVERIFY(distance(v, VectorArray(objects)) < 20 * std::sqrt(objects));
    }
};

QTEST_APPLESS_MAIN(AndersonMixingTest)
#include "anderson_mixing_test.moc"
