#include "core/model/length_units.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace knead {

namespace {

const std::vector<LengthUnit>& units()
{
    static const std::vector<LengthUnit> all{
        {"mm", Message("Unit", "millimetres"), 1e-3}, {"m", Message("Unit", "metres"), 1},
        {"inch", Message("Unit", "inches"), 0.0254},  {"cm", Message("Unit", "centimetres"), 1e-2},
        {"ft", Message("Unit", "feet"), 0.3048},      {"um", Message("Unit", "micrometres"), 1e-6},
        {"dm", Message("Unit", "decimetres"), 0.1},   {"mil", Message("Unit", "thousandths of an inch"), 2.54e-5},
        {"nm", Message("Unit", "nanometres"), 1e-9},  {"km", Message("Unit", "kilometres"), 1e3},
        {"mile", Message("Unit", "miles"), 1609.344}, {"uinch", Message("Unit", "millionths of an inch"), 2.54e-8},
    };
    return all;
}

struct Spelling {
    std::string_view text; ///< lower case
    std::string_view name;
};
constexpr std::array spellings{
    Spelling{"in", "inch"},         Spelling{"inches", "inch"},  Spelling{"\"", "inch"},
    Spelling{"foot", "ft"},         Spelling{"feet", "ft"},      Spelling{"'", "ft"},
    Spelling{"\xC2\xB5m", "um"},    Spelling{"\xCE\xBCm", "um"}, Spelling{"micron", "um"},
    Spelling{"microns", "um"},      Spelling{"thou", "mil"},     Spelling{"mils", "mil"},
    Spelling{"microinch", "uinch"}, Spelling{"uin", "uinch"},    Spelling{"mi", "mile"},
    Spelling{"miles", "mile"},
};

std::string lowerCase(std::string_view text)
{
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    return lower;
}

/// "millimetre", "millimeter", "millimetres" and "millimeters" are all "millimetres".
std::string britishPlural(std::string text)
{
    if (const std::size_t end = text.rfind("meter"); end != std::string::npos)
        text.replace(end, 5, "metre");
    return text.ends_with("metre") ? text + "s" : text;
}

Box scaled(const Box& box, double factor)
{
    return box.isEmpty() ? box : Box(factor * box.min(), factor * box.max());
}

void scalePart(Part& part, double factor)
{
    for (Vec3& vertex : part.mesh.vertices)
        vertex *= factor;
    for (std::vector<Vec3>& line : part.openEdges)
        for (Vec3& point : line)
            point *= factor;
    part.box = scaled(part.box, factor);
    part.area *= factor * factor;
    part.volume *= factor * factor * factor;
    part.maxTolerance *= factor;
    if (part.exact)
        part.exact->unit *= factor;
}

/// @param unknown says that it is not known
const LengthUnit& known(std::string_view text, const Message& unknown)
{
    const LengthUnit* unit = findLengthUnit(text);
    if (unit == nullptr)
        throw Problem(unknown.with(text, lengthUnitNames()));
    return *unit;
}

} // namespace

std::span<const LengthUnit> lengthUnits()
{
    return units();
}

const LengthUnit* findLengthUnit(std::string_view text)
{
    std::string name = lowerCase(text);
    const auto spelling = std::ranges::find(spellings, name, &Spelling::text);
    if (spelling != spellings.end())
        name = spelling->name;
    const std::string plural = britishPlural(name);
    const auto unit = std::ranges::find_if(
        units(), [&](const LengthUnit& one) { return one.name == name || one.plural.text() == plural; });
    return unit == units().end() ? nullptr : &*unit;
}

std::string lengthUnitNames()
{
    std::string names;
    for (const LengthUnit& unit : units())
        names += (names.empty() ? "" : ", ") + std::string(unit.name);
    return names;
}

Message noUnitStated(const std::string& file)
{
    return Message("Unit", "%1: the file states no length unit; millimetres were taken.").with(file);
}

void scaleModel(Model& model, double factor)
{
    for (Part& part : model.parts)
        scalePart(part, factor);
}

Model takenIn(Model model, std::string_view unit)
{
    const LengthUnit& wanted =
        known(unit, Message("Unit", "the length unit \"%1\" that was asked for is not known; known are %2."));
    const LengthUnit& taken = known(model.unit.empty() ? "mm" : model.unit,
                                    Message("Unit", "the length unit \"%1\" of the file is not known; known are %2."));
    scaleModel(model, wanted.metres / taken.metres);
    model.unit = wanted.name;
    model.unitRemark.reset();
    // Those of earlier versions are texts.
    const std::string settled = noUnitStated({}).english();
    std::erase_if(model.warnings, [&](const Message& warning) { return warning.english().ends_with(settled); });
    return model;
}

} // namespace knead
