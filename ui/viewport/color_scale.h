#pragma once

#include "core/message/message.h"
#include "core/session/surface_fields.h"
#include "ui/units.h"
#include "ui/viewport/color_map.h"

#include <QString>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace knead {

/// How a person wants numbers on the skin to be colored.
struct ColorOptions {
    std::optional<SurfaceQuantity> quantity;        ///< none: the colors of the parts
    ColorMap map = ColorMap::viridis;               ///< of numbers without a sign; the others diverge
    std::optional<std::pair<double, double>> range; ///< from, to, in SI; none: what there is

    friend bool operator==(const ColorOptions&, const ColorOptions&) = default;
};

/// Which color stands for which number.
struct ColorScale {
    SurfaceQuantity quantity = SurfaceQuantity::displacement;
    ColorMap map = ColorMap::viridis;
    double least = 0; ///< in SI, as all here
    double most = 1;
    bool isKnown = true; ///< false: the moment that is shown does not tell
    double errorShare =
        0; ///< about how wrong the numbers may be, in round numbers, as a share of the largest; 0: not known
    friend bool operator==(const ColorScale&, const ColorScale&) = default;

    /// Place of a number on the map, 0 .. 1 within the range.
    double shareOf(double value) const { return (value - least) / (most - least); }
};

/// Of what is shown; an automatic range begins and ends at round numbers, so that it stays while numbers change a little.
/// @param isShown whether a body counts, by its number
ColorScale colorScale(const SurfaceFields& fields, const ColorOptions& options,
                      const std::function<bool(std::size_t)>& isShown);

/// The next number of two digits above that is easy to read, 0 for 0. @param value not negative
double roundedUp(double value);

Message termOf(SurfaceQuantity quantity); ///< "Von Mises stress"
QString nameOf(SurfaceQuantity quantity); ///< the same, said
Quantity unitKindOf(SurfaceQuantity quantity);
bool hasSign(SurfaceQuantity quantity);

/// What stands at a color bar.
struct ScaleText {
    struct Tick {
        double share = 0; ///< of the bar, from below
        QString text;
    };
    QString title;           ///< with the unit: "Strain [%]", and how wrong the numbers may be
    std::vector<Tick> ticks; ///< from below, 4 to 9 at round numbers
};
ScaleText textOf(const ColorScale& scale);

} // namespace knead
