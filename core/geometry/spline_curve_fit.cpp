#include "core/geometry/spline_fit.h"
#include "core/geometry/spline_fit_looks.h"

namespace knead {

namespace {

constexpr int mostCurveRounds = 24;
constexpr std::size_t mostLooksAlongCurves = 480;

class CurveFitter {
public:
    CurveFitter(const CurveTarget& target, const SplineKnots& start, double feature, const SplineFitOptions& options)
        : m_target(target)
        , m_knots(start)
        , m_feature(feature)
        , m_options(options)
    {
    }

    SplineFit<SplineCurve> run()
    {
        SplineFit<SplineCurve> fit;
        for (int round = 0; round < mostCurveRounds; ++round) {
            const SplineBasis basis(m_knots, m_options.degree);
            std::vector<Vec3> poles(basis.size());
            m_target(basis.greville(), poles);
            basis.interpolate(poles.data(), 1);
            const std::vector<bool> missed = findMisses(basis, poles, fit.error);
            fit.spline = {{m_knots.values, basis.multiplicities()}, m_options.degree, std::move(poles)};
            fit.converged = !anyOf(missed);
            if (fit.converged)
                break;
            m_knots = m_knots.split(missed);
            if (m_knots.spans() > m_options.mostSpans)
                break;
        }
        return fit;
    }

private:
    std::vector<bool> findMisses(const SplineBasis& basis, const std::vector<Vec3>& poles, double& error) const
    {
        std::vector<double> parameters;
        std::vector<std::size_t> spans;
        for (std::size_t span = 0; span < m_knots.spans(); ++span)
            for (const double parameter :
                 looksInto(m_knots.values[span], m_knots.values[span + 1], m_feature, mostLooksAlongCurves)) {
                parameters.push_back(parameter);
                spans.push_back(span);
            }
        std::vector<Vec3> places(parameters.size());
        m_target(parameters, places);
        std::vector<bool> missed(m_knots.spans(), false);
        error = 0;
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            SplineBasis::Values values;
            const std::size_t first = basis.functionsAt(parameters[i], values);
            Vec3 place = Vec3::Zero();
            for (std::size_t k = 0; k <= static_cast<std::size_t>(m_options.degree); ++k)
                place += values[k] * poles[first + k];
            const double distance = (place - places[i]).norm();
            error = std::max(error, distance);
            if (!(distance <= m_options.tolerance))
                missed[spans[i]] = true;
        }
        return missed;
    }

    const CurveTarget& m_target;
    SplineKnots m_knots;
    double m_feature;
    const SplineFitOptions& m_options;
};

} // namespace

SplineFit<SplineCurve> fitCurve(const CurveTarget& target, const SplineKnots& start, double feature,
                                const SplineFitOptions& options)
{
    return CurveFitter(target, start, feature, options).run();
}

} // namespace knead
