#pragma once

#include "core/deformation/end_motion.h"
#include "core/deformation/physical_deformation.h"
#include "core/message/message.h"
#include "core/simulation/command.h"
#include "core/simulation/snapshot.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// Why grips cannot do what a kind does; empty: they can.
Message whyNotByPhysics(NumberKind kind);

/// Among other fixtures.
std::string nameOfGrip(const PhysicalDeformation& deformation, NumberEnd end);

/// Of which end it lets go: the one that has moved more.
NumberEnd freedEnd(const NumberDeformation& numbers);

/// What grips hold of a body: ascending.
struct HeldEnds {
    BodyId body = 0;
    std::vector<ObjectIndex> first;
    std::vector<ObjectIndex> second;
};

/// Objects beyond the planes; where a plane is at the end of a body, those within a spacing of it.
/// @param now of all bodies @param names of these, for sentences @param which of these; empty: all
/// @throws Problem, in a sentence: grips cannot do it, a fold, nothing between the planes or nothing beyond
std::vector<HeldEnds> heldEnds(const PhysicalDeformation& deformation, const Snapshot& now,
                               const std::vector<std::string>& names, const std::vector<bool>& which = {});

/// The grips that hold them, one after the other, not moving yet.
std::vector<Command> addedGrips(const PhysicalDeformation& deformation, const std::vector<HeldEnds>& held);

/// The motion of the grips in time. A value: whoever repeats steps from a copy of it tells the same.
///
/// The share of the way is s(t) = 3 u^2 - 2 u^3, u = t / duration. Grips are told velocities that bring them where they are to be a
/// horizon later, from where they are by then: so they end where the formula says, whatever the steps.
class EndGrips {
public:
    /// @param begin when the grips were added [s]
    EndGrips(const PhysicalDeformation& deformation, double begin);
    /// Where the formula has them at a time since then, moving as nobody knows.
    EndGrips(const PhysicalDeformation& deformation, double begin, double now);

    struct Move {
        Vec3 velocity = Vec3::Zero(); ///< [m/s]
        GripTurn turn = {};
        friend bool operator==(const Move& a, const Move& b)
        {
            return a.velocity == b.velocity && a.turn.angularVelocity == b.turn.angularVelocity;
        }
    };
    /// Per end what its grip is to do from now on; none: as before.
    using Moves = std::array<std::optional<Move>, 2>;

    static constexpr double leastHorizon = 1.0 / 60; ///< [s]

    /// @param time at which a step begins [s] @param step that comes, about [s]
    /// @param horizon for which they are told a way, not shorter than steps are [s]
    Moves follow(double time, double step, double horizon);

    bool isOver() const { return m_isOver; } ///< they stand still at the end of the way
    double shareAt(double time) const;       ///< of the way, 0 .. 1
    const EndPlace& placeOf(NumberEnd end) const { return m_ends[end == NumberEnd::first ? 0 : 1].now; }

private:
    struct End {
        EndPlace now;                      ///< by what was told
        std::optional<Move> told = Move{}; ///< none: not known
        double turning = 0;                ///< about the axis [rad/s]
    };

    void goOn(double time);
    bool isThere() const;
    std::optional<Move> moveTo(End& end, const EndPlace& target, double horizon) const;

    PhysicalDeformation m_deformation;
    double m_begin;
    double m_time;      ///< when they were where they are said to be [s]
    double m_toldUntil; ///< [s]
    std::array<End, 2> m_ends;
    bool m_isOver = false;
};

} // namespace knead
