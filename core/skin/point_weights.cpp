#include "core/skin/point_weights.h"

#include "core/kernels/kernels.h"
#include "core/skin/shape_functions.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>

namespace knead {

namespace {

constexpr double wantedForPlaces = 6.4; // objects in the support, counted by their weight
constexpr double wantedForSlopes = 4.5; // the same of a fit for slopes: of 3.5 to 8 the best of stress at holes
constexpr double usual = 3;             // [a] the support below a flat face
constexpr double widest = 4.2;          // [a] as far as the neighborhoods of a cell go
constexpr double nodesWithin = 1.7;     // [a] the support reaches so far beyond the nearest object
constexpr double lastStep = 1e-7;       // of the support: the square of it is what the last step leaves
constexpr int mostSteps = 60;

constexpr std::size_t most = 1024; // objects of a neighborhood: a cube of ten nodes, in whole lanes

/// The objects around a point, from the middle of their owner outward, with the support that a fit there has.
class PointFit {
public:
    PointFit(const Neighborhood& around, const Vec3& coordinates, double wanted)
        : m_kernels(kernels::best())
        , m_around(around)
        , m_ofSet(around.sharesOfSets(coordinates))
        , m_point(coordinates - around.middle())
        , m_away(m_point.norm())
    {
        assert(kernels::inFitLanes(around.objects.size()) <= most);
        m_nearest = look(countWithin(widest));
        if (m_nearest > widest - nodesWithin) // the support may be wider, or none of these is the nearest one
            m_nearest = look(kernels::inFitLanes(around.objects.size()));
        m_support = supportFor(wanted);
    }

    double support() const { return m_support; }

    /// Those that may be in the support.
    kernels::FitNodes nodes() const { return within(m_support); }

    /// Which object of the neighborhood a node is. @pre it is one
    std::size_t objectOf(std::size_t node) const { return m_around.outward.order[node]; }
    std::size_t objectsAmong(std::size_t nodes) const { return std::min(nodes, m_around.objects.size()); }

private:
    std::size_t countWithin(double radius) const
    {
        return kernels::inFitLanes(std::max<std::size_t>(1, m_around.mostWithin(radius, m_away)));
    }

    kernels::FitNodes within(double radius) const
    {
        return {{m_place[0].data(), m_place[1].data(), m_place[2].data()},
                m_distance.data(),
                m_share.data(),
                std::min(m_looked, countWithin(radius))};
    }

    /// Finds out about so many. @return distance of the nearest
    double look(std::size_t count)
    {
        m_looked = count;
        const std::size_t there = objectsAmong(count);
        for (std::size_t i = 0; i < there; ++i)
            m_share[i] = m_ofSet[m_around.walksOf[m_around.outward.order[i]]];
        std::fill(m_share.begin() + static_cast<std::ptrdiff_t>(there),
                  m_share.begin() + static_cast<std::ptrdiff_t>(count), 0);
        const auto& steps = m_around.outward.steps;
        return m_kernels.lookAround(count, {steps[0].data(), steps[1].data(), steps[2].data()},
                                    {m_point.x(), m_point.y(), m_point.z()},
                                    {m_place[0].data(), m_place[1].data(), m_place[2].data()}, m_distance.data());
    }

    /// The radius of a sphere around the point that holds enough objects for what is asked of them, and hardly more, by Newton's
    /// method. It changes as smoothly as the point moves: with one fixed radius, a layer of objects would come in and go out
    /// again along a flat face.
    double supportFor(double wanted) const
    {
        const double largest = std::max(widest, m_nearest + nodesWithin); // so that it holds some
        double low = m_nearest;
        double high = largest;
        double support = std::min(largest, std::max(usual, m_nearest + nodesWithin));
        for (int i = 0; i < mostSteps; ++i) {
            const auto [count, slope] = m_kernels.content(within(support), support);
            if (support == largest && count <= wanted)
                return largest;
            (count > wanted ? high : low) = support;
            const double next = support - (count - wanted) / slope;
            if (std::abs(next - support) <= lastStep * support)
                return next;
            support = next >= largest ? largest : next > low && next < high ? next : (low + high) / 2;
        }
        return support;
    }

    const kernels::Kernels& m_kernels;
    const Neighborhood& m_around;
    std::vector<double> m_ofSet;
    Vec3 m_point; // from the middle of the owner
    double m_away;
    std::size_t m_looked = 0; // so many nodes are filled in
    double m_nearest = 0;
    double m_support = 0;
    // Not set at first: only what is looked at is.
    std::array<std::array<double, most>, 3> m_place;
    std::array<double, most> m_distance;
    std::array<double, most> m_share;
};

} // namespace

std::vector<double> pointWeights(const Neighborhood& around, const Vec3& coordinates)
{
    const PointFit fit(around, coordinates, wantedForPlaces);
    const kernels::FitNodes nodes = fit.nodes();
    std::array<double, most> functions;
    shapeFunctions(nodes, fit.support(), std::span(functions).first(nodes.count));
    std::vector<double> weights(around.objects.size(), 0);
    for (std::size_t i = 0; i < fit.objectsAmong(nodes.count); ++i)
        weights[fit.objectOf(i)] = functions[i];
    return weights;
}

ShapeSlopes pointSlopes(const Neighborhood& around, const Vec3& coordinates)
{
    const PointFit fit(around, coordinates, wantedForSlopes);
    const kernels::FitNodes nodes = fit.nodes();
    const ShapeSlopes ofNodes = shapeSlopes(nodes, fit.support());
    ShapeSlopes shape{.values = std::vector<double>(around.objects.size(), 0),
                      .slopes = std::vector<Vec3>(around.objects.size(), Vec3::Zero()),
                      .trust = ofNodes.trust};
    for (std::size_t i = 0; i < fit.objectsAmong(nodes.count); ++i) {
        shape.values[fit.objectOf(i)] = ofNodes.values[i];
        shape.slopes[fit.objectOf(i)] = ofNodes.slopes[i];
    }
    return shape;
}

} // namespace knead
