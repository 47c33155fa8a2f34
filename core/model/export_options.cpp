#include "core/model/export_options.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace knead {

bool canBeWrittenIn(const std::string& unit)
{
    constexpr std::array<std::string_view, 5> units{"mm", "cm", "m", "inch", "ft"};
    return std::find(units.begin(), units.end(), unit) != units.end();
}

} // namespace knead
