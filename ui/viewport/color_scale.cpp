#include "ui/viewport/color_scale.h"

#include "ui/language/said.h"
#include "ui/round_number.h"
#include "ui/units.h"

#include <QCoreApplication>

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace knead {

namespace {

struct Look {
    const char* name;
    Quantity unit;
    double least; ///< the range is at least so large, where there is nothing to see
};

constexpr std::array<Look, surfaceQuantityCount> looks{
    {{QT_TRANSLATE_NOOP("ColorScale", "Displacement"), Quantity::Length, 1e-5},
     {QT_TRANSLATE_NOOP("ColorScale", "Strain"), Quantity::Strain, 1e-3},
     {QT_TRANSLATE_NOOP("ColorScale", "Von Mises stress"), Quantity::Pressure, 10},
     {QT_TRANSLATE_NOOP("ColorScale", "Plastic strain"), Quantity::Strain, 1e-3},
     {QT_TRANSLATE_NOOP("ColorScale", "Contact force"), Quantity::Force, 1e-4},
     {QT_TRANSLATE_NOOP("ColorScale", "Distance to the original"), Quantity::Length, 1e-5}}};

const Look& lookOf(SurfaceQuantity quantity)
{
    return looks[static_cast<std::size_t>(quantity)];
}

} // namespace

double roundedUp(double value)
{
    if (!(value > 0) || !std::isfinite(value))
        return 0;
    return roundUp(value, {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}, 1e-6);
}

Message termOf(SurfaceQuantity quantity)
{
    return {"ColorScale", lookOf(quantity).name};
}

QString nameOf(SurfaceQuantity quantity)
{
    return said(termOf(quantity));
}

Quantity unitKindOf(SurfaceQuantity quantity)
{
    return lookOf(quantity).unit;
}

bool hasSign(SurfaceQuantity quantity)
{
    return quantity == SurfaceQuantity::distance;
}

ColorScale colorScale(const SurfaceFields& fields, const ColorOptions& options,
                      const std::function<bool(std::size_t)>& isShown)
{
    ColorScale scale{.quantity = *fields.request.quantity, .isKnown = fields.isKnown};
    scale.errorShare = roundedUp(fields.errorShare);
    scale.map = hasSign(scale.quantity) ? ColorMap::diverging : options.map;
    if (options.range) {
        std::tie(scale.least, scale.most) = *options.range;
        return scale;
    }
    double most = lookOf(scale.quantity).least;
    for (std::size_t b = 0; b < fields.values.size(); ++b)
        if (isShown(b))
            for (const float value : fields.values[b])
                most = std::max(most, std::abs(static_cast<double>(value)));
    scale.most = roundedUp(most);
    scale.least = hasSign(scale.quantity) ? -scale.most : 0;
    return scale;
}

ScaleText textOf(const ColorScale& scale)
{
    constexpr double mostSteps = 6;
    constexpr double leastError = 1e-3; // worth a word
    ScaleText text;
    const double largest = std::max(std::abs(scale.least), std::abs(scale.most));
    const ShownUnit unit = shownUnit(largest, unitKindOf(scale.quantity));
    text.title = unit.symbol.isEmpty() ? nameOf(scale.quantity)
                                       : QStringLiteral("%1 [%2]").arg(nameOf(scale.quantity), unit.symbol);
    if (scale.errorShare >= leastError)
        text.title = QCoreApplication::translate("ColorScale", "%1, about ±%2 %")
                         .arg(text.title, localNumber(100 * scale.errorShare, 'g', 2));
    const double step = roundUp((scale.most - scale.least) / unit.scale / mostSteps, {1.0, 2.0, 2.5, 5.0});
    const double first = std::ceil(scale.least / unit.scale / step - 1e-6);
    for (double i = first; i * step * unit.scale <= scale.most + 1e-6 * (scale.most - scale.least); ++i) {
        const double value = i * step;
        // Zero is zero, and not -0 or what rounding left.
        text.ticks.push_back({scale.shareOf(value * unit.scale), localNumber(i == 0 ? 0.0 : value, 'g', 5)});
    }
    return text;
}

} // namespace knead
