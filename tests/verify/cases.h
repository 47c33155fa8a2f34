#pragma once

#include "verify/part.h"

#include <cmath>
#include <vector>

/// The chapters of the book. Each adds its cases.
namespace knead::book {

void addElasticCases(std::vector<Case>& cases);
void addBendingCases(std::vector<Case>& cases);
void addStressCases(std::vector<Case>& cases);
void addStructureCases(std::vector<Case>& cases);
void addPlasticCases(std::vector<Case>& cases);
void addFormingCases(std::vector<Case>& cases);
void addRubberCases(std::vector<Case>& cases);
void addContactCases(std::vector<Case>& cases);
void addMotionCases(std::vector<Case>& cases);
void addMeasuredCases(std::vector<Case>& cases);

/// A material of which only the elastic constants matter.
inline Material elastic(double youngsModulus, double poissonRatio)
{
    Material material;
    material.youngsModulus = youngsModulus;
    material.poissonRatio = poissonRatio;
    material.dampingRatio = 0.1;
    return material;
}

inline Material plastic(double youngsModulus, double poissonRatio, double yieldStress, double hardening)
{
    Material material = elastic(youngsModulus, poissonRatio);
    material.yieldStress = yieldStress;
    material.hardening = hardening;
    return material;
}

/// Of a bar, lowest angular frequencies over sqrt(E / rho) [1/m].
inline double pullingFrequency(double length)
{
    return pi / length; // both ends held
}
inline double bendingFrequency(double length, double height, double factor = 22.4)
{
    return factor * height / (std::sqrt(12.0) * length * length); // 22.4: both ends held, 3.516: one
}
inline double twistingFrequency(double length, double poissonRatio)
{
    return pi / length / std::sqrt(2 * (1 + poissonRatio));
}

/// A grip of bending about y.
inline Grip bent(Grip grip)
{
    grip.together = Grip::Together::alike;
    return grip;
}

/// Grips that bend a bar along x to an arc of a circle whose length stays; its ends go down.
/// @param angle between its ends [rad]
inline std::vector<Grip> arcEnds(double length, double angle)
{
    const auto end = [=](double sign) {
        return Grip{beyond(0, sign, length / 2),
                    [=](const Vec3& p, double share) {
                        const double half = share * angle / 2;
                        if (half <= 0)
                            return Vec3(Vec3::Zero());
                        const double radius = length / 2 / half;
                        const Vec3 center(sign * length / 2, 0, 0);
                        const Vec3 to(sign * radius * std::sin(half), 0, -radius * (1 - std::cos(half)));
                        return Vec3(to + Eigen::AngleAxisd(sign * half, Vec3::UnitY()) * (p - center) - p);
                    },
                    Grip::Together::alike};
    };
    return {end(-1), end(1)};
}

} // namespace knead::book
