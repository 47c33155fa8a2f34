#pragma once

#include "core/kernels/kernels.h"
#include "core/mechanics/contact_body.h"
#include "core/mechanics/contact_crowd.h"
#include "core/mechanics/contact_report.h"
#include "core/mechanics/point_spread.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// Points that may touch one surface in explicit steps, side by side in columns: the law is worked out for eight of them at a time
/// (contact_kernels.h), and what they do to objects that many of them share is added up before it goes to the bodies.
///
/// For points of which nothing is special: no adhesion, nothing kept, no knife. What comes out is what contactForce() says of each.
/// Of what touches, the order of points alone decides in which order it is added up: what else is listed changes no bits.
class ContactBatch {
public:
    struct Point {
        std::uint32_t body = 0;
        const PointSpread* spread = nullptr;
        double reach = 0;                   ///< it touches so far from its place [m]
        ContactParameters parameters;       ///< of both ends
        FrictionMemory* friction = nullptr; ///< in the frame of the surface, see writeBack(); has to stay in place
    };

    ContactBatch() = default;
    /// @param points those of the same carriers one after the other; their spreads have to stay in place
    /// @param run what works them out; the instruction set changes no bits
    ContactBatch(std::span<const ContactBody> bodies, std::span<const Point> points,
                 const kernels::Kernels& run = kernels::best());

    /// Whether points near a surface that do not touch it cost next to nothing: its distance is a formula, it does not cut, and
    /// nothing sticks to it.
    static bool takesLittle(const RigidSurface& surface);

    /// What friction remembers is here from the first step on, and goes back to the points with this.
    void writeBack() const;

    /// Adds forces to the states of the bodies, what they do to the surface to its load, and all else to the report.
    /// @param step explicit
    void press(std::span<const ContactBody> bodies, const PlacedSurface& surface, const ContactStep& step,
               ContactCrowd& crowd, SurfaceLoad& load, ContactReport& report);

private:
    static constexpr std::size_t blockSize = 128; ///< of points, unless more are carried by the same objects

    /// Points and groups that are worked out together.
    struct Stretch {
        std::size_t firstPoint = 0;
        std::size_t pointCount = 0;
        std::size_t firstColumn = 0; ///< of its points in the columns of all, where whole vectors of lanes are its own
        std::size_t firstGroup = 0;
        std::size_t groupCount = 0;
    };

    /// Columns of the points of a stretch, which stay in the innermost cache.
    struct Block {
        Block() = default;
        explicit Block(std::size_t count);
        std::array<LaneVector<double>, 3> place, velocity, normal;
        LaneVector<double> distance, overlap;
        LaneVector<double> effects; ///< kernels::effectSize per point
    };

    void keepPressures(const ContactStep& step);
    void readMotions(std::span<const ContactBody> bodies);
    std::size_t addGroup(std::size_t first, const std::vector<std::vector<std::uint32_t>>& numbers);
    std::size_t columnCount() const;
    template <typename With>
    void forEachPoint(const With& with) const;
    void fillColumns();
    void pressBlock(const Stretch& stretch, const PlacedSurface& surface,
                    const std::optional<kernels::PlacedForm>& form, const ContactStep& step, ContactReport& report);
    void giveToObjects(std::span<const ContactBody> bodies, const RigidSurface& surface, ContactCrowd& crowd,
                       SurfaceLoad& load, ContactReport& report);

    std::vector<Point> m_points;
    std::vector<ObjectRef> m_objects;          ///< that carry them, sorted
    std::vector<kernels::PointGroup> m_groups; ///< of points; their numbers begin anew in each block
    std::vector<double> m_weights;             ///< of all points
    std::vector<Stretch> m_stretches;          ///< blocks
    LaneVector<double> m_motions;              ///< kernels::motionSize per object
    LaneVector<double> m_effects;              ///< kernels::effectSize per object, 0 between steps
    double m_duration = 0;                     ///< that m_kept is for [s]

    // Columns of all points, see Stretch.
    LaneVector<double> m_weightSum; ///< of |w|
    LaneVector<double> m_stiffness, m_damping, m_friction, m_inverseStiffening, m_steepest, m_mass, m_largestOverlap;
    LaneVector<double> m_reach, m_kept, m_keptApart;
    std::array<LaneVector<double>, 3> m_hold;
    LaneVector<double> m_pressure;

    const kernels::Kernels* m_run = nullptr;
    Block m_block;
};

} // namespace knead
