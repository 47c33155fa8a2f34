#include "io/recipe/recipe_deformations.h"

#include "core/deformation/number_map.h"
#include "core/deformation/number_words.h"
#include "core/message/message.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead::recipe_keys {

namespace {

constexpr double leastSine = 1e-6;       // of the angle between an axis and a side
constexpr double mostFieldFactor = 1e6;  // of a field
constexpr double mostTurned = 62.9;      // [rad]
constexpr int mostFileSteps = 1'000'000; // of a file

const char* const apartKey = "separately";
const char* const axisNames[] = {"x", "y", "z"};

Vec3 readDirection(const JsonNode& node)
{
    const Vec3 direction = readVector(node, farAway);
    if (!(direction.norm() > 0))
        node.failExpecting(Message("Recipe", "must be a direction of 3 numbers that are not all 0"));
    // What is of unit length keeps its bits.
    return std::abs(direction.norm() - 1) < 1e-15 ? direction : Vec3(direction.normalized());
}

/// The part of a direction that is across an axis.
Vec3 across(const Vec3& axis, const Vec3& direction)
{
    if (std::abs(axis.dot(direction)) < 1e-15)
        return direction;
    return (direction - axis * axis.dot(direction)).normalized();
}

/// The kind of a direction, of unit length.
struct Direction {
    static Vec3 read(const JsonNode& node) { return readDirection(node); }
    static std::string text(const Vec3& value) { return listText(value, exactText); }
};

/// Keys of all kinds, of which each has some.
const std::vector<std::string>& keysOfNumbers()
{
    static const std::vector<std::string> keys = [] {
        std::vector<std::string> all{"kind",    "body",  "origin_mm", "axis",      "side",
                                     "from_mm", "to_mm", "stays",     "angle_rad", "radius_mm"};
        for (const NumberKindWords& words : numberKindWords())
            for (const NumberParameter& parameter : words.parameters)
                if (std::ranges::find(all, parameter.key) == all.end())
                    all.emplace_back(parameter.key);
        return all;
    }();
    return keys;
}

/// @throws Problem for what says how much of another kind
void refuseKeysOfOthers(const JsonNode& node, const NumberKindWords& words)
{
    const auto refuse = [&](const char* key) {
        if (const auto found = node.find(key))
            found->fail(Message("Recipe", "does not belong to the kind %1.").with(words.word));
    };
    const auto has = [&](double NumberDeformation::*value) {
        return std::ranges::any_of(words.parameters,
                                   [&](const NumberParameter& parameter) { return parameter.value == value; });
    };
    for (const NumberKindWords& others : numberKindWords())
        for (const NumberParameter& parameter : others.parameters)
            if (!has(parameter.value))
                refuse(parameter.key);
    if (!has(&NumberDeformation::angle))
        refuse("angle_rad");
    if (words.kind != NumberKind::bend) {
        refuse("radius_mm");
        refuse("k_factor");
    }
    if (!words.hasSide)
        refuse("side");
}

void readAngle(const JsonNode& node, const NumberParameter& degrees, NumberDeformation& deformation)
{
    const auto typed = node.find(degrees.key);
    const auto radians = node.find("angle_rad");
    const auto radius = deformation.kind == NumberKind::bend ? node.find("radius_mm") : std::optional<JsonNode>();
    if (typed.has_value() + radians.has_value() + radius.has_value() != 1)
        node.fail(deformation.kind == NumberKind::bend
                      ? Message("Recipe", "must have exactly one of the keys angle_deg, angle_rad and radius_mm.")
                      : Message("Recipe", "must have exactly one of the keys angle_deg and angle_rad."));
    if (typed)
        degrees.set(deformation, typed->number(degrees.least, degrees.most));
    else if (radians)
        deformation.angle = radians->number(-mostTurned, mostTurned);
    else
        deformation.angle = deformation.length() / radius->positiveThousandth();
    if (deformation.angle > mostTurned)
        radius->fail(
            Message("Recipe", "is so small that the bend goes around more than ten times; take a larger one."));
}

void readAmounts(const JsonNode& node, const NumberKindWords& words, NumberDeformation& deformation)
{
    for (const NumberParameter& parameter : words.parameters) {
        if (parameter.unit == NumberParameter::Unit::degrees)
            readAngle(node, parameter, deformation);
        else if (parameter.value == &NumberDeformation::neutral) {
            if (const auto neutral = node.find(parameter.key))
                deformation.neutral = neutral->thousandth();
        } else if (parameter.unit == NumberParameter::Unit::millimeters)
            deformation.*parameter.value = node.at(parameter.key).thousandth();
        else
            deformation.*parameter.value = node.at(parameter.key).number(parameter.least, parameter.most);
    }
}

std::optional<double> readKFactor(const JsonNode& node)
{
    const auto kFactor = node.find("k_factor");
    if (!kFactor)
        return std::nullopt;
    if (node.find("neutral_mm"))
        node.fail(Message("Recipe", "must have one of the keys neutral_mm and k_factor, or none."));
    return kFactor->number(0, 1);
}

} // namespace

