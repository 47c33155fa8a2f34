#include "ui/deforming/number_form.h"

#include "core/deformation/number_map.h"
#include "core/session/end_grips.h"
#include "ui/language/said.h"
#include "ui/units.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knead {

namespace {

struct Deforming {
    Q_DECLARE_TR_FUNCTIONS(Deforming)
};

constexpr double firstAngle = std::numbers::pi / 4;
constexpr double firstShift = 0.2;    // of the length between the planes
constexpr double leastLength = 1e-6;  // between the planes, of the size of the parts
constexpr double leastMargin = 1.001; // by which a bend must be wider than folds are

int longestSide(const Box& box)
{
    Eigen::Index side = 0;
    box.sizes().maxCoeff(&side);
    return static_cast<int>(side);
}

} // namespace

NumberAxes axesOf(const NumberForm& form, const NumberSubject& subject)
{
    static const std::array<NumberAxes, 3> world{NumberAxes{Vec3::UnitX(), {Vec3::UnitZ(), Vec3::UnitY()}},
                                                 NumberAxes{Vec3::UnitY(), {Vec3::UnitZ(), Vec3::UnitX()}},
                                                 NumberAxes{Vec3::UnitZ(), {Vec3::UnitX(), Vec3::UnitY()}}};
    if (form.along == NumberForm::Along::face && subject.faceNormal) {
        const Vec3 axis = subject.faceNormal->normalized();
        Eigen::Index least = 0;
        axis.cwiseAbs().minCoeff(&least);
        const Vec3 second = axis.cross(Vec3::Unit(least)).normalized();
        return {axis, {second.cross(axis).normalized(), second}};
    }
    const bool isOfBox = form.along == NumberForm::Along::longest || form.along == NumberForm::Along::face;
    return world[static_cast<std::size_t>(isOfBox ? longestSide(subject.box) : static_cast<int>(form.along))];
}

std::pair<double, double> reachOf(const Box& box, const Vec3& direction)
{
    const double middle = direction.dot(box.center());
    const double half = direction.cwiseAbs().dot(box.sizes()) / 2;
    return {middle - half, middle + half};
}

void takeReach(NumberForm& form, const NumberSubject& subject)
{
    std::tie(form.from, form.to) = reachOf(subject.box, axesOf(form, subject).axis);
    form.shift = firstShift * (form.to - form.from);
}

NumberForm newForm(NumberKind kind, const NumberSubject& subject)
{
    NumberForm form;
    form.kind = kind;
    form.angle = firstAngle;
    takeReach(form, subject);
    return form;
}

namespace {

/// But for its neutral plane.
NumberDeformation bareDeformation(const NumberForm& form, const NumberSubject& subject)
{
    const NumberAxes axes = axesOf(form, subject);
    NumberDeformation deformation;
    deformation.kind = form.kind;
    deformation.axis = axes.axis;
    deformation.side = axes.sides[form.isOtherSide ? 1 : 0];
    const Vec3 center = subject.box.center();
    deformation.origin = center - axes.axis.dot(center) * axes.axis;
    deformation.from = form.from;
    deformation.to = form.to;
    deformation.angle = form.angle;
    deformation.factor = form.factor;
    deformation.shift = form.shift;
    deformation.stays = form.stays;
    deformation.eases = form.eases && !form.isByPhysics;
    return deformation;
}

} // namespace

NumberDeformation deformationOf(const NumberForm& form, const NumberSubject& subject)
{
    NumberDeformation deformation = bareDeformation(form, subject);
    deformation.neutral = neutralOfSheet(deformation, subject.heights, form.neutral);
    return deformation;
}

PhysicalDeformation physicalDeformationOf(const NumberForm& form, const NumberSubject& subject)
{
    return {.numbers = deformationOf(form, subject), .duration = form.duration, .letsGo = form.letsGo};
}

void takeHeights(NumberSubject& subject, const NumberForm& form, const TriangleMesh& surface)
{
    const NumberDeformation deformation = bareDeformation(form, subject);
    subject.heights = heightsBetweenPlanes(deformation, surface);
    if (!subject.heights.isEmpty())
        return;
    const auto [low, high] = reachOf(subject.box, deformation.side); // nothing lies between them
    const double origin = deformation.side.dot(deformation.origin);
    subject.heights = {low - origin, high - origin};
}

double neutralPlace(const NumberForm& form, const NumberSubject& subject)
{
    const NumberDeformation deformation = deformationOf(form, subject);
    return deformation.neutral + deformation.side.dot(deformation.origin);
}

double neutralShare(const NumberForm& form, const NumberSubject& subject, double place)
{
    const NumberDeformation deformation = bareDeformation(form, subject);
    const double inner = neutralOfSheet(deformation, subject.heights, 0);
    const double outer = neutralOfSheet(deformation, subject.heights, 1);
    const double height = place - deformation.side.dot(deformation.origin);
    return outer == inner ? 0.5 : (height - inner) / (outer - inner);
}

