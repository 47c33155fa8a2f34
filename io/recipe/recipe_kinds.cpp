#include "io/recipe/recipe_kinds.h"

#include "core/message/message.h"
#include "core/model/length_units.h"

#include <array>

namespace knead::recipe_keys {

std::string BoxInMillimeters::text(const Box& meters)
{
    const Vec3& low = meters.min();
    const Vec3& high = meters.max();
    return listText(std::array{low.x(), low.y(), low.z(), high.x(), high.y(), high.z()}, exactThousandfold);
}

std::string LengthUnitName::read(const JsonNode& node)
{
    std::string unit = node.text();
    if (findLengthUnit(unit) == nullptr)
        node.failExpecting(Message("Recipe", "must be one of %1").with(lengthUnitNames()));
    return unit;
}

} // namespace knead::recipe_keys
