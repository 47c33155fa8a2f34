#pragma once

#include "ui/round_number.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace knead {

/// An axis of a plot: its ends, and labels in steps of 1, 2 or 5 times a power of ten.
struct PlotAxis {
    double begin = 0;
    double end = 1;
    double step = 1; ///< between labels

    /// From one number to another. @param labels about how many there is room for @pre begin <= end
    static PlotAxis between(double begin, double end, double labels)
    {
        const double size = std::max({end - begin, 1e-9 * std::max(std::abs(begin), std::abs(end)), 1e-12});
        return {begin, end, roundUp(size / std::max(1.0, labels))};
    }

    /// The same, with labels at its ends.
    static PlotAxis around(double lowest, double highest, double labels)
    {
        const double step = between(lowest, highest, labels).step;
        PlotAxis axis{std::floor(lowest / step + 1e-9) * step, std::ceil(highest / step - 1e-9) * step, step};
        if (axis.end <= axis.begin)
            axis.end = axis.begin + step;
        return axis;
    }

    double shareOf(double value) const { return (value - begin) / (end - begin); }

    /// What stands at it; zero is zero, and not what rounding left.
    std::vector<double> labels() const
    {
        std::vector<double> values;
        for (double i = std::ceil(begin / step - 1e-9); i * step <= end + 1e-9 * step; ++i)
            values.push_back(i == 0 ? 0 : i * step);
        return values;
    }

    /// Digits behind the point that tell the labels apart.
    int decimals() const { return std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9))); }
};

} // namespace knead
