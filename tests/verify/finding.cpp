// Readings of what a program found, and cases made of parts.
#include "verify/part.h"

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace knead::book {

double errorOf(const Quantity& quantity, double value)
{
    return quantity.reference == 0 ? value : value / quantity.reference - 1;
}

bool isWithin(const Quantity& quantity, double value)
{
    return std::abs(errorOf(quantity, value)) <= quantity.tolerance; // false for NaN
}

Vec3 forceOn(const Finding& finding, std::size_t grip)
{
    Vec3 sum = Vec3::Zero();
    for (const PointForce& force : finding.reactions.at(grip))
        sum += force.force;
    return sum;
}

Vec3 momentOn(const Finding& finding, std::size_t grip, const Vec3& about)
{
    Vec3 sum = Vec3::Zero();
    for (const PointForce& force : finding.reactions.at(grip))
        sum += (force.now - about).cross(force.force);
    return sum;
}

SectionMotion sectionMotion(const Finding& finding, int axis, double at, double half)
{
    half = std::max(half, 0.51 * finding.spacing) + 1e-9;
    Vec3 middle = Vec3::Zero();
    Vec3 mean = Vec3::Zero();
    double count = 0;
    const auto inSlab = [&](std::size_t i) { return std::abs(finding.rest[i][axis] - at) <= half; };
    for (std::size_t i = 0; i < finding.rest.size(); ++i)
        if (inSlab(i)) {
            middle += finding.rest[i];
            mean += finding.displacement[i];
            count += 1;
        }
    middle /= count;
    mean /= count;
    // The turn w that fits u - mean = w x r best.
    Mat3 inertia = Mat3::Zero();
    Vec3 moment = Vec3::Zero();
    for (std::size_t i = 0; i < finding.rest.size(); ++i)
        if (inSlab(i)) {
            Vec3 r = finding.rest[i] - middle;
            r[axis] = 0; // points of a slab stand for their section
            inertia += r.squaredNorm() * Mat3::Identity() - r * r.transpose();
            moment += r.cross(finding.displacement[i] - mean);
        }
    return {mean, inertia.ldlt().solve(moment)};
}

Vec3 meanDisplacement(const Finding& finding, const Box& box)
{
    Vec3 sum = Vec3::Zero();
    double count = 0;
    const Vec3 grown = Vec3::Constant(0.51 * finding.spacing + 1e-9);
    const Box around(box.min() - grown, box.max() + grown);
    for (std::size_t i = 0; i < finding.rest.size(); ++i)
        if (around.contains(finding.rest[i])) {
            sum += finding.displacement[i];
            count += 1;
        }
    return sum / count; // NaN where there is nothing
}

double slope(const Finding& finding, const Box& box, int of, int along)
{
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < finding.rest.size(); ++i)
        if (box.contains(finding.rest[i])) {
            const double p = finding.rest[i][along];
            const double u = finding.displacement[i][of];
            n += 1;
            x += p;
            y += u;
            xx += p * p;
            xy += p * u;
        }
    return (n * xy - x * y) / (n * xx - x * x);
}

void pressByRoller(Part& part, const Vec3& point, double radius, double length, double down)
{
    Manipulator roller{.name = "roller", .size = {2 * radius, 2 * radius, length}};
    roller.kind = ToolKind::cylinder;
    roller.friction = 0;
    roller.pose = {point + Vec3(0, 0, radius), Quaternion(Eigen::AngleAxisd(pi / 2, Vec3::UnitX()))};
    part.tools.push_back({roller, Vec3(0, 0, -down)});
    Grip line{[point](const Vec3& p) { return std::max(std::abs(p.x() - point.x()), point.z() - p.z()); },
              [down](const Vec3&, double share) { return Vec3(0, 0, -share * down); }};
    line.axes = Vec3::UnitZ();
    line.program = Grip::Program::calculix;
    part.grips.push_back(line);
}

Case partCase(Case base, std::function<Part()> part, double acrossLength, Measure measure, bool withCalculix)
{
    base.run = [=](double cells) { return runKnead(part(), acrossLength / cells, measure); };
    if (withCalculix)
        base.calculix = [=] { return runCalculix(part(), measure); };
    return base;
}

} // namespace knead::book
