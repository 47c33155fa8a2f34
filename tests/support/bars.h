#pragma once

#include "core/aggregate/fill.h"
#include "core/geometry/turn.h"
#include "support/shapes.h"
#include "support/static_solver.h"

#include <Eigen/Dense>

#include <cmath>
#include <memory>
#include <numbers>

/// Bars pulled, bent and twisted by statics, and what beam theory says of them.
namespace knead::bars {

using shapes::about;

constexpr double spacing = 1e-3; // [m]

enum class Section { Square, Round };

/// What beam theory knows of a section.
struct SectionValues {
    double width = 0; ///< of what is around it [m]
    double area = 0;
    double secondMoment = 0;
    double torsionConstant = 0; ///< Saint-Venant's
};

/// `cells` need not be a whole number.
inline SectionValues valuesOf(Section section, double cells)
{
    const double width = cells * spacing;
    if (section == Section::Round)
        return {width, std::numbers::pi / 4 * width * width, std::numbers::pi / 64 * std::pow(width, 4),
                std::numbers::pi / 32 * std::pow(width, 4)};
    return {width, width * width, std::pow(width, 4) / 12, 0.140577 * std::pow(width, 4)}; // of a square by its series
}

inline TriangleMesh meshOf(Section section, double width, double length)
{
    if (section == Section::Square)
        return shapes::box({length, width, width});
    return shapes::moved(shapes::cylinder(width / 2, length, 96),
                         {Vec3::Zero(), turnOnto(Vec3::UnitZ(), Vec3::UnitX())});
}

/// A bar about its axis `along` through the origin.
struct Bar {
    /// A bar with `cells` cells across and eight times as long as wide.
    Bar(Section kind, double cells, const Quaternion& turn, double poisson = 0.25)
        : Bar(meshOf(kind, cells * spacing, 8 * cells * spacing), valuesOf(kind, cells), 8 * cells * spacing, turn,
              poisson)
    {
    }

    /// @param mesh along x
    Bar(TriangleMesh mesh, const SectionValues& values, double itsLength, const Quaternion& turn, double poisson = 0.25)
        : section(values)
        , width(values.width)
        , length(itsLength)
        , along(turn * Vec3::UnitX())
        , sideways(turn * Vec3::UnitY())
        , upwards(turn * Vec3::UnitZ())
    {
        Material material;
        material.youngsModulus = youngsModulus;
        material.poissonRatio = poisson;
        shearModulus = material.shearModulus();
        mesh = shapes::moved(std::move(mesh), {Vec3::Zero(), turn});
        body =
            std::make_unique<StaticBody>(std::make_shared<const Aggregate>(fill(mesh, {.spacing = spacing})), material);
    }

    double area() const { return section.area; }
    double secondMoment() const { return section.secondMoment; }
    double torsionConstant() const { return section.torsionConstant; }

    Vec3 local(std::size_t i) const
    {
        const Vec3 x = body->place(i);
        return {x.dot(along), x.dot(sideways), x.dot(upwards)};
    }
    bool isEnd(std::size_t i) const { return std::abs(local(i).x()) > length / 2 - 0.75 * width; }
    bool isGauge(std::size_t i) const { return std::abs(local(i).x()) < length / 5; }

    /// Prescribes at both ends the displacement along one direction only; the other components stay free.
    template <typename Displacement>
    void drive(const Vec3& direction, Displacement displacement)
    {
        const double stiff = 1e3 * youngsModulus * spacing;
        for (std::size_t i = 0; i < body->size(); ++i)
            if (isEnd(i))
                body->pullTowards(i, direction, displacement(local(i)), stiff);
    }

    /// Takes the rigid motions that the load leaves free, by soft springs that bear no load.
    void tether()
    {
        const double soft = 1e-9 * youngsModulus * spacing;
        for (std::size_t i = 0; i < body->size(); ++i)
            for (const Vec3& axis : {along, sideways, upwards})
                body->pullTowards(i, axis, 0, soft);
    }

    /// Force and moment about the axis point x = 0 that the low end takes.
    std::pair<Vec3, Vec3> loadOfLowEnd()
    {
        const std::vector<Vec3> reactions = body->reactions();
        Vec3 force = Vec3::Zero();
        Vec3 moment = Vec3::Zero();
        for (std::size_t i = 0; i < body->size(); ++i)
            if (isEnd(i) && local(i).x() < 0) {
                force += reactions[i];
                moment += body->place(i).cross(reactions[i]);
            }
        return {force, moment};
    }

    /// Least-squares slope of a quantity over another, over the objects of the gauge section, weighted by volume.
    template <typename Quantity>
    double slope(Quantity quantity) const
    {
        double xx = 0;
        double xy = 0;
        for (std::size_t i = 0; i < body->size(); ++i) {
            if (!isGauge(i))
                continue;
            const auto [x, y] = quantity(local(i), body->displacement(i));
            xx += body->aggregate().volume[i] * x * x;
            xy += body->aggregate().volume[i] * x * y;
        }
        return xy / xx;
    }

    static constexpr double youngsModulus = 1e6;
    SectionValues section;
    double width;
    double length;
    double shearModulus = 0;
    Vec3 along, sideways, upwards;
    std::unique_ptr<StaticBody> body;
};

struct Tension {
    double youngsModulus; ///< by the one typed in
    double poissonRatio;
};

inline Tension tension(Bar& bar)
{
    const double strain = 1e-3;
    bar.drive(bar.along, [&](const Vec3& x) { return strain * x.x(); });
    bar.tether();
    bar.body->solve();
    const double stress = -bar.loadOfLowEnd().first.dot(bar.along) / bar.area();
    const double stretch = bar.slope([&](const Vec3& x, const Vec3& u) { return std::pair(x.x(), u.dot(bar.along)); });
    const double narrowing =
        0.5 * (bar.slope([&](const Vec3& x, const Vec3& u) { return std::pair(x.y(), u.dot(bar.sideways)); }) +
               bar.slope([&](const Vec3& x, const Vec3& u) { return std::pair(x.z(), u.dot(bar.upwards)); }));
    return {stress / stretch / Bar::youngsModulus, -narrowing / stretch};
}

/// Bending stiffness by E I.
inline double bending(Bar& bar)
{
    const double curvature = 1e-3 / bar.width;
    bar.drive(bar.along, [&](const Vec3& x) { return -curvature * x.x() * x.z(); });
    bar.tether();
    bar.body->solve();
    const double moment = bar.loadOfLowEnd().second.dot(bar.sideways);
    const double measured =
        -bar.slope([&](const Vec3& x, const Vec3& u) { return std::pair(x.x() * x.z(), u.dot(bar.along)); });
    return std::abs(moment / measured) / (Bar::youngsModulus * bar.secondMoment());
}

/// Torsional stiffness by G J.
inline double torsion(Bar& bar)
{
    const double twist = 1e-3 / bar.width;
    bar.drive(bar.sideways, [&](const Vec3& x) { return -twist * x.x() * x.z(); });
    bar.drive(bar.upwards, [&](const Vec3& x) { return twist * x.x() * x.y(); });
    bar.tether();
    bar.body->solve();
    const double moment = bar.loadOfLowEnd().second.dot(bar.along);
    const double measured =
        0.5 * (bar.slope([&](const Vec3& x, const Vec3& u) { return std::pair(x.x() * x.y(), u.dot(bar.upwards)); }) +
               bar.slope([&](const Vec3& x, const Vec3& u) { return std::pair(-x.x() * x.z(), u.dot(bar.sideways)); }));
    return std::abs(moment / measured) / (bar.shearModulus * bar.torsionConstant());
}

} // namespace knead::bars
