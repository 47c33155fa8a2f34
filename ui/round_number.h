#pragma once

#include <cmath>
#include <initializer_list>

namespace knead {

/// The least of `digits` times a power of ten that is not below a number: steps between labels, ends of ranges. @pre least > 0
/// @param slack by which it may be below after all, for what rounding left, as a share of the number
inline double roundUp(double least, std::initializer_list<double> digits = {1, 2, 5}, double slack = 1e-9)
{
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double digit : digits)
        if (digit * power >= least * (1 - slack))
            return digit * power;
    return 10 * power;
}

/// The nearest number with so few digits, as a person would type it: 0.022 for 0.022033. Digits of an SI value are
/// those in any metric unit.
inline double typedNumber(double value, int digits = 2)
{
    if (value == 0 || !std::isfinite(value))
        return value;
    const int exponent = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
    const double power = std::pow(10.0, std::abs(exponent)); // exact, which a tenth is not
    return exponent > 0 ? std::round(value * power) / power : std::round(value / power) * power;
}

/// Whole tenths, thousandths and so on of a unit, no coarser than a length: a grid for places that a person may read.
/// @pre length > 0 @param way std::round, std::ceil
template <class Way>
double onGrid(double place, double length, Way way)
{
    const int exponent = -static_cast<int>(std::floor(std::log10(length)));
    const double power = std::pow(10.0, std::abs(exponent));
    const double there = exponent > 0 ? way(place * power) / power : way(place / power) * power;
    return there == 0 ? 0 : there; // and not -0
}

} // namespace knead
