#pragma once

#include "core/mechanics/contact_batch.h"
#include "core/mechanics/contact_body.h"
#include "core/mechanics/contact_crowd.h"
#include "core/mechanics/contact_report.h"
#include "core/mechanics/point_spread.h"

#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// Contacts of bodies with rigid surfaces: tools and the floor, whose forms are exact.
///
/// What touches are points of the skin (Aggregate::skin), each for its share of the area, carried by the objects of its cell. So
/// contact begins where the skin is, flat faces are flat, and a surface without friction pushes along its normal only. The spring
/// of a point stiffens (ContactParameters), by as much as keeps it from going in by a tenth of a spacing at pressures
/// of many times the modulus; where springs alone bear a body, which collapse under half of Young's modulus, it does not.
/// Objects below the skin keep sharp tools from slipping in between its points.
///
/// A tool that is put into material begins without force: each point keeps how deep it is, and that goes back to nothing at a
/// hundredth of the speed of sound, which pushes the material out without a blow.
class SurfaceContacts {
public:
    explicit SurfaceContacts(std::span<const ContactBody> bodies);

    /// A point that touched a surface, which the next step depends on.
    struct Touch {
        std::uint32_t surface = 0; ///< RigidSurface::id
        std::uint32_t body = 0;
        std::uint32_t point = 0; ///< of the body, see pointCount()
        FrictionMemory friction; ///< in the frame of the surface
        double kept = 0;         ///< how deep it may still be [m]
        double pressed = 0;      ///< force of its spring in the last step, while something is kept [N]
        std::int8_t side = 0;    ///< of a knife that cuts its material: 1, -1; 0: none does
    };
    /// By one thread at a time: it lets friction that is remembered in columns go back to the points first.
    std::vector<Touch> memory() const;
    void restore(std::vector<Touch> touches) { m_remembered = std::move(touches); }

    /// Numbers that points of a body may have: those of its skin, those of its objects, those of objects at broken connections.
    static std::size_t pointCount(const Aggregate& aggregate) { return aggregate.skin.size() + 2 * aggregate.size(); }

    /// Takes over changed materials and masses. @param frequency see Contacts::updateParameters()
    void updateParameters(std::span<const ContactBody> bodies, double frequency, bool isImplicit);

    /// In the springs of all points that are listed, as they are now [J].
    double energy(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces) const;

    /// In which a shear wave crosses a body, for ContactParameters::frictionDelay: 4 V / A over its speed; 0 where the body keeps
    /// its shape [s].
    double crossingTime(const ContactBody& body, std::uint32_t index, const Material& material) const;

    /// Cells whose objects are not connected any more have no skin; the ends touch in its place.
    /// @param surfaces that it may touch now @return energy of the contacts that end with it [J]
    double connectionsBroke(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces,
                            std::uint32_t body, std::size_t firstBroken);

    /// Finds what may touch before anything has gone further than the margin [m]. What else is listed changes no forces; what friction
    /// remembers of a point is forgotten by the first list that finds it far away.
    void list(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces, double margin);

    /// Before an implicit step: from which side points can come into the surfaces within it. A long step may bring them so far in
    /// that another side is nearer, where they would stay.
    /// @param surfaces as they are at the end of the step @pre list() of these
    void beginStep(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces, double duration);

    /// Points that are in a surface now keep their depth. @pre list() of these surfaces
    void keepInside(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces);

    /// Adds forces to the states of the bodies, and what they do to the report.
    void computeForces(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces,
                       const ContactStep& step, ContactCrowd& crowd, ContactReport& report);

    /// Springs only, of all points that reach into a surface, less what they keep. @param forces per body and object [N]
    void addPressing(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces,
                     std::vector<std::vector<Vec3>>& forces) const;

    /// How far the skin of a body is in a surface [m]; negative: not at all. On all threads; same bits for any number.
    double deepest(const ContactBody& body, std::uint32_t index, const RigidSurface& surface) const;

    /// Whether material is being pushed out of a surface that was put there.
    bool isWaiting() const;

private:
    struct Point {
        std::uint32_t body = 0;
        std::uint32_t number = 0;
        PointSpread spread;
        double area = 0;          ///< [m^2]
        double reach = 0;         ///< it touches so far from its place [m]
        double adhesionReach = 0; ///< see ContactParameters [m]
        double pushSpeed = 0;     ///< at which it comes out of a tool that was put there [m/s]
        bool isSkin = false;
        bool isActive = true;
        bool isLoose = false; ///< end of a broken connection
        bool isNew = false;   ///< and keeps how deep it is; such are last
        ContactParameters parameters;
    };
    struct Near {
        std::uint32_t point; ///< into m_points
        FrictionMemory friction;
        double kept = 0;
        double pressed = 0;
        bool isHeld = false;        ///< keeps it, since it does not come out
        Vec3 foot = Vec3::Zero();   ///< of the surface, nearest to the point when the step began, in its frame [m]
        Vec3 normal = Vec3::Zero(); ///< there; 0 where that is not known
        std::int8_t side = 0;       ///< of a knife that cuts its material: 1, -1; 0: none does
    };

    static ContactParameters parametersOf(const Point& point, const RigidSurface& surface);
    static SurfacePoint nearest(const Near& near, const PlacedSurface& surface, const Vec3& place);
    static bool waitsForEdge(Near& near, const Point& point, const PlacedSurface& surface, const Vec3& place);
    static std::int8_t sideOf(const Point& point, const ContactBody& body, const RigidSurface& surface);
    void addPoints(const ContactBody& body, std::uint32_t index);
    void addPoint(const Point& point) { m_points.push_back(point); }
    void press(const ContactBody& body, Near& near, const PlacedSurface& surface, std::uint32_t index,
               const ContactStep& step, ContactCrowd& crowd, ContactReport& report);
    double energyOf(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces,
                    const std::vector<std::uint8_t>& ofPoint) const;
    bool isPlain(const Near& near, const RigidSurface& surface) const;
    void forgetSorting();
    void sortOut(std::span<const ContactBody> bodies, std::uint32_t index, const RigidSurface& surface);
    double letOut(Near& near, const Point& point, double overlap, double spacing, const ContactStep& step) const;

    /// The points near a surface in explicit steps.
    struct Sorted {
        bool isCurrent = false;
        double friction = 0; ///< of the surface that it is for
        double adhesion = 0;
        ContactBatch batch;
        std::vector<std::uint32_t> others; ///< that are pressed one after the other, into m_near
    };

    std::vector<double> m_widths;          ///< of bodies, 4 V / A [m]
    std::vector<Point> m_points;           ///< of all bodies, body after body, then the ends of broken connections
    std::vector<std::vector<Near>> m_near; ///< per surface
    std::vector<Sorted> m_sorted;          ///< the same
    std::vector<std::uint32_t> m_listed;   ///< ids of those surfaces
    std::vector<Touch> m_remembered;       ///< of a moment, for the next list
    bool m_isImplicit = false;             ///< whether a step may go far
};

} // namespace knead
