#include "core/geometry/spline_fit.h"

#include "core/geometry/grid_completion.h"
#include "core/geometry/spline_fit_looks.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr int mostRounds = 24;
constexpr std::size_t mostLooks = 96; // along a span of a surface
constexpr std::size_t mostLines = 24; // along which errors are looked for, per direction
constexpr int mostSlopeRounds = 8;    // for normals
constexpr double leastGain = 0.9;     // of a lean, by one round
constexpr int mostVainRounds = 2;
constexpr double leastSine = 1e-3;       // between tangents that make a normal
constexpr double leastTrustedSine = 0.1; // below it, slopes are not asked to be better still
constexpr double slopeStep = 1e-3;       // of a feature or the surface, over which slopes are taken
constexpr double roundStep = 2e-2;       // of a feature or the surface, over which it is seen how round the target is
constexpr double largestFactor = 10;     // for errors where it is round
constexpr double lastSlack = 1.5;        // by which errors between the lines may be larger than along them

/// Every so many of a list, its first included.
std::size_t strideFor(std::size_t count)
{
    return std::max<std::size_t>(1, count / mostLines);
}

class SurfaceFitter {
public:
    SurfaceFitter(const SurfaceToFit& wanted, const SplineFitOptions& options)
        : m_wanted(wanted)
        , m_options(options)
        , m_knots{wanted.u, wanted.v}
        , m_checks(wanted.checks.size())
    {
        m_wanted.target(m_wanted.checks, m_checks);
        if (options.slopeTolerance > 0)
            findSlopes();
        findCheckFactors();
    }

    SplineFit<SplineSurface> run()
    {
        int slopeRounds = 0;
        for (int round = 0; round < mostRounds; ++round) {
            interpolate();
            m_error = 0;
            m_errors = {std::vector<double>(m_knots[0].spans(), 0), std::vector<double>(m_knots[1].spans(), 0)};
            std::array<std::vector<bool>, 2> missed{lookAlong(0), lookAlong(1)};
            if (!anyOf(missed[0]) && !anyOf(missed[1]))
                lookAllOver(missed);
            const bool isClose = !anyOf(missed[0]) && !anyOf(missed[1]);
            if (isClose && slopeRounds++ < mostSlopeRounds)
                lookAtSlopes(missed);
            if (!anyOf(missed[0]) && !anyOf(missed[1]))
                return result(true);
            if (!refine(missed))
                return result(isClose);
        }
        return result(false);
    }

private:
    /// The target's tangents at a place, by differences between places on both sides of it.
    struct Slope {
        std::array<Vec2, 4> around; ///< before and behind along u, then along v
        Vec3 normal;                ///< of length 1
        double tolerance;           ///< sine of the angle by which a tangent may lean: less where tangents are nearly
                                    ///< parallel, which turns a normal the more
        std::array<double, 2> leastLean; ///< along u and v, of all rounds
        std::array<int, 2> vain;         ///< rounds that have not made it less
    };

    void findSlopes()
    {
        const std::array<Vec2, 2> limits{Vec2(m_wanted.u.values.front(), m_wanted.v.values.front()),
                                         Vec2(m_wanted.u.values.back(), m_wanted.v.values.back())};
        std::vector<Vec2> parameters;
        for (const Vec2& check : m_wanted.checks)
            for (Eigen::Index axis = 0; axis < 2; ++axis)
                for (const double side : {-1.0, 1.0}) {
                    Vec2 there = check;
                    const double step = slopeStep * std::min(m_wanted.feature[axis], limits[1][axis] - limits[0][axis]);
                    there[axis] = std::clamp(check[axis] + side * step, limits[0][axis], limits[1][axis]);
                    parameters.push_back(there);
                }
        std::vector<Vec3> places(parameters.size());
        m_wanted.target(parameters, places);
        for (std::size_t i = 0; i + 4 <= places.size(); i += 4) {
            const Vec3 alongU = places[i + 1] - places[i];
            const Vec3 alongV = places[i + 3] - places[i + 2];
            const Vec3 normal = alongU.cross(alongV);
            const double sine = normal.norm() / (alongU.norm() * alongV.norm());
            if (sine > leastSine) // else: a pole, which has no normal
                m_slopes.push_back({{parameters[i], parameters[i + 1], parameters[i + 2], parameters[i + 3]},
                                    normal.normalized(),
                                    m_options.slopeTolerance * std::max(sine, leastTrustedSine),
                                    {1, 1},
                                    {0, 0}});
        }
    }

