#include "app/python/filled_part.h"

#include "core/aggregate/fill.h"
#include "core/message/message.h"
#include "core/session/part_filling.h"

#include <array>

namespace knead::python {

namespace {

void checkMaterial(const Material& material)
{
    if (const std::vector<Message> problems = materialProblems(material); !problems.empty())
        throw Problem(problems.front());
}

} // namespace

std::shared_ptr<FilledPart> filledPart(const PartOfModel& part, const FillingWish& wish, TaskControl& control)
{
    checkMaterial(wish.material);
    TaskPortion measuring(control, 0, 0.2);
    const FillingSizes sizes = fillingSizes(*part.model, std::array{part.number}, wish.choice, measuring);
    const double spacing = spacingOf(wish.choice, sizes);
    TaskPortion filling(control, 0.2, 1);
    auto filled = std::make_shared<FilledPart>();
    filled->source = part;
    filled->fineness = assessSpacing(spacing, sizes.all);
    filled->body.name = part.part().name;
    filled->body.material = wish.material;
    filled->body.surface = surfaceOf(part.model, part.number);
    filled->body.aggregate =
        part.part().canBeFilled() || wish.fillsOpenPart
            ? fillPart(part.part(), spacing, wish.arrangement, filling)
            : std::make_shared<const Aggregate>(fill(part.part().mesh, {.spacing = spacing}, filling));
    filled->rest = std::make_shared<const std::vector<Vec3>>(filled->body.aggregate->lattice.positions());
    return filled;
}

} // namespace knead::python
