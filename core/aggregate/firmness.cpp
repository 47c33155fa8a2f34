#include "core/aggregate/firmness.h"

#include <algorithm>
#include <array>

namespace knead {

Material firmer(const Material& material, double factor)
{
    constexpr std::array scaled{&Material::youngsModulus, &Material::yieldStress, &Material::hardening,
                                &Material::tensileStrength, &Material::toughness};
    Material result = material;
    for (const MaterialField& field : materialFields())
        if (std::ranges::find(scaled, field.value) != scaled.end())
            result.*field.value = std::clamp(factor * material.*field.value, field.minimum, field.maximum);
    return result;
}

} // namespace knead