    /// Where a surface is round, being a little along it from where one should be turns the normal: there errors count as so many
    /// times as large as they are.
    void findCheckFactors()
    {
        m_checkFactors.assign(m_wanted.checks.size(), 1);
        if (!(m_options.slopeTolerance > 0))
            return;
        std::vector<Vec2> parameters;
        for (const Vec2& check : m_wanted.checks)
            for (Eigen::Index axis = 0; axis < 2; ++axis) {
                const double low = (axis == 0 ? m_wanted.u : m_wanted.v).values.front();
                const double high = (axis == 0 ? m_wanted.u : m_wanted.v).values.back();
                const double step = roundStep * std::min(m_wanted.feature[axis], high - low);
                for (const double side : {-1.0, 0.0, 1.0}) {
                    Vec2 there = check;
                    there[axis] = std::clamp(check[axis], low + step, high - step) + side * step;
                    parameters.push_back(there);
                }
            }
        std::vector<Vec3> places(parameters.size());
        m_wanted.target(parameters, places);
        for (std::size_t i = 0; i < places.size(); i += 3) {
            const Vec3 tangent = 0.5 * (places[i + 2] - places[i]);
            const Vec3 bend = places[i + 2] - 2 * places[i + 1] + places[i];
            const double length = tangent.squaredNorm();
            const double curvature = length > 0 ? (bend - bend.dot(tangent) / length * tangent).norm() / length : 0;
            const double factor = curvature * m_options.tolerance / m_options.slopeTolerance;
            m_checkFactors[i / 6] = std::max(m_checkFactors[i / 6], std::min(factor, largestFactor));
        }
    }

    /// The direction whose tangents lean out of the target's surface is refined.
    void lookAtSlopes(std::array<std::vector<bool>, 2>& missed)
    {
        for (Slope& slope : m_slopes)
            for (std::size_t direction = 0; direction < 2; ++direction) {
                const Vec2& from = slope.around[2 * direction];
                const Vec2& to = slope.around[2 * direction + 1];
                const Vec3 tangent = at(to) - at(from);
                const double lean = std::abs(tangent.dot(slope.normal)) / tangent.norm();
                if (!(lean > slope.tolerance) || slope.vain[direction] > mostVainRounds)
                    continue; // good, or at a kink of the target's own, where more knots do not help
                slope.vain[direction] += lean > leastGain * slope.leastLean[direction] ? 1 : 0;
                slope.leastLean[direction] = std::min(slope.leastLean[direction], lean);
                const Vec2 middle = 0.5 * (from + to);
                missed[direction][m_knots[direction].spanOf(middle[static_cast<Eigen::Index>(direction)])] = true;
            }
    }

    void interpolate()
    {
        m_fitted = m_knots;
        m_bases.clear();
        for (const SplineKnots& knots : m_knots)
            m_bases.emplace_back(knots, m_options.degree);
        const std::size_t nu = m_bases[0].size();
        const std::size_t nv = m_bases[1].size();
        std::vector<Vec2> parameters;
        parameters.reserve(nu * nv);
        for (const double u : m_bases[0].greville())
            for (const double v : m_bases[1].greville())
                parameters.emplace_back(u, v);
        m_poles = placesAt(parameters);
        for (std::size_t j = 0; j < nv; ++j)
            m_bases[0].interpolate(&m_poles[j], nv);
        for (std::size_t i = 0; i < nu; ++i)
            m_bases[1].interpolate(&m_poles[i * nv], 1);
    }