NumberDeformation readNumbers(const JsonNode& node, const std::vector<std::string>& others)
{
    std::vector<std::string> allowed = keysOfNumbers();
    allowed.insert(allowed.end(), others.begin(), others.end());
    node.allowOnly(allowed);
    const std::string word = node.at("kind").text();
    const auto kind = numberKindOf(word);
    if (!kind)
        node.at("kind").failExpecting(
            Message("Recipe", "must be one of %1").with(listed(numberKindWords(), [](const NumberKindWords& words) {
                return std::string(words.word);
            })));
    const NumberKindWords& words = wordsOf(*kind);
    refuseKeysOfOthers(node, words);
    NumberDeformation deformation{.kind = *kind};
    if (const auto origin = node.find("origin_mm"))
        deformation.origin = readPlace(*origin);
    deformation.axis = readDirection(node.at("axis"));
    const Vec3 side = words.hasSide ? readDirection(node.at("side")) : deformation.axis.unitOrthogonal();
    if (deformation.axis.cross(side).norm() < leastSine)
        node.at("side").fail(Message("Recipe", "must point across the axis."));
    deformation.side = across(deformation.axis, side);
    deformation.from = node.at("from_mm").thousandth();
    deformation.to = node.at("to_mm").thousandth();
    if (!(deformation.to > deformation.from))
        node.at("to_mm").fail(Message("Recipe", "must be larger than from_mm."));
    readAmounts(node, words, deformation);
    if (const auto stays = node.find("stays"))
        deformation.stays = stays->number(0, 1);
    if (const auto eases = node.find("eases"))
        deformation.eases = eases->boolean();
    try {
        const NumberMap checked(deformation);
    } catch (const Problem& problem) {
        node.fail(Message("Recipe", "cannot be: %1").with(messageOf(problem)));
    }
    return deformation;
}

void putNumbers(ObjectText& text, const NumberDeformation& deformation, const std::optional<double>& kFactor)
{
    const NumberKindWords& words = wordsOf(deformation.kind);
    text.text("kind", words.word);
    if (deformation.origin != Vec3::Zero())
        text.put("origin_mm", VectorInMillimeters::text(deformation.origin));
    text.put("axis", Direction::text(deformation.axis));
    if (words.hasSide)
        text.put("side", Direction::text(deformation.side));
    text.put("from_mm", Millimeters::text(deformation.from)).put("to_mm", Millimeters::text(deformation.to));
    for (const NumberParameter& parameter : words.parameters) {
        const double value = deformation.*parameter.value;
        if (kFactor && parameter.value == &NumberDeformation::neutral)
            text.number("k_factor", *kFactor);
        else if (parameter.unit == NumberParameter::Unit::millimeters)
            text.put(parameter.key, Millimeters::text(value));
        else if (parameter.unit == NumberParameter::Unit::none)
            text.number(parameter.key, value);
        else if (NumberDeformation back; parameter.set(back, parameter.typed(deformation)), back.angle == value)
            text.number(parameter.key, parameter.typed(deformation));
        else
            text.number("angle_rad", value);
    }
    if (deformation.stays != 0)
        text.number("stays", deformation.stays);
    if (deformation.eases)
        text.put("eases", "true");
}

