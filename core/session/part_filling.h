#pragma once

#include "core/aggregate/fill.h"
#include "core/aggregate/material.h"
#include "core/aggregate/spacing_choice.h"
#include "core/model/part.h"
#include "core/task/task_control.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// How bodies are filled with objects.
enum class Arrangement {
    cutCells,  ///< fill()
    published, ///< fillAsPublished(), to repeat published scenes
};

/// Parts that have an inside, by index into Model::parts.
/// @param fillsOpenParts also those whose surface is not closed
std::vector<std::size_t> partsToFill(const Model& model, bool fillsOpenParts);

/// Of the parts that are filled.
struct FillingSizes {
    FillingSize all;
    FillingSize largest; ///< by volume
};

/// Walls are those of closed parts, unless they are what is chosen by. @throws Cancelled
FillingSizes fillingSizes(const Model& model, std::span<const std::size_t> parts,
                          const std::optional<SpacingChoice>& choice, TaskControl& control);

/// One spacing for all bodies, where nobody chose [m]: the one that suits the largest, given its share of the objects; finer
/// for the sake of thin walls as far as that is not much slower.
double automaticSpacing(const FillingSizes& sizes);

/// The spacing that was chosen [m]; the automatic one without a choice, or where it means none.
double spacingOf(const std::optional<SpacingChoice>& choice, const FillingSizes& sizes);

/// The objects of a part. @throws as fill()
std::shared_ptr<const Aggregate> fillPart(const Part& part, double spacing, Arrangement arrangement,
                                          TaskControl& control);

/// What a part is made of until a person chooses: soft, and quick to follow a hand. Of the presets the one that is meant, or
/// a material as it comes.
inline constexpr const char* startMaterialId = "sponge-rubber";
Material startMaterial(std::span<const MaterialPreset> presets);

} // namespace knead