    /// The target where it is known, and something smooth that goes with it elsewhere: there it may be anything, and jump.
    std::vector<Vec3> placesAt(const std::vector<Vec2>& grid) const
    {
        std::vector<bool> known(grid.size());
        std::vector<Vec2> asked;
        for (std::size_t i = 0; i < grid.size(); ++i)
            if (known[i] = m_wanted.isKnown(grid[i]); known[i])
                asked.push_back(grid[i]);
        std::vector<Vec3> found(asked.size());
        m_wanted.target(asked, found);
        std::vector<Vec3> places(grid.size(), Vec3::Zero());
        for (std::size_t i = 0, next = 0; i < grid.size(); ++i)
            if (known[i])
                places[i] = found[next++];
        joinEnds(places, known);
        if (std::ranges::find(known, false) == known.end())
            return places;
        std::vector<Vec3> rest(grid.size());
        m_wanted.rest(grid, rest);
        std::vector<Vec3> displacements(grid.size(), Vec3::Zero());
        for (std::size_t i = 0; i < grid.size(); ++i)
            if (known[i])
                displacements[i] = places[i] - rest[i];
        completeGrid(linesOf(0), linesOf(1), known, displacements);
        for (std::size_t i = 0; i < grid.size(); ++i)
            places[i] = known[i] ? places[i] : rest[i] + displacements[i];
        std::vector<bool> all(grid.size(), true);
        joinEnds(places, all);
        return places;
    }

    /// Where the target is closed, its two ends become the same, bit by bit, and both are known where one of them is.
    void joinEnds(std::vector<Vec3>& places, std::vector<bool>& known) const
    {
        const std::size_t nu = m_bases[0].size();
        const std::size_t nv = m_bases[1].size();
        const auto join = [&](std::size_t first, std::size_t last) {
            if (known[first])
                places[last] = places[first];
            else
                places[first] = places[last];
            known[first] = known[last] = known[first] || known[last];
        };
        if (m_wanted.isClosed[0])
            for (std::size_t j = 0; j < nv; ++j)
                join(j, (nu - 1) * nv + j);
        if (m_wanted.isClosed[1])
            for (std::size_t i = 0; i < nu; ++i)
                join(i * nv, i * nv + nv - 1);
    }

    /// Greville lines in features, which are about the same length in both directions.
    std::vector<double> linesOf(std::size_t direction) const
    {
        std::vector<double> lines = m_bases[direction].greville();
        for (double& line : lines)
            line /= m_wanted.feature[static_cast<Eigen::Index>(direction)];
        return lines;
    }

    Vec3 at(const Vec2& parameters) const
    {
        SplineBasis::Values u;
        SplineBasis::Values v;
        const std::size_t firstU = m_bases[0].functionsAt(parameters[0], u);
        const std::size_t firstV = m_bases[1].functionsAt(parameters[1], v);
        const auto degree = static_cast<std::size_t>(m_options.degree);
        Vec3 place = Vec3::Zero();
        for (std::size_t i = 0; i <= degree; ++i) {
            const Vec3* row = &m_poles[(firstU + i) * m_bases[1].size() + firstV];
            Vec3 sum = Vec3::Zero();
            for (std::size_t j = 0; j <= degree; ++j)
                sum += v[j] * row[j];
            place += u[i] * sum;
        }
        return place;
    }

    /// Errors inside the spans of one direction, along the Greville lines of the other: the spline meets the target at every
    /// Greville point, so these errors come from this direction alone.
    std::vector<bool> lookAlong(std::size_t direction)
    {
        const std::size_t across = 1 - direction;
        const std::vector<double>& lines = m_bases[across].greville();
        std::vector<Vec2> parameters;
        std::vector<std::size_t> spans;
        const SplineKnots& knots = m_knots[direction];
        for (std::size_t span = 0; span < knots.spans(); ++span)
            for (const double look : looksInto(knots.values[span], knots.values[span + 1],
                                               m_wanted.feature[static_cast<Eigen::Index>(direction)], mostLooks))
                for (std::size_t line = 0; line < lines.size(); line += strideFor(lines.size())) {
                    const Vec2 at = direction == 0 ? Vec2(look, lines[line]) : Vec2(lines[line], look);
                    if (!m_wanted.counts(at))
                        continue;
                    parameters.push_back(at);
                    spans.push_back(span);
                }
        std::vector<bool> missed(knots.spans(), false);
        forEachError(parameters, [&](std::size_t i, double error) {
            m_errors[direction][spans[i]] = std::max(m_errors[direction][spans[i]], error);
            if (!(error <= m_options.tolerance))
                missed[spans[i]] = true;
        });
        return missed;
    }

