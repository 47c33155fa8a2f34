#include "core/aggregate/skin_balance.h"

#include "core/aggregate/cell_finder.h"
#include "core/aggregate/connection_pulls.h"
#include "core/aggregate/lattice_rows.h"
#include "core/aggregate/local_shape.h"
#include "core/aggregate/moment_blocks.h"
#include "core/aggregate/skin_areas.h"
#include "core/aggregate/wall_measure.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace knead {

namespace {

// Of what is out of balance and of moments that change, against relative changes of weights.
constexpr double factor = 200;

constexpr int steps = 12;         // of conjugate gradients
constexpr double lightlyBy = 1.1; // light connections change less than in proportion: stable steps stay nearly as long
constexpr double balanced = 1e-4; // [a^2]: less is rounding, of single precision in files too
constexpr double leastFree = 2.5; // [cells]: thinner walls keep their weights
constexpr double allFree = 3.5;   // and thicker ones are balanced
constexpr double leastArea = 0.1; // [a^2]: less does not say which way is inwards
constexpr double leastWeight = 0.016; // as of moment_weights.cpp: springs must push back
constexpr std::size_t perTask = 4096; // connections or objects
constexpr std::uint32_t none = 0xffffffffU;

/// A connection that may change.
struct Unknown {
    std::uint64_t block; ///< that its middle is in, and its family: those of one are neighbors
    ObjectIndex lower;
    ObjectIndex upper;
    std::uint32_t family;

