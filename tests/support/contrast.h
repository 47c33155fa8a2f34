#pragma once

#include <QColor>

#include <algorithm>
#include <cmath>

namespace knead {

/// Of a channel of sRGB, 0 .. 1: how much light it is.
inline double linearLight(double channel)
{
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

/// As WCAG 2.1 has it: 1 of the same color, 21 of black on white.
inline double contrastOf(const QColor& a, const QColor& b)
{
    const auto lightOf = [](const QColor& color) {
        return 0.05 + 0.2126 * linearLight(color.redF()) + 0.7152 * linearLight(color.greenF()) +
               0.0722 * linearLight(color.blueF());
    };
    const double first = lightOf(a);
    const double second = lightOf(b);
    return std::max(first, second) / std::min(first, second);
}

} // namespace knead
