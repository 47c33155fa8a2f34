#include "io/document/unit_remark.h"

#include "core/message/message.h"
#include "core/model/length_units.h"
#include "io/formats/cad_format.h"

#include <array>
#include <cstdio>

namespace knead {

namespace {

struct Range {
    double least; ///< [m]
    double most;  ///< [m]
    bool holds(double length) const { return least <= length && length <= most; }
};

constexpr Range believedWhenStated{0.5e-3, 20};
constexpr Range believedWhenTaken{2e-3, 10};
constexpr Range likely{10e-3, 5};

double longestSide(const Model& model)
{
    Box box;
    for (const Part& part : model.parts)
        box.extend(part.box);
    return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

/// "0.12 mm", "122 mm", "38.9 m": three digits are enough to see what is meant.
std::string spoken(double length)
{
    const bool inMetres = length >= 10;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g %s", inMetres ? length : 1e3 * length, inMetres ? "m" : "mm");
    return text.data();
}

} // namespace

std::optional<UnitRemark> unitRemark(const Model& model)
{
    const double length = longestSide(model);
    const LengthUnit* taken = findLengthUnit(model.unit.empty() ? "mm" : model.unit);
    const Range& believed = model.unit.empty() ? believedWhenTaken : believedWhenStated;
    if (taken == nullptr || !(length > 0) || believed.holds(length))
        return std::nullopt;
    for (const LengthUnit& unit : lengthUnits()) {
        const double instead = length * unit.metres / taken->metres;
        if (!likely.holds(instead))
            continue;
        const Message sentence =
            model.parts.size() == 1
                ? Message("Unit", "%1: the part is %2 long; if its lengths are %3, it is %4.")
                : Message("Unit", "%1: the parts together are %2 long; if their lengths are %3, they are %4.");
        return UnitRemark{sentence.with(shortName(model.file), spoken(length), unit.plural, spoken(instead)),
                          unit.name};
    }
    return std::nullopt;
}

} // namespace knead
