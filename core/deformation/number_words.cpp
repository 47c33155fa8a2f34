#include "core/deformation/number_words.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace knead {

namespace {

using Unit = NumberParameter::Unit;

constexpr double degreesPerRadian = 180 / std::numbers::pi;
constexpr double mostTurned = 3600;  // [degrees]
constexpr double leastFactor = 1e-3; // what is thinner than that is nothing any more
constexpr double mostFactor = 1e3;
constexpr double mostMillimeters = 1e6; // a kilometer is no workbench

double unitOf(const NumberParameter& parameter)
{
    switch (parameter.unit) {
    case Unit::degrees:
        return degreesPerRadian;
    case Unit::millimeters:
        return 1e3;
    case Unit::none:
        break;
    }
    return 1;
}

} // namespace

double NumberParameter::typed(const NumberDeformation& deformation) const
{
    return deformation.*value * unitOf(*this);
}

void NumberParameter::set(NumberDeformation& deformation, double typedNumber) const
{
    deformation.*value = typedNumber / unitOf(*this);
}

std::span<const NumberKindWords> numberKindWords()
{
    static const NumberParameter angle{
        "angle_deg", Message("Deformation", "Angle"), &NumberDeformation::angle, Unit::degrees, -mostTurned,
        mostTurned};
    static const NumberParameter factor{
        "factor", Message("Deformation", "Factor"), &NumberDeformation::factor, Unit::none, leastFactor, mostFactor};
    static const std::array bend{angle, NumberParameter{"neutral_mm", Message("Deformation", "Neutral plane"),
                                                        &NumberDeformation::neutral, Unit::millimeters,
                                                        -mostMillimeters, mostMillimeters}};
    static const std::array twist{angle};
    static const std::array grow{factor};
    static const std::array shear{NumberParameter{"shift_mm", Message("Deformation", "Shift"),
                                                  &NumberDeformation::shift, Unit::millimeters, -mostMillimeters,
                                                  mostMillimeters}};
    static const std::array<NumberKindWords, 6> words{{
        {NumberKind::bend, "bend", Message("Deformation", "Bend"), bend, true},
        {NumberKind::twist, "twist", Message("Deformation", "Twist"), twist},
        {NumberKind::taper, "taper", Message("Deformation", "Taper"), grow},
        {NumberKind::stretch, "stretch", Message("Deformation", "Stretch"), grow},
        {NumberKind::shear, "shear", Message("Deformation", "Shear"), shear, true},
        {NumberKind::scale, "scale", Message("Deformation", "Scale"), grow},
    }};
    return words;
}

const NumberKindWords& wordsOf(NumberKind kind)
{
    return *std::ranges::find(numberKindWords(), kind, &NumberKindWords::kind);
}

std::optional<NumberKind> numberKindOf(std::string_view word)
{
    const auto words = numberKindWords();
    const auto found = std::ranges::find(words, word, &NumberKindWords::word);
    return found == words.end() ? std::nullopt : std::optional(found->kind);
}

} // namespace knead
