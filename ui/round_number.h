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

} // namespace knead
