// What recipes say of loads and of grips that turn.
#include "io/recipe/recipe_events_text.h"

#include <cmath>

namespace knead {

void putTurn(ObjectText& text, const GripTurn& turn)
{
    if (!turn.turns())
        return;
    ObjectText words;
    words.millimeters("center_mm", turn.center).numbers("angular_velocity_rad_s", turn.angularVelocity);
    if (std::isfinite(turn.angle))
        words.number("angle_rad", turn.angle);
    text.put("turn", words.take());
}

void putAmount(ObjectText& text, const LoadAmount& amount, double ramp)
{
    if (!amount.force.isZero(0))
        text.numbers("force_n", amount.force);
    if (!amount.moment.isZero(0))
        text.numbers("moment_nm", amount.moment);
    if (amount.pressure != 0)
        text.number("pressure_pa", amount.pressure);
    if (ramp != 0)
        text.number("ramp_s", ramp);
}

std::string RecipeWords::load(const Load& load) const
{
    ObjectText text;
    text.text("name", names.addLoad(load.name));
    if (names.hasManyBodies())
        text.text("body", names.body(load.body));
    if (load.box) {
        text.millimeters("box_mm", *load.box);
    } else {
        text.put("faces", listText(load.faces, wholeText));
    }
    putAmount(text, load.amount, load.ramp);
    return text.take();
}

} // namespace knead
