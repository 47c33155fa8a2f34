#pragma once

#include "core/session/recipe.h"
#include "io/recipe/recipe_kinds.h"

namespace knead::recipe_keys {

// The keys of parts, bodies and what holds them, see recipe_fields.h.

constexpr double fastestStart = 1e5; // [mm/s] and [degrees/s]
constexpr double largestLoad = 1e12; // [N], [N m], [Pa]
constexpr double longestRamp = 3600; // [s]

/// The name of a material, or an object with numbers.
struct MaterialWords {
    const Context& context;
    RecipeMaterial read(const JsonNode& node) const;
    std::string text(const RecipeMaterial& material) const;
};

/// `objects` with `objects_in_body`; none without the key.
std::optional<RecipeObjects> readObjects(const JsonNode& node);
void putObjects(ObjectText& text, const RecipeObjects& objects);

/// Exactly one of `faces`, `box_mm` and `objects`.
void readPlaceOf(const JsonNode& node, RecipeRegion& region);
void putPlaceOf(ObjectText& text, const RecipeRegion& region);
void eachFaceOnce(std::vector<std::uint32_t>& faces); ///< ascending

void readTurn(const JsonNode& node, GripTurn& turn);
void putTurn(ObjectText& text, const GripTurn& turn);

/// The part of a recipe with the choices of its import: those that the result depends on.
struct PartFiles {
    std::vector<std::string> files; ///< at least one
    ImportOptions import;
    bool fillsOpenParts = false;
};
std::vector<std::string> readPartFiles(const JsonNode& node, const Context& context);
void putPartFiles(ObjectText& text, const std::vector<std::string>& files);

template <class Fields>
void describeKeys(Fields& fields, PartFiles& part)
{
    fields.together(
        {"file", "files"}, [&](const JsonNode& node) { part.files = readPartFiles(node, fields.context); },
        [&](ObjectText& text) { putPartFiles(text, part.files); });
    ImportOptions& import = part.import;
    const ImportOptions usual;
    fields.optional("parts", import.parts, ListOf{Text{}}, !import.parts.empty());
    fields.optional("unit", import.unit, LengthUnitName{}, !import.unit.empty());
    fields.optional("heal", import.heal, Flag{}, !import.heal);
    fields.optional("cap_flat_openings", import.capsFlatOpenings, Flag{}, import.capsFlatOpenings);
    fields.optional("deflection_mm", import.linearDeflection, PositiveMillimeters{}, import.linearDeflection != 0);
    fields.optional("relative_deflection", import.relativeDeflection, Number{1e-9, 1},
                    import.relativeDeflection != usual.relativeDeflection);
    fields.optional("angular_deflection_rad", import.angularDeflection, Number{1e-3, 10},
                    import.angularDeflection != usual.angularDeflection);
    fields.optional("fills_open_parts", part.fillsOpenParts, Flag{}, part.fillsOpenParts);
}

template <class Fields>
void describeKeys(Fields& fields, RecipeFloor& floor)
{
    fields.needed("height_mm", floor.height, Millimeters{});
    fields.optional("friction", floor.friction, Number{0, 2});
    fields.optional("adhesion_pa", floor.adhesion, Number{0, 1e9}, floor.adhesion > 0);
}

template <class Fields>
void describeKeys(Fields& fields, RecipeBody& body)
{
    fields.optional("kind", body.kind, Word{bodyKindWords()}, body.kind != BodyKind::deformable);
    fields.optional("velocity_mm_s", body.velocity, VectorInMillimeters{fastestStart}, body.velocity != Vec3::Zero());
    fields.together(
        {"angular_velocity_deg_s", "angular_velocity_rad_s"},
        [&](const JsonNode& node) {
            const auto degrees = node.find("angular_velocity_deg_s");
            const auto radians = node.find("angular_velocity_rad_s");
            if (degrees && radians)
                node.fail(Message("Recipe",
                                  "must have only one of the keys angular_velocity_deg_s and angular_velocity_rad_s."));
            if (degrees)
                body.angularVelocity = radiansPerDegree * readVector(*degrees, fastestStart);
            if (radians)
                body.angularVelocity = readVector(*radians, fastestStart);
        },
        [&](ObjectText& text) {
            if (body.angularVelocity != Vec3::Zero())
                text.numbers("angular_velocity_rad_s", body.angularVelocity);
        });
}

/// Of a whole body where nothing is said of a box or of objects.
template <class Fields, class Where>
void describeWhere(Fields& fields, Where& where)
{
    fields.optional("body", where.body, Text{}, !where.body.empty());
    fields.optional("box_mm", where.box, BoxInMillimeters{});
    fields.together(
        {"objects", "objects_in_body", "filled_anew"},
        [&](const JsonNode& node) {
            where.objects = readObjects(node);
            if (where.objects && where.box)
                node.fail(Message("Recipe", "must have only one of the keys box_mm and objects."));
        },
        [&](ObjectText& text) {
            if (where.objects)
                putObjects(text, *where.objects);
        });
}

template <class Fields>
void describePlace(Fields& fields, RecipeRegion& region, std::initializer_list<const char*> keys)
{
    fields.needed("name", region.name, Text{});
    fields.optional("body", region.body, Text{}, !region.body.empty());
    fields.together(
        keys, [&](const JsonNode& node) { readPlaceOf(node, region); },
        [&](ObjectText& text) { putPlaceOf(text, region); });
}

template <class Fields>
void describeKeys(Fields& fields, GripTurn& turn)
{
    fields.needed("center_mm", turn.center, VectorInMillimeters{});
    fields.together(
        {"axis", "speed_deg_s", "angle_deg", "angular_velocity_rad_s", "angle_rad"},
        [&](const JsonNode& node) { readTurn(node, turn); }, [&](ObjectText& text) { putTurn(text, turn); });
}

template <class Fields>
void describeKeys(Fields& fields, RecipeFixture& fixture)
{
    describePlace(fields, fixture, {"faces", "box_mm", "objects", "objects_in_body", "filled_anew"});
    fields.optional("velocity_mm_s", fixture.velocity, VectorInMillimeters{fastestStart},
                    fixture.velocity != Vec3::Zero());
    fields.optional("turn", fixture.turn, Object<GripTurn>{fields.context}, fixture.turn.turns());
    fields.optional("moment_center_mm", fixture.momentCenter, VectorInMillimeters{});
}

template <class Fields>
void describeKeys(Fields& fields, RecipeMaterialRegion& region)
{
    describePlace(fields, region, {"faces", "box_mm", "objects", "objects_in_body"});
    fields.needed("material", region.material, MaterialWords{fields.context});
}

template <class Fields>
void describeAmount(Fields& fields, LoadAmount& amount, double& ramp)
{
    fields.optional("force_n", amount.force, Vector{largestLoad}, !amount.force.isZero(0));
    fields.optional("moment_nm", amount.moment, Vector{largestLoad}, !amount.moment.isZero(0));
    fields.optional("pressure_pa", amount.pressure, Number{-largestLoad, largestLoad}, amount.pressure != 0);
    fields.optional("ramp_s", ramp, Number{0, longestRamp}, ramp != 0);
}

template <class Fields>
void describeKeys(Fields& fields, RecipeLoad& load)
{
    describePlace(fields, load, {"faces", "box_mm"});
    fields.check([&load](const JsonNode& /*node*/) { eachFaceOnce(load.faces); });
    describeAmount(fields, load.amount, load.ramp);
}

template <class Fields>
void describeKeys(Fields& fields, RecipeProbe& probe)
{
    fields.needed("name", probe.name, Text{});
    fields.optional("body", probe.body, Text{}, !probe.body.empty());
    fields.needed("place_mm", probe.place, VectorInMillimeters{});
}

} // namespace knead::recipe_keys
