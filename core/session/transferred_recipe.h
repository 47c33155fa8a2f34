#pragma once

#include "core/message/message.h"
#include "core/session/body_maps.h"
#include "core/session/recipe.h"
#include "core/session/recipe_scene.h"

#include <span>
#include <string>
#include <vector>

namespace knead {

/// What became of the things of a recipe on another part.
struct TransferReport {
    /// A face of the part, and where it is on the other one.
    struct Face {
        std::string body;
        std::uint32_t before = 0;
        std::string bodyAfter;
        std::optional<std::uint32_t> after; ///< none: it was not found again
        FoundBy by = FoundBy::place;
        double score = 0; ///< 0 .. 1
    };
    /// A thing that has a place: a tool, a fixture, a probe ...
    struct Moved {
        Message what;              ///< the fixture "clamp", the tool "ball" ...
        Vec3 shift = Vec3::Zero(); ///< of where it begins [m]
    };
    std::vector<Face> faces; ///< of all bodies
    std::vector<Moved> moved;
    std::vector<Message> leftOut; ///< sentences: what has no place on the other part
    double scale = 1;

    std::size_t found() const; ///< how many of the faces
};

/// Both parts as they are filled, and what is known of where places are.
struct TransferGround {
    const RecipeScene& before;
    const RecipeScene& after;
    std::span<const BodyMap> bodies; ///< at least one
    AffineMap base;                  ///< its linear part is a turn or a mirror image, times a scale
    TaskControl& control = TaskControl::none();
};

/// The recipe with all its places moved: everything but its part, spacing, steps and exports.
/// @param report gets what was moved and left out
/// @throws Cancelled
Recipe transferredRecipe(const Recipe& recipe, const TransferGround& ground, TransferReport& report);

} // namespace knead