    friend bool operator<(const Unknown& a, const Unknown& b)
    {
        return a.block != b.block ? a.block < b.block : a.lower < b.lower;
    }
};

Vec3 middleOf(const Aggregate& aggregate, const Unknown& unknown)
{
    const Lattice::Node& a = aggregate.lattice.nodes[unknown.lower];
    const Lattice::Node& b = aggregate.lattice.nodes[unknown.upper];
    return 0.5 * Vec3(a[0] + b[0], a[1] + b[1], a[2] + b[2]);
}

/// What of a wall so thick is free to change.
double freedomAt(double thickness)
{
    const double s = std::clamp((thickness - leastFree) / (allFree - leastFree), 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

/// What of a pull moves an object in stress along a free skin: a part in proportion to the pull of the skin does not, however large.
Pull lackOf(const Pull& pull, const Pull& skin)
{
    return pull - pull.dot(skin) * skin;
}

/// Objects at corners of cells that the surface cuts. Elsewhere weights are in balance, but for what withFittedMoments() has wanted
/// to be otherwise.
std::vector<std::uint8_t> objectsAtCuts(const CutCells& cells, const Aggregate& aggregate)
{
    const LatticeRows rows(aggregate.lattice);
    std::vector<std::uint8_t> isAtCut(aggregate.size(), 0);
    for (std::size_t slab = 0; slab < cells.slabs.size(); ++slab)
        for (const CutCells::Cut& cut : cells.slabs[slab].cut)
            for (const Lattice::Node& corner : Lattice::cellCorners) {
                const Lattice::Node cell{static_cast<std::int32_t>(slab), cut.v, cut.w};
                if (const ObjectIndex object = rows.find(Lattice::sum(cell, corner)); object < isAtCut.size())
                    isAtCut[object] = 1;
            }
    return isAtCut;
}

/// The unknowns around what is out of balance, and the sums that are to be small.
class SkinBalance {
public:
    SkinBalance(const CutCells& cells, const Aggregate& aggregate, const std::vector<std::uint8_t>& isSurface,
                const TaskControl& control)
        : m_aggregate(aggregate)
        , m_blocks(aggregate.lattice)
        , m_pulls(pullsOfDirections())
    {
        {
            const std::vector<Vec3> areas = skinAreas(cells, aggregate, isSurface);
            control.throwIfCancelled();
            std::vector<std::uint8_t> isWanted = objectsAtCuts(cells, aggregate);
            for (std::size_t i = 0; i < areas.size(); ++i)
                if (isSurface[i] == 0 && !areas[i].isZero(0))
                    isWanted[i] = 1; // bears for a corner without an object
            findUnbalanced(areas, isWanted);
            findThickness(cells, areas);
        }
        control.throwIfCancelled();
        findUnknowns();
        control.throwIfCancelled();
        findGroups(cells);
        join();
    }

    bool isEmpty() const { return m_unknowns.empty(); }
    std::span<const Unknown> unknowns() const { return m_unknowns; }
    double scale(std::size_t k) const { return m_scale[k]; } ///< what an unknown of 1 changes a weight by

    /// Unknowns, by their scales.
    std::vector<double> solve(TaskControl& control) const
    {
        const std::size_t count = m_unknowns.size();
        const std::vector<double> inverse = inverseDiagonal();
        std::vector<double> x(count, 0);
        std::vector<double> r(count);
        std::vector<double> p(count);
        std::vector<double> change(count); // of weights, by p
        std::vector<double> Ap(count);
        std::vector<Pull> forces = m_unbalanced;
        double rz = sum(count, [&](std::size_t k) {
            r[k] = -factor * m_scale[k] * pull(k, forces);
            p[k] = inverse[k] * r[k];
            return r[k] * p[k];
        });
        for (int step = 0; step < steps && rz > 0; ++step) {
            control.throwIfCancelled();
            control.report(static_cast<double>(step) / steps, "fitting walls");
            forEachBlock(count, perTask, [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k)
                    change[k] = m_scale[k] * p[k];
            });
            multiplyMoments(change, Ap);
            findForces(change, forces);
            const double pAp = sum(count, [&](std::size_t k) {
                Ap[k] = p[k] + factor * m_scale[k] * (Ap[k] + pull(k, forces));
                return p[k] * Ap[k];
            });
            const double length = rz / pAp;
            const double next = sum(count, [&](std::size_t k) {
                x[k] += length * p[k];
                r[k] -= length * Ap[k];
                return inverse[k] * r[k] * r[k];
            });
            const double share = next / rz;
            rz = next;
            forEachBlock(count, perTask, [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k)
                    p[k] = inverse[k] * r[k] + share * p[k];
            });
        }
        return x;
    }

private:
    /// A group of unknowns, of one family and block.
    struct Group {
        std::size_t begin;
        std::size_t end;
    };

    /// Of an object: one of its connections.
    struct Side {
        std::uint32_t unknown;
        std::uint32_t pull; ///< of pullsOfDirections(): twice its family, one more at its upper end
    };

    /// T + sym(g) of the wanted objects that lack balance.
    void findUnbalanced(const std::vector<Vec3>& areas, const std::vector<std::uint8_t>& isWanted)
    {
        const auto count = static_cast<std::size_t>(std::ranges::count(isWanted, 1));
        m_rowOf.assign(areas.size(), none);
        m_unbalanced.reserve(count);
        m_skin.reserve(count);
        for (std::size_t i = 0; i < areas.size(); ++i)
            if (isWanted[i] != 0) {
                m_rowOf[i] = static_cast<std::uint32_t>(m_unbalanced.size());
                m_unbalanced.push_back(pullOfSkin(areas[i]));
                m_skin.push_back(m_unbalanced.back().stableNormalized());
            }
        m_aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex upper) {
            const double weight = m_aggregate.weight[d][lower];
            if (m_rowOf[lower] != none)
                m_unbalanced[m_rowOf[lower]] += weight * m_pulls[2 * d];
            if (m_rowOf[upper] != none)
                m_unbalanced[m_rowOf[upper]] += weight * m_pulls[2 * d + 1];
        });
        for (std::uint32_t& row : m_rowOf)
            if (row != none) {
                m_unbalanced[row] = lackOf(m_unbalanced[row], m_skin[row]);
                if (m_unbalanced[row].squaredNorm() <= balanced * balanced)
                    row = none;
            }
    }

    /// Of the material under objects of the skin.
    void findThickness(const CutCells& cells, const std::vector<Vec3>& areas)
    {
        const CellFinder finder(cells);
        const WallMeasure measure(finder);
        m_thickness.assign(m_unbalanced.size(), allFree);
        forEachBlock(areas.size(), perTask, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                if (m_rowOf[i] != none && areas[i].norm() > leastArea) {
                    const Lattice::Node& node = m_aggregate.lattice.nodes[i];
                    const Vec3 inwards = -areas[i].normalized();
                    // From within a cell, so that both sides of a symmetric part are measured alike.
                    m_thickness[m_rowOf[i]] =
                        measure.thickness(Vec3(node[0], node[1], node[2]) + 0.25 * inwards, inwards);
                }
        });
    }

    double thicknessAt(ObjectIndex object) const
    {
        return m_rowOf[object] != none ? m_thickness[m_rowOf[object]] : allFree;
    }

    void findUnknowns()
    {
        const auto visit = [&](auto&& add) {
            m_aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex upper) {
                if ((m_rowOf[lower] != none || m_rowOf[upper] != none) &&
                    std::min(thicknessAt(lower), thicknessAt(upper)) > leastFree)
                    add(Unknown{.block = 0, .lower = lower, .upper = upper, .family = d});
            });
        };
        std::size_t count = 0;
        visit([&](const Unknown&) { ++count; });
        m_unknowns.reserve(count);
        visit([&](const Unknown& unknown) {
            m_unknowns.push_back(unknown);
            m_unknowns.back().block = m_blocks.numberOf(middleOf(m_aggregate, unknown), unknown.family);
        });
        std::sort(m_unknowns.begin(), m_unknowns.end());
    }

    /// Leaves out what lies in thin walls.
    void findGroups(const CutCells& cells)
    {
        const CellFinder finder(cells);
        std::vector<Group> places; // all families of a block
        for (std::size_t k = 0; k < m_unknowns.size(); ++k) {
            if (k == 0 || !MomentBlocks::isSameBlock(m_unknowns[k].block, m_unknowns[k - 1].block))
                places.push_back({k, k});
            places.back().end = k + 1;
        }
        std::vector<double> freedom(places.size());
        forEachBlock(places.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                Vec3 middle = Vec3::Zero();
                for (std::size_t k = places[i].begin; k < places[i].end; ++k)
                    middle += middleOf(m_aggregate, m_unknowns[k]);
                middle /= static_cast<double>(places[i].end - places[i].begin);
                freedom[i] = freedomAt(localShapeAt(finder, middle).thickness());
            }
        });
        std::size_t kept = 0;
        m_scale.reserve(m_unknowns.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            for (std::size_t k = places[i].begin; k < places[i].end && freedom[i] > 0; ++k) {
                const Unknown unknown = m_unknowns[k];
                if (m_groups.empty() || unknown.block != m_unknowns[kept - 1].block)
                    m_groups.push_back({kept, kept});
                m_unknowns[kept++] = unknown;
                m_groups.back().end = kept;
                const double own = freedomAt(std::min(thicknessAt(unknown.lower), thicknessAt(unknown.upper)));
                m_scale.push_back(std::min(own, freedom[i]) *
                                  std::pow(m_aggregate.weight[unknown.family][unknown.lower], lightlyBy));
            }
        m_unknowns.resize(kept);
    }

    /// Objects and their unknowns.
    void join()
    {
        std::vector<std::uint32_t> counts(m_rowOf.size(), 0);
        for (const Unknown& unknown : m_unknowns) {
            ++counts[unknown.lower];
            ++counts[unknown.upper];
        }
        std::vector<Pull> unbalanced;
        std::vector<Pull> skin;
        std::vector<std::size_t> next;
        m_begin.push_back(0);
        for (std::size_t i = 0; i < counts.size(); ++i) {
            if (counts[i] == 0)
                continue;
            const std::uint32_t row = m_rowOf[i];
            unbalanced.push_back(row != none ? m_unbalanced[row] : Pull::Zero());
            skin.push_back(row != none ? m_skin[row] : Pull::Zero());
            m_rowOf[i] = static_cast<std::uint32_t>(next.size());
            next.push_back(m_begin.back());
            m_begin.push_back(m_begin.back() + counts[i]);
        }
        m_unbalanced = std::move(unbalanced);
        m_skin = std::move(skin);
        m_sides.resize(m_begin.back());
        m_rows.reserve(m_unknowns.size());
        m_places.reserve(m_unknowns.size());
        for (std::uint32_t k = 0; k < m_unknowns.size(); ++k) {
            const Unknown& unknown = m_unknowns[k];
            m_rows.push_back({m_rowOf[unknown.lower], m_rowOf[unknown.upper]});
            m_sides[next[m_rows[k][0]]++] = {k, 2 * unknown.family};
            m_sides[next[m_rows[k][1]]++] = {k, 2 * unknown.family + 1};
            m_places.push_back(m_blocks.halvesTo(middleOf(m_aggregate, unknown)));
        }
        m_rowOf = {};
    }

    /// Same bits on any number of threads.
    template <typename Term>
    static double sum(std::size_t count, const Term& term)
    {
        std::vector<double> parts((count + perTask - 1) / perTask, 0);
        forEachBlock(count, perTask, [&](std::size_t begin, std::size_t end) {
            double part = 0;
            for (std::size_t k = begin; k < end; ++k)
                part += term(k);
            parts[begin / perTask] = part;
        });
        return std::accumulate(parts.begin(), parts.end(), 0.0);
    }

    /// By what an unknown's ends lack.
    double pull(std::size_t k, const std::vector<Pull>& forces) const
    {
        return m_pulls[2 * m_unknowns[k].family].dot(forces[m_rows[k][0]] - forces[m_rows[k][1]]);
    }

    void findForces(const std::vector<double>& change, std::vector<Pull>& forces) const
    {
        forEachBlock(forces.size(), perTask / 8, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                Pull sum = Pull::Zero();
                for (std::size_t s = m_begin[i]; s < m_begin[i + 1]; ++s)
                    sum += change[m_sides[s].unknown] * m_pulls[m_sides[s].pull];
                forces[i] = lackOf(sum, m_skin[i]);
            }
        });
    }

    /// sum over m of p_m sum_b p_m d_b
    void multiplyMoments(const std::vector<double>& change, std::vector<double>& product) const
    {
        forEachBlock(m_groups.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t group = begin; group < end; ++group) {
                MomentBlocks::Polynomials moments = MomentBlocks::Polynomials::Zero();
                for (std::size_t k = m_groups[group].begin; k < m_groups[group].end; ++k)
                    moments += change[k] * MomentBlocks::polynomialsAt(m_places[k]);
                for (std::size_t k = m_groups[group].begin; k < m_groups[group].end; ++k)
                    product[k] = moments.dot(MomentBlocks::polynomialsAt(m_places[k]));
            }
        });
    }

    std::vector<double> inverseDiagonal() const
    {
        std::vector<double> inverse(m_unknowns.size());
        for (std::size_t k = 0; k < inverse.size(); ++k) {
            const double ofEnds = 2 * m_pulls[2 * m_unknowns[k].family].squaredNorm();
            const double ofMoments = MomentBlocks::polynomialsAt(m_places[k]).squaredNorm();
            inverse[k] = 1 / (1 + factor * m_scale[k] * m_scale[k] * (ofEnds + ofMoments));
        }
        return inverse;
    }

    const Aggregate& m_aggregate;
    MomentBlocks m_blocks;
    std::array<Pull, 2 * Lattice::isotropicCount> m_pulls;
    std::vector<Unknown> m_unknowns; ///< by blocks
    std::vector<double> m_scale;
    std::vector<MomentBlocks::Halves> m_places; ///< in their blocks
    std::vector<Group> m_groups;
    std::vector<std::array<std::uint32_t, 2>> m_rows; ///< of the ends of an unknown
    std::vector<std::uint32_t> m_rowOf;               ///< per object, or none; while they are found
    std::vector<Pull> m_unbalanced;                   ///< per row, at the start
    std::vector<Pull> m_skin;                         ///< per row, of the skin, of length 1 or 0
    std::vector<double> m_thickness;                  ///< as m_rowOf [cells]
    std::vector<std::size_t> m_begin;                 ///< per row, into m_sides
    std::vector<Side> m_sides;
};

