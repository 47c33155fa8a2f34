#pragma once

#include "core/session/press_pose.h"
#include "core/session/pull_spring.h"
#include "core/simulation/command.h"
#include "core/simulation/snapshot.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// What a hand does to the material under the cursor. Settings of a person keep the number.
enum class SculptBrush : std::uint8_t {
    pull = 0,    ///< takes a patch of material along
    thumb = 1,   ///< a ball goes in along the normal and may be drawn along
    smooth = 2,  ///< a large ball that rolls levels what stands out
    flatten = 3, ///< a disc presses all down to the plane that the surface had at the first place
    pinch = 4,   ///< four fingers draw material together
    smear = 5,   ///< a ball with much friction takes the surface along
    bend = 6,    ///< tilts a patch towards where the hand goes, with a moment
    twist = 7    ///< turns a patch about its normal, with a moment
};
constexpr std::size_t sculptBrushCount = 8;

/// Whether it works with rigid fingers, which are there as long as the stroke; else it grips the material.
bool usesFingers(SculptBrush brush);
/// Whether a grip of it turns.
bool turnsPatch(SculptBrush brush);

/// Whether a tool or a fixture has a name that strokes give: "Finger 2", "Grip 1", "Other hand 1".
bool isNameOfStroke(const std::string& name);

/// How a hand works. SI.
struct SculptChoice {
    SculptBrush brush = SculptBrush::pull;
    double radius = 0.01;           ///< of what is taken or pressed [m], > 0
    double strength = 1;            ///< of the force that suits the material, > 0
    PullChoice pull;                ///< of the brush `pull`
    std::array<bool, 3> mirrored{}; ///< the same is done across the planes x, y, z
    Vec3 middle = Vec3::Zero();     ///< where these planes meet [m]
    bool holdsRest = true;          ///< as the other hand does, where no fixture holds the body
    double speed = 0.1;             ///< of fingers and patches at most [m/s], > 0
};

/// One stroke of a hand on a body: fingers or grips, and those across the planes of symmetry, as commands. So it is recorded,
/// undone and repeated as all else. Forces are forces on material: what they do goes by its laws, and ends at their limits.
///
///     begin -> (moveTo, follow with each snapshot) -> release -> (follow until isOver)
///
/// A grip goes where a spring between hand and patch is in balance with the material, see pullVelocity(); one that bends or twists
/// is free to go where no force is on it, and turns by the same law of moments. A finger goes to its place above the surface as it
/// was when the stroke began, until its force limit holds it.
class SculptStroke {
public:
    /// @param now of a simulation, whose names are not taken
    /// @param right of the hand, of length 1
    /// @param going name of a fixture that was told to go and is in the snapshot still; empty: none
    SculptStroke(const SculptChoice& choice, BodyId body, const Snapshot& now, const SurfaceSpot& spot,
                 const Vec3& right, const std::string& going = {});

    /// Before begin(): nothing can be taken there, all of it is held.
    bool isEmpty() const { return m_touches.empty(); }
    std::vector<Command> begin();

    /// The hand is above another place. @param hand on the plane through the first place that faces the eye [m]
    void moveTo(const Vec3& hand) { m_hand = hand; }
    /// The surface under the hand, as it was when the stroke began.
    void moveTo(const SurfaceSpot& spot) { m_spot = spot; }
    /// What is to be told for the hand to be followed. Call it with each snapshot.
    /// @param hasAll all that was told is in the snapshot
    std::vector<Command> follow(const Snapshot& now, bool hasAll);
    /// The hand opens: grips let go, fingers are lifted.
    std::vector<Command> release(const Snapshot& now, bool hasAll);
    bool isReleased() const { return m_isReleased; }
    /// All fingers have gone.
    bool isOver() const { return m_isReleased && m_touches.empty() && !m_hold; }
    /// What is still there goes at once.
    std::vector<Command> abandon(const Snapshot& now, bool hasAll);

    /// Another limit of force from the next snapshot on.
    void strengthen(double factor);

    double force(const Snapshot& now) const; ///< of the hand at the first place [N]
    bool isAtLimit(const Snapshot& now) const;
    /// That was taken first; of a finger what it is above, which lags behind the hand where its limits hold it [m].
    Vec3 placeNow(const Snapshot& now) const;
    /// Of the grip of the other hand; empty: none.
    std::string nameOfHold() const { return m_hold ? m_hold->name : std::string(); }
    const SurfaceSpot& spot() const { return m_spot; } ///< under the hand, as it was when the stroke began

private:
    /// A finger, or a grip.
    struct Touch {
        Vec3 mirror = Vec3::Ones();            ///< signs, of the first one
        Vec3 place = Vec3::Zero();             ///< taken, when it began [m]
        Vec3 aside = Vec3::Zero();             ///< from the place to the patch [m]
        std::string name = {};                 ///< by which the simulation has it
        std::vector<ObjectIndex> objects = {}; ///< of a grip; others after the body was filled anew
        Vec3 patch = Vec3::Zero();             ///< their middle when it began [m]
        Vec3 last = Vec3::Zero();              ///< the same in the snapshot before [m]
        PullSpring spring = {};
        Vec3 force = Vec3::Zero();          ///< of the material on the patch, smoothed [N]
        Vec3 moment = Vec3::Zero();         ///< the same about its middle [N m]
        Vec3 velocity = Vec3::Zero();       ///< as told [m/s]
        Vec3 turning = Vec3::Zero();        ///< as told [1/s]
        Vec3 turned = Vec3::Zero();         ///< so far [rad]
        Vec3 told = Vec3::Zero();           ///< where a finger was told to go [m]
        double limit = 0;                   ///< of a finger [N]
        double toldLimit = 0;               ///< the same, as told [N]
        std::optional<double> leaveBy = {}; ///< a lifted finger is taken away then, simulated [s]
        bool isGone = false;
    };

    void addTouches(const Snapshot& now);
    void addGrip(const Snapshot& now, const Vec3& mirror, const Vec3& place, const Vec3& aside, double radius,
                 std::vector<std::uint8_t>& isTaken);
    void addHold(const Snapshot& now);
    Vec3 mirrored(const Vec3& place, const Vec3& mirror) const;
    Manipulator finger() const;
    Pose poseOf(const Touch& touch, bool isAway) const;
    double height() const;
    const ToolState* toolOf(const Touch& touch, const Snapshot& now) const;
    static std::optional<std::size_t> fixtureOf(const std::string& name, const Snapshot& now);
    Vec3 middleNow(const Touch& touch, const Snapshot& now) const;
    Vec3 wantedStep(const Touch& touch, const Snapshot& now) const;
    void moveFinger(Touch& touch, const Snapshot& now, bool hasAll, std::vector<Command>& commands);
    void moveGrip(Touch& touch, const Snapshot& now, double dt, std::vector<Command>& commands);
    void letGo(const Snapshot& now, bool hasAll, std::vector<Command>& commands);

    SculptChoice m_choice;
    BodyId m_body;
    Material m_material;
    SurfaceSpot m_start;
    Vec3 m_right; ///< of the hand
    SurfaceSpot m_spot;
    Vec3 m_hand; ///< [m]
    std::vector<Touch> m_touches;
    std::string m_going;           ///< see the constructor
    std::optional<Fixture> m_hold; ///< of the other hand
    double m_time = 0;             ///< of the snapshot before [s]
    bool m_isReleased = false;
};

} // namespace knead
