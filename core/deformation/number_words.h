#pragma once

#include "core/deformation/number_deformation.h"
#include "core/message/message.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace knead {

/// A number that says how much a NumberDeformation does, as a person types it.
struct NumberParameter {
    enum class Unit : std::uint8_t { degrees, millimeters, none };

    const char* key; ///< in recipes and on the command line, with its unit: "angle_deg"
    Message name;    ///< as it is shown: "Angle"
    double NumberDeformation::*value;
    Unit unit = Unit::none;
    double least = 0; ///< as typed
    double most = 0;  ///< as typed

    double typed(const NumberDeformation& deformation) const;           ///< in degrees or mm
    void set(NumberDeformation& deformation, double typedNumber) const; ///< of degrees or mm
};

/// Something that is done by numbers, in words.
struct NumberKindWords {
    NumberKind kind;
    const char* word;                            ///< in recipes and on the command line
    Message name;                                ///< as it is shown
    std::span<const NumberParameter> parameters; ///< what says how much; the first one is what a person turns up first
    bool hasSide = false;                        ///< whether it goes toward a side
};

/// All that can be done by numbers, in the order of menus.
std::span<const NumberKindWords> numberKindWords();

const NumberKindWords& wordsOf(NumberKind kind);

/// The kind that is called so.
std::optional<NumberKind> numberKindOf(std::string_view word);

} // namespace knead
