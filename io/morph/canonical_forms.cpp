#include "io/morph/canonical_forms.h"

#include "io/morph/millimetre_map.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <ElSLib.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Standard_Failure.hxx>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace knead {

namespace {

constexpr double largestRadius = 1e4; // in sizes of the piece: what is rounder than that is no form that anyone means
constexpr double leastConeAngle = 1e-4;
constexpr double leastHole = 1e-3; // of a torus: by which it is larger than its tube, as a share of that

using Surface = Handle(Geom_ElementarySurface);

struct Ball {
    Vec3 middle;
    double radius; ///< negative where the normals point inward
};

/// p = middle + radius n, by least squares.
/// @pre the normals differ
Ball ballOf(const std::vector<Vec3>& places, const std::vector<Vec3>& normals)
{
    const auto count = static_cast<double>(places.size());
    Vec3 place = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < places.size(); ++i) {
        place += places[i] / count;
        normal += normals[i] / count;
    }
    double product = 0;
    double square = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        product += (places[i] - place).dot(normals[i] - normal);
        square += (normals[i] - normal).squaredNorm();
    }
    const double radius = product / square;
    return {place - radius * normal, radius};
}

gp_Ax3 frameOf(const Vec3& origin, const Vec3& axis)
{
    return {toPoint(origin), gp_Dir(axis.x(), axis.y(), axis.z())};
}

class Forms {
public:
    explicit Forms(const OrientedPoints& points)
        : m_points(points)
    {
        for (const Vec3& place : points.places)
            m_middle += place / static_cast<double>(points.places.size());
        for (const Vec3& place : points.places)
            m_size = std::max(m_size, (place - m_middle).norm());
    }

    Surface cylinder() const
    {
        Mat3 spread = Mat3::Zero();
        for (const Vec3& normal : m_points.normals)
            spread += normal * normal.transpose();
        const Vec3 axis = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors().col(0);
        const auto across = [&](const Vec3& v) { return Vec3(v - axis * axis.dot(v)); };
        const Ball ball = ballOf(mapped(m_points.places, across), mapped(m_points.normals, across));
        if (!isRound(ball.radius))
            return {};
        const Vec3 origin = across(ball.middle) + axis * axis.dot(m_middle);
        return new Geom_CylindricalSurface(frameOf(origin, axis), std::abs(ball.radius));
    }

    Surface sphere() const
    {
        const Ball ball = ballOf(m_points.places, m_points.normals);
        if (!isRound(ball.radius))
            return {};
        return new Geom_SphericalSurface(frameOf(ball.middle, Vec3::UnitZ()), std::abs(ball.radius));
    }

    /// Its normals have one angle with its axis, and its tangent planes one place in common.
    Surface cone() const
    {
        Vec3 mean = Vec3::Zero();
        for (const Vec3& normal : m_points.normals)
            mean += normal / static_cast<double>(m_points.normals.size());
        Mat3 spread = Mat3::Zero();
        Mat3 planes = Mat3::Zero();
        Vec3 heights = Vec3::Zero();
        for (std::size_t i = 0; i < m_points.places.size(); ++i) {
            const Vec3& normal = m_points.normals[i];
            spread += (normal - mean) * (normal - mean).transpose();
            planes += normal * normal.transpose();
            heights += normal * normal.dot(m_points.places[i] - m_middle);
        }
        Vec3 axis = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors().col(0);
        const Vec3 apex = m_middle + planes.colPivHouseholderQr().solve(heights);
        const double angle = std::asin(std::min(1.0, std::abs(axis.dot(mean))));
        if (axis.dot(m_middle - apex) < 0)
            axis = -axis;
        const double height = axis.dot(m_middle - apex);
        const double radius = height * std::tan(angle);
        if (!(angle > leastConeAngle && angle < std::numbers::pi / 2 - leastConeAngle) || !isRound(radius))
            return {};
        return new Geom_ConicalSurface(frameOf(apex + height * axis, axis), angle, radius);
    }

