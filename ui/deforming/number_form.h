#pragma once

#include "core/deformation/number_placement.h"
#include "core/deformation/physical_deformation.h"
#include "core/geometry/vec3.h"
#include "core/message/message.h"

#include <QString>

#include <array>
#include <optional>
#include <span>
#include <utility>

namespace knead {

/// What a person says of a deformation by numbers, as the panel shows it. A value: it knows no window.
struct NumberForm {
    enum class Along { x, y, z, longest, face };

    NumberKind kind = NumberKind::bend;
    Along along = Along::longest;
    bool isOtherSide = false; ///< bends or shears toward the second of the two directions across the axis
    double from = 0;          ///< the first plane, along the axis from the world's origin [m]
    double to = 1;            ///< the second one [m]
    double angle = 0;         ///< bend, twist [rad]
    double factor = 1.5;      ///< taper, stretch, scale
    double shift = 0;         ///< shear [m]
    double neutral = 0.5; ///< bend: where the length stays between the planes, 0 at the inner side, 1 at the outer one
    double stays = 0;     ///< 0 the first plane, 1 the second one
    bool eases = false;
    bool isByPhysics = false; ///< grips do it, and what lies between the planes finds its own shape
    double duration = 1;      ///< by physics: of the way of the grips [s]
    bool letsGo = false;      ///< by physics: one opens at the end
};

/// What the form is filled in for.
struct NumberSubject {
    Box box;                        ///< of the parts that are deformed, as they are now [m]
    std::optional<Vec3> faceNormal; ///< of the face that is selected, if one is
    HeightRange heights;            ///< of material between the planes, toward the side; see takeHeights()
};

/// Directions that a form means: the axis, and the two across it toward which it can bend or shear.
struct NumberAxes {
    Vec3 axis = Vec3::UnitX();
    std::array<Vec3, 2> sides{Vec3::UnitZ(), Vec3::UnitY()};
};
NumberAxes axesOf(const NumberForm& form, const NumberSubject& subject);

/// How far the box reaches along a direction from the world's origin [m].
std::pair<double, double> reachOf(const Box& box, const Vec3& direction);

/// Planes at the ends of the parts, and numbers that suit their size.
NumberForm newForm(NumberKind kind, const NumberSubject& subject);
/// The same form about another axis: planes at the ends of the parts.
void takeReach(NumberForm& form, const NumberSubject& subject);

NumberDeformation deformationOf(const NumberForm& form, const NumberSubject& subject);

/// The same as grips do it. @pre isByPhysics
PhysicalDeformation physicalDeformationOf(const NumberForm& form, const NumberSubject& subject);

/// After the form has other planes or directions. @param surface of the parts, as they are now
void takeHeights(NumberSubject& subject, const NumberForm& form, const TriangleMesh& surface);

/// The place that keeps its length, along the side from the world's origin [m], and back.
double neutralPlace(const NumberForm& form, const NumberSubject& subject);
double neutralShare(const NumberForm& form, const NumberSubject& subject, double place);

/// Why it cannot be done, in a sentence; nothing: it can.
std::optional<Message> whyNot(const NumberForm& form, const NumberSubject& subject);

/// Of the line that keeps its length [m]. @pre it bends
double radiusOfLine(const NumberForm& form);

/// "Bent by 90 deg": the entry of the history.
Message nameOf(const NumberForm& form);
/// "Bending": what is being done, before it is.
QString verbOf(NumberKind kind);

/// A kind as it is offered.
struct NumberKindLook {
    NumberKind kind;
    const char* name; ///< ends the name of its action
    const char* text; ///< to be translated in the context "Actions"
    const char* icon;
    const char* tip; ///< likewise
};
std::span<const NumberKindLook> numberKindLooks();

/// Whether the kind has a side to go toward.
inline bool hasSide(NumberKind kind)
{
    return kind == NumberKind::bend || kind == NumberKind::shear;
}
inline bool hasAngle(NumberKind kind)
{
    return kind == NumberKind::bend || kind == NumberKind::twist;
}
inline bool hasFactor(NumberKind kind)
{
    return kind == NumberKind::taper || kind == NumberKind::stretch || kind == NumberKind::scale;
}

} // namespace knead
