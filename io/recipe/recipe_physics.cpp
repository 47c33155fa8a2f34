#include "io/recipe/recipe_physics.h"

#include "core/deformation/end_motion.h"
#include "core/deformation/number_words.h"
#include "core/message/message.h"
#include "io/recipe/recipe_deformations.h"

namespace knead::recipe_keys {

namespace {

constexpr double shortestWay = 0.01; // [s]
constexpr double longestWay = 3600;  // [s]

} // namespace

DeformByPhysics PhysicsWords::read(const JsonNode& node)
{
    DeformByPhysics deform{.body = {}, .what = {.numbers = readNumbers(node, {"name", "duration_s", "let_go"})}};
    PhysicalDeformation& what = deform.what;
    if (!hasRigidEnds(what.numbers.kind))
        node.at("kind").fail(
            Message("Recipe", "cannot be done by physics, since grips do not change the ends; say it in \"deform\"."));
    if (const auto body = node.find("body"))
        deform.body = body->text();
    if (const auto name = node.find("name"))
        what.name = name->text();
    if (const auto duration = node.find("duration_s"))
        what.duration = duration->number(shortestWay, longestWay);
    if (const auto letsGo = node.find("let_go"))
        what.letsGo = letsGo->boolean();
    return deform;
}

std::string PhysicsWords::text(const DeformByPhysics& deform)
{
    const PhysicalDeformation& what = deform.what;
    ObjectText text;
    if (!what.name.empty())
        text.text("name", what.name);
    putNumbers(text, what.numbers, {});
    text.number("duration_s", what.duration);
    if (what.letsGo)
        text.put("let_go", "true");
    if (!deform.body.empty())
        text.text("body", deform.body);
    return text.take();
}

} // namespace knead::recipe_keys
