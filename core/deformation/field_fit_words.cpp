#include "core/deformation/field_fit_words.h"

#include "core/message/number_text.h"
#include "core/model/length_units.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double mostUncovered = 0.5;   // of the surface: more, and the field is of something else
constexpr double someUncovered = 0.005; // worth a remark
constexpr double sameSize = 0.2;        // by which lengths of boxes of the same thing differ at most
constexpr double shiftedBy = 0.1;       // of the size, by which their middles are apart
constexpr double roughShare = 0.002;    // of the nodes

std::string fieldMillimetres(double metres)
{
    return inDigits(1e3 * metres, 4);
}

std::string fieldPercent(double share)
{
    return inDigits(100 * share, 3);
}

/// "at (1, 2, 3) mm" or "on face 4, at (1, 2, 3) mm"; faces count from 0, as everywhere.
Message where(const PlaceOnParts& at)
{
    if (!at.face)
        return Message("Field", "at %1").with(placeInMillimetres(at.place));
    return Message("Field", "on face %1, at %2").with(*at.face, placeInMillimetres(at.place));
}

std::string sizesText(const Box& box)
{
    const Vec3 size = box.sizes();
    return fieldMillimetres(size.x()) + " x " + fieldMillimetres(size.y()) + " x " + fieldMillimetres(size.z());
}

bool isAbout(double one, double other)
{
    return std::abs(one - other) <= sameSize * std::max(std::abs(one), std::abs(other));
}

bool areAbout(const Vec3& one, const Vec3& other)
{
    const double slack = sameSize * std::max(one.maxCoeff(), other.maxCoeff());
    return ((one - other).array().abs() <= slack).all();
}

/// The unit in which the numbers of the field would have the size of the parts; none when it is the one that was taken, or none does.
const LengthUnit* likelyUnit(const FieldFit& fit, const std::string& unit)
{
    const LengthUnit* taken = findLengthUnit(unit.empty() ? "mm" : unit);
    const double nodes = fit.nodes.diagonal().norm();
    const double parts = fit.parts.diagonal().norm();
    if (taken == nullptr || !(nodes > 0) || isAbout(nodes, parts))
        return nullptr;
    const auto units = lengthUnits();
    const auto found = std::ranges::find_if(
        units, [&](const LengthUnit& other) { return isAbout(nodes * other.metres / taken->metres, parts); });
    return found == units.end() ? nullptr : &*found;
}

Vec3 ascending(Vec3 sizes)
{
    std::sort(sizes.begin(), sizes.end());
    return sizes;
}

/// A field of numbers that are too large is everywhere near the parts.
bool isInAnotherUnit(const FieldFit& fit, const std::string& unit)
{
    const double factor = fit.parts.diagonal().norm() / fit.nodes.diagonal().norm();
    return likelyUnit(fit, unit) != nullptr && areAbout(factor * fit.nodes.sizes(), fit.parts.sizes());
}

/// Why so much of the surface has no nodes near it.
Message mismatchOf(const FieldFit& fit, const std::string& unit)
{
    if (const LengthUnit* likely = likelyUnit(fit, unit))
        return Message("Field", "The nodes of the field span %1 mm, the parts %2 mm: the numbers seem to be %3. Choose "
                                "\"%4\" as the unit of the field.")
            .with(sizesText(fit.nodes), sizesText(fit.parts), likely->plural, likely->name);
    const Vec3 apart = fit.parts.center() - fit.nodes.center();
    if (areAbout(fit.nodes.sizes(), fit.parts.sizes()) && apart.norm() > shiftedBy * fit.parts.diagonal().norm())
        return Message("Field", "The field has the size of the parts, but lies elsewhere: its middle is at %1, theirs "
                                "at %2. Move the parts there, or write the field where they are.")
            .with(placeInMillimetres(fit.nodes.center()), placeInMillimetres(fit.parts.center()));
    if (!areAbout(fit.nodes.sizes(), fit.parts.sizes()) &&
        areAbout(ascending(fit.nodes.sizes()), ascending(fit.parts.sizes())))
        return Message("Field", "The field has the size of the parts, but is turned: it spans %1 mm, they span %2 mm. "
                                "Turn the parts, or write the field with the axes that they have.")
            .with(sizesText(fit.nodes), sizesText(fit.parts));
    return Message("Field", "The field is not of these parts: %1 % of their surface lies far from all of its nodes, at "
                            "most %2 mm (%3). The field spans %4 mm, the parts %5 mm.")
        .with(fieldPercent(fit.uncovered), fieldMillimetres(fit.farthest.value), where(fit.farthest),
              sizesText(fit.nodes), sizesText(fit.parts));
}

} // namespace

Message placeInMillimetres(const Vec3& place)
{
    return Message::verbatim("(%1, %2, %3) mm")
        .with(fieldMillimetres(place.x()), fieldMillimetres(place.y()), fieldMillimetres(place.z()));
}

void sayHowItFits(FieldFit& fit, const std::string& unit)
{
    if (fit.uncovered > mostUncovered || isInAnotherUnit(fit, unit))
        fit.mismatch = mismatchOf(fit, unit);
    else if (fit.uncovered > someUncovered)
        fit.remarks.push_back(
            Message("Field", "%1 % of the surface has no nodes of the field near it; there the field is continued. "
                             "The farthest place lies %2 mm from a node, %3.")
                .with(fieldPercent(fit.uncovered), fieldMillimetres(fit.farthest.value), where(fit.farthest)));
    if (fit.folds())
        fit.remarks.push_back(
            Message("Field", "The field folds the material %1: its volume there would be %2 times what it was. Take a "
                             "smaller factor, or keep faces there as they are.")
                .with(where(fit.determinant), inDigits(fit.determinant.value, 3)));
    if (fit.roughness > roughShare)
        fit.remarks.push_back(
            Message("Field", "%1 % of the nodes move otherwise than those beside them, most at %2, by %3 mm: two sides "
                             "of a slit, or noise. A smooth field passes between them.")
                .with(fieldPercent(fit.roughness), placeInMillimetres(fit.roughest.place),
                      fieldMillimetres(fit.roughest.value)));
}

} // namespace knead
