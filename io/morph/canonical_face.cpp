#include "io/morph/canonical_face.h"

#include "io/morph/canonical_forms.h"
#include "io/morph/millimetre_map.h"

#include <Eigen/Dense>
#include <GeomAdaptor_Surface.hxx>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace knead {

namespace {

constexpr double fullTurn = 2 * std::numbers::pi;
constexpr double derivativeStep = 1e-3; // of the box, along u and v
constexpr double simplicity = 1e-9;     // of the size: what parameters that are meant to be simple numbers are off by
constexpr double nearPole = 1e-2;       // [rad] from which on the longitude of a sphere says little

/// The nearest to a number that an angle may be called.
double unwrapped(double angle, double expected)
{
    return angle + fullTurn * std::round((expected - angle) / fullTurn);
}

class Recognition {
public:
    Recognition(const SurfacePiece& piece, double tolerance)
        : m_piece(piece)
        , m_tolerance(tolerance)
        , m_range(piece.high - piece.low)
    {
        const std::size_t step = (piece.inside.size() + mostLooks - 1) / mostLooks;
        for (std::size_t i = step / 2; i < piece.inside.size(); i += step)
            m_looks.push_back(piece.inside[i]);
    }

    std::optional<CanonicalSurface> result()
    {
        const OrientedPoints points = orientedPoints();
        if (points.places.size() < leastPoints)
            return std::nullopt;
        for (const Handle(Geom_ElementarySurface) & form : possibleForms(points)) {
            if (!isNear(form, points.places))
                continue;
            lookEverywhere();
            if (const auto found = inParametersOf(form))
                return found;
        }
        return std::nullopt;
    }

private:
    static constexpr std::size_t leastPoints = 9;
    static constexpr std::size_t mostLooks = 36; // before more is looked at: most faces are of no form

    void lookEverywhere()
    {
        if (!m_all.empty())
            return;
        m_all = m_piece.inside;
        m_all.insert(m_all.end(), m_piece.border.begin(), m_piece.border.end());
        m_places.resize(m_all.size());
        m_piece.places(m_all, m_places);
    }

    bool isNear(const Handle(Geom_ElementarySurface) & form, const std::vector<Vec3>& places) const
    {
        const GeomAdaptor_Surface surface(form);
        return std::ranges::all_of(places, [&](const Vec3& place) {
            const Vec2 at = parametersOn(form, place);
            return (toVec3(surface.Value(at[0], at[1]).XYZ()) - place).norm() <= m_tolerance;
        });
    }

    /// x_u and x_v by central differences of fourth order.
    OrientedPoints orientedPoints() const
    {
        constexpr std::array<double, 4> at{-2, -1, 1, 2};
        constexpr std::array<double, 4> weight{1.0 / 12, -8.0 / 12, 8.0 / 12, -1.0 / 12};
        std::vector<Vec2> parameters;
        for (const Vec2& look : m_looks)
            for (Eigen::Index axis = 0; axis < 2; ++axis)
                for (const double step : at) {
                    parameters.push_back(look);
                    parameters.back()[axis] += step * derivativeStep * m_range[axis];
                }
        const std::size_t stencils = parameters.size();
        parameters.insert(parameters.end(), m_looks.begin(), m_looks.end());
        std::vector<Vec3> places(parameters.size());
        m_piece.places(parameters, places);
        OrientedPoints points;
        for (std::size_t i = 0; i < m_looks.size(); ++i) {
            std::array<Vec3, 2> along{Vec3::Zero(), Vec3::Zero()};
            for (std::size_t k = 0; k < 8; ++k)
                along[k / 4] += weight[k % 4] * places[8 * i + k];
            const Vec3 normal = along[0].cross(along[1]);
            if (!(normal.norm() > simplicity * along[0].norm() * along[1].norm()))
                continue;
            points.places.push_back(places[stencils + i]);
            points.normals.push_back(normal.normalized());
        }
        return points;
    }

    std::optional<CanonicalSurface> inParametersOf(const Handle(Geom_ElementarySurface) & form) const
    {
        auto map = parameterMap(form);
        if (!map || !closesAsThePiece(*map, form))
            return std::nullopt;
        CanonicalSurface found{form, *map, 0};
        turnSeamAway(found);
        const GeomAdaptor_Surface surface(found.surface);
        for (std::size_t i = 0; i < m_all.size(); ++i) {
            const Vec2 at = found.parameters.at(m_all[i]);
            found.error = std::max(found.error, (toVec3(surface.Value(at[0], at[1]).XYZ()) - m_places[i]).norm());
            if (!(found.error <= m_tolerance))
                return std::nullopt;
        }
        return found;
    }

