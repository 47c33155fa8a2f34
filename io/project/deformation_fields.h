#pragma once

#include "core/deformation/number_words.h"
#include "core/document/recipe_deformation.h"
#include "io/project/json_fields.h"

#include <string>
#include <vector>

namespace knead {

// The fields of what deformed the parts of a project before they were filled, see json_fields.h.

template <>
inline constexpr const char* wordOf<NumberDeformation> = "numbers";
template <>
inline constexpr const char* wordOf<RecipeField> = "field";

inline const Choices<NumberKind>& numberKindChoices()
{
    static const Choices<NumberKind> words = [] {
        Choices<NumberKind> all;
        for (const NumberKindWords& kind : numberKindWords())
            all.emplace_back(kind.word, kind.kind);
        return all;
    }();
    return words;
}

template <class Fields>
void describe(Fields& fields, Field<Fields, NumberDeformation> numbers)
{
    fields.choice("kind", numbers.kind, numberKindChoices());
    fields("origin_m", numbers.origin);
    fields("axis", numbers.axis);
    fields("side", numbers.side);
    fields("from_m", numbers.from);
    fields("to_m", numbers.to);
    fields("angle_rad", numbers.angle);
    fields("factor", numbers.factor);
    fields("shift_m", numbers.shift);
    fields("neutral_m", numbers.neutral);
    fields("stays", numbers.stays);
    fields("eases", numbers.eases);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, KeptFaces> kept)
{
    fields("body", kept.body);
    fields("faces", kept.faces);
}

/// Left out by who takes the last step.
inline void describeStep(FieldWriter& fields, const FieldChoice& choice)
{
    if (choice.step)
        fields("step", static_cast<std::uint64_t>(*choice.step));
}
inline void describeStep(const FieldReader& fields, FieldChoice& choice)
{
    choice.step.reset();
    if (!fields.node().find("step"))
        return;
    std::uint64_t step = 0;
    fields("step", step);
    choice.step = static_cast<std::size_t>(step);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, FieldChoice> choice)
{
    describeStep(fields, choice);
    fields("name", choice.name);
    fields("unit", choice.unit);
    fields.flagIfSet("in_place", choice.isInPlace);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, RecipeField> field)
{
    fields("file", field.file);
    fields.object("choice", field.choice);
    fields("factor", field.factor);
    fields.listIfAny("kept", field.kept);
    fields.numberIfAny("fade_m", field.fade);
    fields.flagIfSet("locks_x", field.locked[0]);
    fields.flagIfSet("locks_y", field.locked[1]);
    fields.flagIfSet("locks_z", field.locked[2]);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, RecipeDeformation> deformation)
{
    fields("bodies", deformation.bodies);
    describeVariant(fields, "by", deformation.what);
    fields("k_factor", deformation.kFactor);
    fields.flagIfSet("separately", deformation.isApart);
}

/// What a start keeps of them.
struct StartDeformations {
    std::vector<RecipeDeformation> all;
};

template <class Fields>
void describe(Fields& fields, Field<Fields, StartDeformations> deformations)
{
    fields.list("deform", deformations.all);
}

} // namespace knead