/// New weights, none below the least but for the last digits, with the sums that families had. Volumes go with them.
void change(Aggregate& aggregate, const SkinBalance& balance, const std::vector<double>& x)
{
    const std::span<const Unknown> unknowns = balance.unknowns();
    std::vector<double> weights(x.size());
    std::array<double, Lattice::isotropicCount> more{};
    std::array<double, Lattice::isotropicCount> sums{};
    for (std::size_t k = 0; k < x.size(); ++k) {
        const double before = aggregate.weight[unknowns[k].family][unknowns[k].lower];
        weights[k] = std::max(before + balance.scale(k) * x[k], std::min(before, leastWeight));
        more[unknowns[k].family] += weights[k] - before;
        sums[unknowns[k].family] += weights[k];
    }
    const double volume = std::pow(aggregate.lattice.spacing, 3) / 18;
    for (std::size_t k = 0; k < x.size(); ++k) {
        const Unknown& unknown = unknowns[k];
        double& weight = aggregate.weight[unknown.family][unknown.lower];
        const double changed = weights[k] * (1 - more[unknown.family] / sums[unknown.family]);
        aggregate.volume[unknown.lower] += volume * (changed - weight);
        aggregate.volume[unknown.upper] += volume * (changed - weight);
        weight = changed;
    }
}

} // namespace

Aggregate withBalancedSkin(const CutCells& cells, Aggregate aggregate, const std::vector<std::uint8_t>& isSurface,
                           TaskControl& control)
{
    const SkinBalance balance(cells, aggregate, isSurface, control);
    control.throwIfCancelled();
    if (!balance.isEmpty())
        change(aggregate, balance, balance.solve(control));
    return aggregate;
}

} // namespace knead
