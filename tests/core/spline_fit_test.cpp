#include "core/geometry/grid_completion.h"
#include "core/geometry/spline_fit.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace knead;

namespace {

constexpr int degree = 5;

/// Value of a spline by its basis.
Vec3 valueOf(const SplineCurve& curve, double parameter)
{
    SplineBasis::Values values;
    const std::size_t first = SplineBasis(curve.knots, curve.degree).functionsAt(parameter, values);
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k <= static_cast<std::size_t>(curve.degree); ++k)
        sum += values[k] * curve.poles[first + k];
    return sum;
}

CurveTarget targetOf(const std::function<Vec3(double)>& function)
{
    return [function](std::span<const double> parameters, std::span<Vec3> places) {
        std::transform(parameters.begin(), parameters.end(), places.begin(), function);
    };
}

} // namespace

class SplineFitTest : public QObject {
    Q_OBJECT
private slots:
    void functionsSumToOne()
    {
        const SplineBasis basis({{0, 0.3, 0.5, 1}, {1, 2, 5, 1}}, degree);
        for (int i = 0; i <= 100; ++i) {
            SplineBasis::Values values;
            basis.functionsAt(0.01 * i, values);
            double sum = 0;
            for (int k = 0; k <= degree; ++k) {
                QVERIFY(values[static_cast<std::size_t>(k)] >= -1e-15);
                sum += values[static_cast<std::size_t>(k)];
            }
            QVERIFY(std::abs(sum - 1) < 1e-13);
        }
    }

    void polynomialsOfTheDegreeAreExact()
    {
        const auto quintic = [](double t) { return Vec3(std::pow(t, 5), 1 - 2 * t * t * t, t); };
        const auto fit = fitCurve(targetOf(quintic), SplineKnots::between(0, 1), 1, {.tolerance = 1e-10});
        QVERIFY(fit.converged);
        QCOMPARE(fit.spline.knots.spans(), std::size_t{1});
        for (int i = 0; i <= 50; ++i)
            QVERIFY((valueOf(fit.spline, 0.02 * i) - quintic(0.02 * i)).norm() < 1e-12);
    }

    void finerTolerancesAreMet()
    {
        const auto wave = [](double t) { return Vec3(t, std::sin(20 * t), std::cos(13 * t)); };
        std::size_t spans = 0;
        for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
            const auto fit = fitCurve(targetOf(wave), SplineKnots::between(0, 1), 0.1, {.tolerance = tolerance});
            QVERIFY(fit.converged);
            QVERIFY(fit.spline.knots.spans() > spans);
            spans = fit.spline.knots.spans();
            for (int i = 0; i <= 997; ++i)
                QVERIFY((valueOf(fit.spline, i / 997.0) - wave(i / 997.0)).norm() < 1.5 * tolerance);
        }
    }

    void aJumpDoesNotConverge()
    {
        const auto jump = [](double t) { return Vec3(t < 0.377 ? 0 : 1, 0, 0); };
        QVERIFY(!fitCurve(targetOf(jump), SplineKnots::between(0, 1), 0.1, {.tolerance = 1e-3}).converged);
    }

    /// What the target is where it does not count makes no difference; closed ones end where they begin, bit by bit.
    void surfacesIgnoreWhatDoesNotCount()
    {
        const auto ring = [](const Vec2& at) {
            const double turn = 2 * std::numbers::pi * at[0];
            return Vec3(std::cos(turn), std::sin(turn), at[1] + 0.1 * std::sin(3 * turn));
        };
        SurfaceToFit wanted;
        wanted.target = [&](std::span<const Vec2> parameters, std::span<Vec3> places) {
            for (std::size_t i = 0; i < parameters.size(); ++i)
                places[i] = wanted.counts(parameters[i]) ? ring(parameters[i]) : Vec3(1e3, -1e3, 1e3);
        };
        wanted.rest = [&](std::span<const Vec2> parameters, std::span<Vec3> places) {
            std::transform(parameters.begin(), parameters.end(), places.begin(), ring);
        };
        wanted.counts = wanted.isKnown = [](const Vec2& at) { return at[1] < 0.6; };
        wanted.u = wanted.v = SplineKnots::between(0, 1);
        wanted.feature = Vec2(0.1, 1);
        wanted.isClosed = {true, false};
        const auto fit = fitSurface(wanted, {.tolerance = 1e-5});
        QVERIFY(fit.converged);
        const std::size_t rows = SplineBasis(fit.spline.v, degree).size();
        const std::vector<Vec3>& poles = fit.spline.poles;
        for (std::size_t j = 0; j < rows; ++j)
            QVERIFY((poles[j] - poles[poles.size() - rows + j]).norm() < 1e-12);
        for (const Vec3& pole : poles)
            QVERIFY(pole.norm() < 10);
    }

    void linearFieldsGoOnLinearly()
    {
        const std::vector<double> u{0, 0.1, 0.5, 0.9, 1.4, 2};
        const std::vector<double> v{0, 0.3, 0.35, 1};
        std::vector<Vec3> values;
        std::vector<bool> known;
        const auto field = [](double a, double b) { return Vec3(1 + 2 * a - 3 * b, a, b); };
        for (std::size_t i = 0; i < u.size(); ++i)
            for (std::size_t j = 0; j < v.size(); ++j) {
                known.push_back(i < 3);
                values.push_back(known.back() ? field(u[i], v[j]) : Vec3(99, 99, 99));
            }
        completeGrid(u, v, known, values);
        for (std::size_t i = 0; i < u.size(); ++i)
            for (std::size_t j = 0; j < v.size(); ++j)
                QVERIFY((values[i * v.size() + j] - field(u[i], v[j])).norm() < 1e-5);
    }
};

QTEST_GUILESS_MAIN(SplineFitTest)
#include "spline_fit_test.moc"
