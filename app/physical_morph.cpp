#include "app/physical_morph.h"

#include "app/cad_process.h"
#include "app/recipe_files.h"
#include "app/resources.h"
#include "core/message/message.h"
#include "core/model/file_formats.h"
#include "core/session/end_grips.h"
#include "io/material_library.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace knead {

namespace {

namespace fs = std::filesystem;

constexpr double usualDuration = 1;         // of the way of the grips [s]
constexpr std::size_t usualObjects = 20000; // that the part is filled with
constexpr std::size_t leastObjects = 8;
constexpr double restAfterWay = 0.5;    // in which what swings comes to rest [s]
constexpr double restAfterSpring = 1.5; // the same where a grip has let go [s]

/// The one deformation that is to be done, as one by number.
const NumberWish& wishOf(const PhysicalMorphRequest& request)
{
    const auto* number = request.wishes.size() == 1 ? std::get_if<NumberWish>(&request.wishes.front()) : nullptr;
    if (number == nullptr)
        throw Problem(Message("Deformation", "--physics does one bend, twist, stretch or shear at a time; give one of "
                                             "them, and for more write a recipe."));
    if (request.parts.size() > 1)
        throw Problem(Message("Deformation", "--physics deforms one part or all of them; for some write a recipe."));
    return *number;
}

/// What would only come to light after minutes.
void checkAtOnce(const PhysicalMorphRequest& request)
{
    if (formatToWrite(request.output) == nullptr)
        throw Problem(Message("Deformation", "%1: the ending is none of %2; name the file after its format.")
                          .with(request.output, formatEndings(" and ")));
    if (request.physics.objects && *request.physics.objects < leastObjects)
        throw Problem(Message("Deformation", "A part is filled with %1 objects at least.").with(leastObjects));
}

Material materialOf(const PhysicsWish& physics)
{
    std::string known;
    for (const MaterialPreset& preset : readMaterials(materialsFile())) {
        if (preset.id == physics.material)
            return preset.material;
        known += (known.empty() ? "" : ", ") + preset.id;
    }
    if (physics.material.empty())
        throw Problem(Message("Deformation", "--physics needs to know what the part is made of: give --material, one "
                                             "of %1.")
                          .with(known));
    throw Problem(
        Message("Deformation", "There is no material \"%1\"; --material is one of %2.").with(physics.material, known));
}

/// What was left open filled in, from the part as it is.
NumberDeformation numbersFilledIn(const PhysicalMorphRequest& request, TaskControl& control)
{
    TaskPortion reading(control, 0, 0.7);
    const Model model = importInChild(request.input, request.import, reading);
    TaskPortion planning(control, 0.7, 1);
    const DeformationPlan plan = planOf(request.wishes, model, partsNamed(model, request.parts), planning);
    return std::get<NumberDeformation>(plan.deformations->front());
}

} // namespace

RunReport morphByPhysics(const PhysicalMorphRequest& request, TaskControl& control, const SayAtOnce& say)
{
    const PhysicsWish& physics = request.physics;
    checkAtOnce(request);
    if (const Message why = whyNotByPhysics(wishOf(request).kind); !why.empty())
        throw Problem(why);
    const Material material = materialOf(physics);
    TaskPortion planning(control, 0, 0.1);
    DeformByPhysics deform{.body = request.parts.empty() ? std::string() : request.parts.front(),
                           .what = {.numbers = numbersFilledIn(request, planning),
                                    .duration = physics.duration.value_or(usualDuration),
                                    .letsGo = physics.letsGo}};
    Recipe recipe;
    recipe.file = request.input;
    recipe.part = request.input;
    recipe.import = request.import;
    recipe.spacing = {SpacingChoice::Kind::Objects, static_cast<double>(physics.objects.value_or(usualObjects))};
    recipe.material = material;
    recipe.duration = deform.what.duration + (physics.letsGo ? restAfterSpring : restAfterWay);
    recipe.events.push_back({.action = std::move(deform)});
    const fs::path output = fs::absolute(request.output);
    recipe.exports.push_back(
        {.file = output.filename().string(), .options = request.write, .wantsReport = request.wantsReport});
    TaskPortion running(control, 0.1, 1);
    return runRecipe(recipe, recipeFiles(), output.parent_path().string(), running, say);
}

} // namespace knead
