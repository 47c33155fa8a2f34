#pragma once

#include <algorithm>
#include <array>
#include <string>

namespace knead {

/// How a model is written.
struct ExportOptions {
    std::string unit;      ///< length unit of the file, as LengthUnit::name; empty: that of the model, else mm
    double tolerance = 0;  ///< largest distance between faces written and the skin [m]; 0: 1e-4 of each part's size
    bool useAp214 = false; ///< STEP in AP214 instead of AP242
    bool isText = false;   ///< STL and PLY as text
};

/// Length units that CAD files can be written in.
inline constexpr std::array exportUnits{"mm", "cm", "m", "inch", "ft"};

inline bool canBeWrittenIn(const std::string& unit)
{
    return std::ranges::find(exportUnits, unit) != exportUnits.end();
}

} // namespace knead