double radiusOfLine(const NumberForm& form)
{
    return (form.to - form.from) / std::abs(form.angle);
}

std::optional<Message> whyNot(const NumberForm& form, const NumberSubject& subject)
{
    if (form.to - form.from < leastLength * subject.box.diagonal().norm())
        return Message("Deforming", "The second plane must lie behind the first one, along the axis.");
    if (form.along == NumberForm::Along::face && !subject.faceNormal)
        return Message("Deforming", "Select a flat face first, whose normal is to be the axis.");
    if (const Message why = whyNotByPhysics(form.kind); form.isByPhysics && !why.empty())
        return why;
    const NumberDeformation deformation = deformationOf(form, subject);
    try {
        numberMap(deformation);
    } catch (const Problem& problem) {
        return problem.message();
    }
    if (form.kind != NumberKind::bend || form.angle == 0)
        return {};
    const double tightest = radiusOf(deformation); // where it eases, less than that of the whole line
    const double least = leastMargin * smallestRadius(deformation, subject.heights);
    if (tightest > least)
        return {};
    const double leastOfLine = least * radiusOfLine(form) / tightest;
    return Message("Deforming", "The bend is tighter than the material allows, which would fold: at least a radius of "
                                "%1, or at most %2 between these planes.")
        .with(formatReading(leastOfLine, Quantity::Length).toStdString(),
              formatReading(deformation.length() / leastOfLine, Quantity::Angle).toStdString());
}

namespace {

Message exactNameOf(const NumberForm& form)
{
    const auto said = [](double value, Quantity quantity) { return formatQuantity(value, quantity).toStdString(); };
    switch (form.kind) {
    case NumberKind::bend:
        return Message("Deforming", "Bent by %1").with(said(form.angle, Quantity::Angle));
    case NumberKind::twist:
        return Message("Deforming", "Twisted by %1").with(said(form.angle, Quantity::Angle));
    case NumberKind::taper:
        return Message("Deforming", "Tapered to %1").with(numberMessage(form.factor));
    case NumberKind::stretch:
        return Message("Deforming", "Stretched to %1").with(numberMessage(form.factor));
    case NumberKind::shear:
        return Message("Deforming", "Sheared by %1").with(said(form.shift, Quantity::Length));
    case NumberKind::scale:
        break;
    }
    return Message("Deforming", "Scaled to %1").with(numberMessage(form.factor));
}

} // namespace

Message nameOf(const NumberForm& form)
{
    const Message exact = exactNameOf(form);
    return form.isByPhysics ? Message("Deforming", "%1 by physics").with(exact) : exact;
}

QString verbOf(NumberKind kind)
{
    switch (kind) {
    case NumberKind::bend:
        return Deforming::tr("Bending");
    case NumberKind::twist:
        return Deforming::tr("Twisting");
    case NumberKind::taper:
        return Deforming::tr("Tapering");
    case NumberKind::stretch:
        return Deforming::tr("Stretching");
    case NumberKind::shear:
        return Deforming::tr("Shearing");
    case NumberKind::scale:
        break;
    }
    return Deforming::tr("Scaling");
}

std::span<const NumberKindLook> numberKindLooks()
{
    static constexpr NumberKindLook looks[] = {
        {NumberKind::bend, "Bend", QT_TRANSLATE_NOOP("Actions", "Bend..."), "deform-bend",
         QT_TRANSLATE_NOOP("Actions", "Bend the part into an arc by an angle or a radius")},
        {NumberKind::twist, "Twist", QT_TRANSLATE_NOOP("Actions", "Twist..."), "deform-twist",
         QT_TRANSLATE_NOOP("Actions", "Twist the part about an axis by an angle")},
        {NumberKind::taper, "Taper", QT_TRANSLATE_NOOP("Actions", "Taper..."), "deform-taper",
         QT_TRANSLATE_NOOP("Actions", "Make the part thicker or thinner toward one end")},
        {NumberKind::stretch, "Stretch", QT_TRANSLATE_NOOP("Actions", "Stretch..."), "deform-stretch",
         QT_TRANSLATE_NOOP("Actions", "Make the part longer or shorter between two planes")},
        {NumberKind::shear, "Shear", QT_TRANSLATE_NOOP("Actions", "Shear..."), "deform-shear",
         QT_TRANSLATE_NOOP("Actions", "Move one end of the part sideways")},
        {NumberKind::scale, "Scale", QT_TRANSLATE_NOOP("Actions", "Scale between planes..."), "deform-scale",
         QT_TRANSLATE_NOOP("Actions", "Make one end of the part larger or smaller in all directions")},
    };
    return looks;
}

} // namespace knead
