#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/spacing_choice.h"
#include "core/model/part.h"
#include "core/session/part_filling.h"
#include "core/simulation/scene.h"
#include "core/task/task_control.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead::python {

/// A part of a model, which it keeps alive.
struct PartOfModel {
    std::shared_ptr<const Model> model;
    std::size_t number = 0; ///< of Model::parts

    const Part& part() const { return model->parts[number]; }
};

/// A part filled with objects of a material, ready to be simulated.
struct FilledPart {
    PartOfModel source;
    Body body;                                     ///< as a scene has it
    std::shared_ptr<const std::vector<Vec3>> rest; ///< places of the objects as they were filled [m]
    SpacingAssessment fineness;
};

/// How a script wants a part to be filled.
struct FillingWish {
    std::optional<SpacingChoice> choice; ///< none: as the window chooses
    Material material;
    bool fillsOpenPart = false; ///< also a part whose surface is not closed, where the surface winds around it
    Arrangement arrangement = Arrangement::cutCells;
};

/// @throws Problem when it cannot be filled. @throws Cancelled
std::shared_ptr<FilledPart> filledPart(const PartOfModel& part, const FillingWish& wish, TaskControl& control);

} // namespace knead::python