    /// At the places that matter most, then in the middle of every patch, or more often where features are smaller.
    void lookAllOver(std::array<std::vector<bool>, 2>& missed)
    {
        const auto note = [&](const Vec2& at, double error) {
            if (error <= lastSlack * m_options.tolerance)
                return;
            const std::size_t u = m_knots[0].spanOf(at[0]);
            const std::size_t v = m_knots[1].spanOf(at[1]);
            // The direction with the larger error of its own, or both.
            const bool alongU = m_errors[0][u] > 0.5 * m_errors[1][v];
            const bool alongV = m_errors[1][v] > 0.5 * m_errors[0][u];
            missed[0][u] = missed[0][u] || alongU || !alongV;
            missed[1][v] = missed[1][v] || alongV || !alongU;
        };
        for (std::size_t i = 0; i < m_checks.size(); ++i) {
            const double error = (at(m_wanted.checks[i]) - m_checks[i]).norm();
            noteError(m_wanted.checks[i], error);
            note(m_wanted.checks[i], m_checkFactors[i] * error);
        }
        if (anyOf(missed[0]) || anyOf(missed[1]))
            return;
        std::vector<Vec2> parameters;
        for (const double u : middles(0))
            for (const double v : middles(1))
                if (const Vec2 at(u, v); m_wanted.counts(at))
                    parameters.push_back(at);
        forEachError(parameters, [&](std::size_t i, double error) { note(parameters[i], error); });
    }

    std::vector<double> middles(std::size_t direction) const
    {
        const SplineKnots& knots = m_knots[direction];
        std::vector<double> all;
        for (std::size_t span = 0; span < knots.spans(); ++span) {
            const double length = knots.values[span + 1] - knots.values[span];
            const double feature = m_wanted.feature[static_cast<Eigen::Index>(direction)];
            const auto count =
                static_cast<int>(std::clamp(std::ceil(length / feature), 1.0, static_cast<double>(mostLooks)));
            for (int i = 0; i < count; ++i)
                all.push_back(knots.values[span] + length * (i + 0.5) / count);
        }
        return all;
    }

    template <typename Visit>
    void forEachError(const std::vector<Vec2>& parameters, Visit&& visit)
    {
        std::vector<Vec3> places(parameters.size());
        m_wanted.target(parameters, places);
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const double error = (at(parameters[i]) - places[i]).norm();
            noteError(parameters[i], error);
            visit(i, error);
        }
    }

    void noteError(const Vec2& where, double error)
    {
        if (error <= m_error)
            return;
        m_error = error;
        m_worst = where;
    }

    /// @return whether there was anything left to refine
    bool refine(const std::array<std::vector<bool>, 2>& missed)
    {
        std::array<SplineKnots, 2> finer = m_knots;
        for (std::size_t direction = 0; direction < 2; ++direction)
            if (const SplineKnots split = m_knots[direction].split(missed[direction]);
                split.spans() <= m_options.mostSpans)
                finer[direction] = split;
        const auto degree = static_cast<std::size_t>(m_options.degree);
        const bool changed = finer[0].spans() + finer[1].spans() > m_knots[0].spans() + m_knots[1].spans();
        if (!changed || (finer[0].spans() + degree) * (finer[1].spans() + degree) > m_options.mostPoles)
            return false;
        m_knots = std::move(finer);
        return true;
    }

    SplineFit<SplineSurface> result(bool converged)
    {
        return {{{m_fitted[0].values, m_bases[0].multiplicities()},
                 {m_fitted[1].values, m_bases[1].multiplicities()},
                 m_options.degree,
                 std::move(m_poles)},
                m_error,
                converged,
                m_worst};
    }

    const SurfaceToFit& m_wanted;
    const SplineFitOptions& m_options;
    std::array<SplineKnots, 2> m_knots;  // of the present round, finer from one to the next
    std::array<SplineKnots, 2> m_fitted; // that the poles belong to
    std::vector<SplineBasis> m_bases;
    std::vector<Vec3> m_poles;
    std::vector<Vec3> m_checks;                  // places wanted there
    std::vector<double> m_checkFactors;          // that errors there are multiplied by
    std::vector<Slope> m_slopes;                 // wanted there
    std::array<std::vector<double>, 2> m_errors; // largest per span, along lines
    double m_error = 0;
    Vec2 m_worst = Vec2::Zero();
};

} // namespace

SplineFit<SplineSurface> fitSurface(const SurfaceToFit& wanted, const SplineFitOptions& options)
{
    return SurfaceFitter(wanted, options).run();
}

} // namespace knead