    /// By least squares over all places, angles being what they are expected to be from a place in the middle.
    std::optional<ParameterMap> parameterMap(const Handle(Geom_ElementarySurface) & form) const
    {
        ParameterMap guess;
        const Vec2 middle = m_piece.inside[m_piece.inside.size() / 2];
        for (Eigen::Index axis = 0; axis < 2; ++axis) {
            std::array<Vec2, 2> at{middle, middle};
            at[0][axis] -= derivativeStep * m_range[axis];
            at[1][axis] += derivativeStep * m_range[axis];
            std::array<Vec3, 2> places;
            m_piece.places(at, places);
            const Vec2 before = parametersOn(form, places[0]);
            const Vec2 step = near(form, parametersOn(form, places[1]), before) - before;
            guess.linear.col(axis) = step / (2 * derivativeStep * m_range[axis]);
            guess.shift = before + step / 2 - guess.linear * middle; // of the last axis, with both columns
        }
        Eigen::Matrix<double, Eigen::Dynamic, 3> rows(static_cast<Eigen::Index>(m_all.size()), 3);
        Eigen::Matrix<double, Eigen::Dynamic, 2> wanted(rows.rows(), 2);
        Eigen::Index count = 0;
        for (std::size_t i = 0; i < m_all.size(); ++i) {
            const Vec2 found = parametersOn(form, m_places[i]);
            if (isAtPole(form, found))
                continue;
            const Vec2 share = (m_all[i] - m_piece.low).cwiseQuotient(m_range);
            rows.row(count) << share[0], share[1], 1;
            wanted.row(count++) = near(form, found, guess.at(m_all[i]));
        }
        if (count < 6)
            return std::nullopt;
        const Eigen::Matrix<double, 3, 2> solved =
            rows.topRows(count).colPivHouseholderQr().solve(wanted.topRows(count));
        if (!solved.allFinite())
            return std::nullopt;
        return simplified(solved, form);
    }

    /// With numbers that are meant to be 0 or 1.
    /// @param shares what a step through the box adds along u and v, and the parameters at its low corner
    ParameterMap simplified(Eigen::Matrix<double, 3, 2> shares, const Handle(Geom_ElementarySurface) & form) const
    {
        ParameterMap map;
        const double length = sizeOf(form);
        for (Eigen::Index to = 0; to < 2; ++to)
            for (Eigen::Index from = 0; from < 2; ++from) {
                const double small = simplicity * (isAngle(form, to) ? 1 : length);
                double share = shares(from, to);
                if (std::abs(share) < small)
                    share = 0;
                else if (std::abs(std::abs(share) - m_range[from]) < small)
                    share = std::copysign(m_range[from], share);
                map.linear(to, from) = share / m_range[from];
                shares(from, to) = share;
            }
        map.shift = shares.row(2).transpose() - map.linear * m_piece.low;
        return map;
    }

    /// A direction in which the piece ends where it begins must go once around; others less than that.
    bool closesAsThePiece(ParameterMap& map, const Handle(Geom_ElementarySurface) & form) const
    {
        for (Eigen::Index from = 0; from < 2; ++from) {
            if (!m_piece.isClosed[static_cast<std::size_t>(from)])
                continue;
            const Eigen::Index to = std::abs(map.linear(0, from)) > 0 ? 0 : 1;
            const double around = map.linear(to, from) * m_range[from];
            if (map.linear(1 - to, from) != 0 || map.linear(to, 1 - from) != 0 || !isAngle(form, to) ||
                std::abs(std::abs(around) - fullTurn) > simplicity)
                return false;
            map.linear(to, from) = std::copysign(fullTurn, around) / m_range[from];
        }
        for (Eigen::Index to = 0; to < 2; ++to)
            if (isAngle(form, to) && spanOf(map, to) > fullTurn + simplicity)
                return false;
        return map.linear.determinant() != 0;
    }

    double spanOf(const ParameterMap& map, Eigen::Index to) const
    {
        return std::abs(map.linear(to, 0)) * m_range[0] + std::abs(map.linear(to, 1)) * m_range[1];
    }

    double lowOf(const ParameterMap& map, Eigen::Index to) const
    {
        return map.at(0.5 * (m_piece.low + m_piece.high))[to] - spanOf(map, to) / 2;
    }

    /// Where the surface's own parameters begin anew lies opposite of the piece, or where the piece closes.
    void turnSeamAway(CanonicalSurface& found) const
    {
        const bool goesAround = spanOf(found.parameters, 0) > fullTurn - simplicity;
        const double middle = lowOf(found.parameters, 0) + spanOf(found.parameters, 0) / 2;
        const double turn = goesAround ? lowOf(found.parameters, 0) : middle - std::numbers::pi;
        gp_Ax3 frame = found.surface->Position();
        frame.Rotate(frame.Axis(), turn);
        found.surface = Handle(Geom_ElementarySurface)::DownCast(found.surface->Copy());
        found.surface->SetPosition(frame);
        found.parameters.shift[0] -= turn;
        if (isPeriodic(found.surface, 1))
            found.parameters.shift[1] -= fullTurn * std::floor(lowOf(found.parameters, 1) / fullTurn + simplicity);
    }

    static Vec2 near(const Handle(Geom_ElementarySurface) & form, Vec2 found, const Vec2& expected)
    {
        for (Eigen::Index axis = 0; axis < 2; ++axis)
            if (isPeriodic(form, axis))
                found[axis] = unwrapped(found[axis], expected[axis]);
        return found;
    }

    static bool isPeriodic(const Handle(Geom_ElementarySurface) & form, Eigen::Index axis)
    {
        return axis == 0 ? form->IsUPeriodic() : form->IsVPeriodic();
    }

    static bool isAtPole(const Handle(Geom_ElementarySurface) & form, const Vec2& at)
    {
        return isSphere(form) && std::abs(at[1]) > std::numbers::pi / 2 - nearPole;
    }

    const SurfacePiece& m_piece;
    double m_tolerance;
    Vec2 m_range;
    std::vector<Vec2> m_looks; // some inside
    std::vector<Vec2> m_all;   // inside and on the border
    std::vector<Vec3> m_places;
};

} // namespace

std::optional<CanonicalSurface> canonicalSurface(const SurfacePiece& piece, double tolerance)
{
    if (piece.inside.empty())
        return std::nullopt;
    return Recognition(piece, tolerance).result();
}

} // namespace knead