    /// A surface of revolution is what turning about its axis moves along itself: n . (c x (p - a)) = 0 everywhere.
    Surface torus() const
    {
        using Vector6 = Eigen::Matrix<double, 6, 1>;
        Eigen::Matrix<double, 6, 6> lines = Eigen::Matrix<double, 6, 6>::Zero();
        for (std::size_t i = 0; i < m_points.places.size(); ++i) {
            Vector6 line;
            line << m_points.normals[i], ((m_points.places[i] - m_middle) / m_size).cross(m_points.normals[i]);
            lines += line * line.transpose();
        }
        const Vector6 motion = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(lines).eigenvectors().col(0);
        const Vec3 turn = motion.tail<3>();
        if (!(turn.norm() > 1 / largestRadius))
            return {};
        const Vec3 axis = turn.normalized();
        const Vec3 origin = m_middle + m_size * turn.cross(motion.head<3>()) / turn.squaredNorm();
        // Its section: distances from the axis and heights.
        const auto outward = [&](const Vec3& place) {
            return Vec3((place - origin - axis * axis.dot(place - origin)).normalized());
        };
        std::vector<Vec3> places;
        std::vector<Vec3> normals;
        for (std::size_t i = 0; i < m_points.places.size(); ++i) {
            const Vec3 out = outward(m_points.places[i]);
            const Vec3 place = m_points.places[i] - origin;
            places.emplace_back(out.dot(place), axis.dot(place), 0);
            normals.emplace_back(out.dot(m_points.normals[i]), axis.dot(m_points.normals[i]), 0);
        }
        const Ball tube = ballOf(places, normals);
        const double radius = std::abs(tube.radius);
        if (!isRound(radius) || !isRound(tube.middle.x()) || !(tube.middle.x() > (1 + leastHole) * radius))
            return {};
        return new Geom_ToroidalSurface(frameOf(origin + tube.middle.y() * axis, axis), tube.middle.x(), radius);
    }

private:
    static std::vector<Vec3> mapped(const std::vector<Vec3>& vectors, const std::function<Vec3(const Vec3&)>& map)
    {
        std::vector<Vec3> result(vectors.size());
        std::transform(vectors.begin(), vectors.end(), result.begin(), map);
        return result;
    }

    bool isRound(double radius) const
    {
        return std::abs(radius) < largestRadius * m_size && std::abs(radius) > m_size / largestRadius;
    }

    const OrientedPoints& m_points;
    Vec3 m_middle = Vec3::Zero();
    double m_size = 0;
};

} // namespace

std::vector<Handle(Geom_ElementarySurface)> possibleForms(const OrientedPoints& points)
{
    std::vector<Surface> forms;
    const Forms near(points);
    for (Surface (Forms::*form)() const : {&Forms::cylinder, &Forms::sphere, &Forms::cone, &Forms::torus})
        try {
            if (const Surface surface = (near.*form)(); !surface.IsNull())
                forms.push_back(surface);
        } catch (const Standard_Failure&) { // there is none with such numbers
        }
    return forms;
}

Vec2 parametersOn(const Handle(Geom_ElementarySurface) & surface, const Vec3& place)
{
    Vec2 at = Vec2::Zero();
    const gp_Ax3& frame = surface->Position();
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull())
        ElSLib::CylinderParameters(frame, cylinder->Radius(), toPoint(place), at[0], at[1]);
    else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull())
        ElSLib::ConeParameters(frame, cone->RefRadius(), cone->SemiAngle(), toPoint(place), at[0], at[1]);
    else if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface); !sphere.IsNull())
        ElSLib::SphereParameters(frame, sphere->Radius(), toPoint(place), at[0], at[1]);
    else if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface); !torus.IsNull())
        ElSLib::TorusParameters(frame, torus->MajorRadius(), torus->MinorRadius(), toPoint(place), at[0], at[1]);
    return at;
}

bool isAngle(const Handle(Geom_ElementarySurface) & surface, Eigen::Index axis)
{
    return axis == 0 || isSphere(surface) || !Handle(Geom_ToroidalSurface)::DownCast(surface).IsNull();
}

bool isSphere(const Handle(Geom_ElementarySurface) & surface)
{
    return !Handle(Geom_SphericalSurface)::DownCast(surface).IsNull();
}

double sizeOf(const Handle(Geom_ElementarySurface) & surface)
{
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull())
        return cylinder->Radius();
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull())
        return cone->RefRadius();
    if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface); !sphere.IsNull())
        return sphere->Radius();
    return Handle(Geom_ToroidalSurface)::DownCast(surface)->MajorRadius();
}

} // namespace knead
