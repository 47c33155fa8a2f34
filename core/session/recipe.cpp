#include "core/session/recipe.h"

#include "core/model/file_formats.h"

namespace knead {

Material RecipeMaterial::on(const Material& base) const
{
    Material material = preset.value_or(base);
    for (const auto& [member, number] : overrides)
        material.*member = number;
    return material;
}

bool RecipeExport::isPicture() const
{
    return knead::isPicture(file);
}

} // namespace knead
