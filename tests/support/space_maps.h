#pragma once

#include "core/geometry/smooth_map.h"

#include <cmath>
#include <numbers>

namespace knead::maps {

/// A map given point by point.
class PointMap : public SmoothMap {
public:
    void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const final
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            places[i] = place(points[i]);
    }

protected:
    virtual Vec3 place(const Vec3& point) const = 0;
};

class Identity final : public PointMap {
public:
    double featureSize() const override { return 1; }

protected:
    Vec3 place(const Vec3& point) const override { return point; }
};

/// Axes of a box: its longest one, and the others with the thinner one first.
struct BoxAxes {
    int along = 0;
    int thin = 1;
    int wide = 2;

    explicit BoxAxes(const Box& box)
    {
        box.sizes().maxCoeff(&along);
        thin = (along + 1) % 3;
        wide = (along + 2) % 3;
        if (box.sizes()[thin] > box.sizes()[wide])
            std::swap(thin, wide);
    }
};

/// Bends a box along its longest axis into an arc, about its wider one; less than the angle where its inner side would fold.
class Bend final : public PointMap {
public:
    Bend(const Box& box, double angle)
        : m_axes(box)
        , m_start(box.min()[m_axes.along])
        , m_middle(box.center()[m_axes.thin])
    {
        const double length = box.sizes()[m_axes.along];
        m_radius = std::max(length / angle, 0.8 * box.sizes()[m_axes.thin]);
    }
    double featureSize() const override { return 0.5 * m_radius; }

protected:
    Vec3 place(const Vec3& point) const override
    {
        const double turn = (point[m_axes.along] - m_start) / m_radius;
        const double radius = m_radius - (point[m_axes.thin] - m_middle);
        Vec3 bent = point;
        bent[m_axes.along] = m_start + radius * std::sin(turn);
        bent[m_axes.thin] = m_middle + m_radius - radius * std::cos(turn);
        return bent;
    }

private:
    BoxAxes m_axes;
    double m_start;
    double m_middle;
    double m_radius = 1;
};

/// Twists a box about its longest axis.
class Twist final : public PointMap {
public:
    Twist(const Box& box, double angle)
        : m_axes(box)
        , m_box(box)
        , m_rate(angle / box.sizes()[m_axes.along])
    {
    }
    double featureSize() const override { return 0.5 / m_rate; }

protected:
    Vec3 place(const Vec3& point) const override
    {
        const Vec3 offset = point - m_box.center();
        const double turn = m_rate * (point[m_axes.along] - m_box.min()[m_axes.along]);
        Vec3 twisted = point;
        twisted[m_axes.thin] += (std::cos(turn) - 1) * offset[m_axes.thin] - std::sin(turn) * offset[m_axes.wide];
        twisted[m_axes.wide] += std::sin(turn) * offset[m_axes.thin] + (std::cos(turn) - 1) * offset[m_axes.wide];
        return twisted;
    }

private:
    BoxAxes m_axes;
    Box m_box;
    double m_rate;
};

/// Pushes what is near a place aside, by a Gaussian.
class Dent final : public PointMap {
public:
    Dent(const Vec3& center, const Vec3& depth, double width)
        : m_center(center)
        , m_depth(depth)
        , m_width(width)
    {
    }
    double featureSize() const override { return m_width; }

protected:
    Vec3 place(const Vec3& point) const override
    {
        return point + m_depth * std::exp(-(point - m_center).squaredNorm() / (2 * m_width * m_width));
    }

private:
    Vec3 m_center;
    Vec3 m_depth;
    double m_width;
};

} // namespace knead::maps