namespace {

/// ["x", "z"]
struct LockedAxes {
    static std::array<bool, 3> read(const JsonNode& node)
    {
        std::array<bool, 3> locked{};
        for (const JsonNode& item : node.items())
            locked[readChoice<std::size_t>(item, {{"x", 0}, {"y", 1}, {"z", 2}})] = true;
        return locked;
    }
    static std::string text(const std::array<bool, 3>& locked)
    {
        std::vector<std::string> names;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (locked[axis])
                names.emplace_back(axisNames[axis]);
        return listText(names, quoted);
    }
};

struct FaceNumbers {
    static std::vector<std::uint32_t> read(const JsonNode& node)
    {
        std::vector<std::uint32_t> faces;
        for (const JsonNode& face : node.items())
            faces.push_back(static_cast<std::uint32_t>(face.integer(0, std::numeric_limits<int>::max())));
        if (faces.empty())
            node.fail(Message("Recipe", "must hold at least one face."));
        return faces;
    }
    static std::string text(const std::vector<std::uint32_t>& faces)
    {
        return listText(faces, [](std::uint32_t face) { return std::to_string(face); });
    }
};

struct KeptItem : KeptFaces {};

template <class Fields>
void describeKeys(Fields& fields, KeptItem& kept)
{
    fields.needed("body", kept.body, Text{});
    fields.needed("faces", kept.faces, FaceNumbers{});
}

/// [3, 7] of the only part, or [{"body": "Lid", "faces": [3, 7]}].
struct FacesThatStay {
    const Context& context;
    std::vector<KeptFaces> read(const JsonNode& node) const
    {
        const std::vector<JsonNode> items = node.items();
        if (items.empty() || !items.front().isObject())
            return {{{}, FaceNumbers::read(node)}};
        std::vector<KeptFaces> kept;
        for (const JsonNode& item : items)
            kept.push_back(Object<KeptItem>{context}.read(item));
        return kept;
    }
    std::string text(const std::vector<KeptFaces>& kept) const
    {
        if (kept.size() == 1 && kept.front().body.empty())
            return FaceNumbers::text(kept.front().faces);
        return listText(kept, [this](const KeptFaces& faces) { return Object<KeptItem>{context}.text({faces}); });
    }
};

/// "Lid", or ["Lid", "Box"].
struct BodyNames {
    static std::vector<std::string> read(const JsonNode& node)
    {
        if (node.isString())
            return {node.text()};
        std::vector<std::string> names;
        for (const JsonNode& name : node.items())
            names.push_back(name.text());
        if (names.empty())
            node.fail(Message("Recipe", "must name at least one body."));
        return names;
    }
    static std::string text(const std::vector<std::string>& names)
    {
        return names.size() == 1 ? quoted(names.front()) : listText(names, quoted);
    }
};

struct StepNumber {
    static std::optional<std::size_t> read(const JsonNode& node)
    {
        return static_cast<std::size_t>(node.integer(0, mostFileSteps));
    }
    static std::string text(std::size_t step) { return std::to_string(step); }
};

/// A field with what else is said of it.
struct FieldItem : RecipeField {
    std::vector<std::string> bodies;
    bool isApart = false;
};

template <class Fields>
void describeKeys(Fields& fields, FieldItem& item)
{
    fields.needed("field", item.file, FilePath{fields.context});
    fields.optional("body", item.bodies, BodyNames{}, !item.bodies.empty());
    fields.optional("step", item.choice.step, StepNumber{});
    fields.optional("name", item.choice.name, Text{}, !item.choice.name.empty());
    fields.optional("unit", item.choice.unit, LengthUnitName{}, !item.choice.unit.empty());
    fields.optional("in_place", item.choice.isInPlace, Flag{}, item.choice.isInPlace);
    fields.optional("factor", item.factor, Number{-mostFieldFactor, mostFieldFactor});
    fields.optional("kept_faces", item.kept, FacesThatStay{fields.context}, !item.kept.empty());
    fields.optional("fade_mm", item.fade, PositiveMillimeters{}, item.fade > 0);
    fields.optional("locked", item.locked, LockedAxes{}, item.locked != std::array<bool, 3>{});
    fields.optional(apartKey, item.isApart, Flag{}, item.isApart);
    fields.check([&](const JsonNode& node) {
        if (item.kept.empty() != (item.fade == 0))
            node.fail(Message("Recipe", "must have both of the keys kept_faces and fade_mm, or none."));
    });
}

} // namespace

RecipeDeformation DeformationWords::read(const JsonNode& node) const
{
    if (node.find("field")) {
        const auto item = Object<FieldItem>{context}.read(node);
        return {.bodies = item.bodies, .what = static_cast<const RecipeField&>(item), .isApart = item.isApart};
    }
    RecipeDeformation deformation{
        .bodies = {}, .what = readNumbers(node, {"eases", "k_factor", apartKey}), .kFactor = readKFactor(node)};
    if (const auto bodies = node.find("body"))
        deformation.bodies = BodyNames::read(*bodies);
    if (const auto isApart = node.find(apartKey))
        deformation.isApart = isApart->boolean();
    return deformation;
}

std::string DeformationWords::text(const RecipeDeformation& deformation) const
{
    if (const auto* field = std::get_if<RecipeField>(&deformation.what)) {
        FieldItem item{*field, deformation.bodies, deformation.isApart};
        return Object<FieldItem>{context}.text(item);
    }
    ObjectText text;
    putNumbers(text, std::get<NumberDeformation>(deformation.what), deformation.kFactor);
    if (!deformation.bodies.empty())
        text.put("body", BodyNames::text(deformation.bodies));
    if (deformation.isApart)
        text.put(apartKey, "true");
    return text.take();
}

} // namespace knead::recipe_keys
