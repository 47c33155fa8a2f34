#pragma once

#include "core/document/project.h"
#include "io/project/json_fields.h"
#include "io/recipe/scene_words.h"

namespace knead {

// The fields of what a project has besides scenes, see json_fields.h.

template <class Fields>
void describe(Fields& fields, Field<Fields, ImportOptions> options)
{
    fields("linear_deflection_m", options.linearDeflection);
    fields("angular_deflection_rad", options.angularDeflection);
    fields("relative_deflection", options.relativeDeflection);
    fields("heal", options.heal);
    fields("caps_flat_openings", options.capsFlatOpenings);
    fields("unit", options.unit);
    fields("parts", options.parts);
    fields("memory_limit_bytes", options.memoryLimit);
    fields("time_limit_s", options.timeLimit);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, SpacingChoice> spacing)
{
    using Kind = SpacingChoice::Kind;
    static const Choices<Kind> words{{"length-m", Kind::Length},
                                     {"cells-along", Kind::CellsAlong},
                                     {"cells-across-wall", Kind::CellsAcrossWall},
                                     {"objects", Kind::Objects}};
    fields.choice("by", spacing.kind, words);
    fields("value", spacing.value);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, ImportChoices> choices)
{
    fields("files", choices.paths);
    fields.object("options", choices.options);
    fields.object("spacing", choices.spacing);
    fields.choice("touching", choices.touching, touchingWords());
    fields("fills_open_parts", choices.fillsOpenParts);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, ProjectCamera> camera)
{
    fields("position_m", camera.position);
    fields("focal_point_m", camera.focalPoint);
    fields("up", camera.up);
    fields("parallel_scale_m", camera.parallelScale);
    fields("perspective", camera.perspective);
}

} // namespace knead
