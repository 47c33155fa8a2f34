#include "app/commands/deformation_arguments.h"

#include "core/message/message.h"
#include "core/model/length_units.h"

#include <CLI/CLI.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>

namespace knead {

namespace {

constexpr double mmInMetres = 1e-3;
constexpr double degreeInRadians = std::numbers::pi / 180;

/// How a deformation is said so far: as one by number and as one of a field, of which it will be one.
struct WishInWords {
    NumberWish number;
    FieldWish field;
    enum class Of { all, number, field } of = Of::all;
};

/// A value of an option, as a person typed it.
struct TypedValue {
    std::string option;
    std::string text;

    [[noreturn]] void fail(const std::string& wanted) const
    {
        throw Problem(Message("Deformation", "%1 takes %2; this is \"%3\".").with(option, wanted, text));
    }

    double number() const
    {
        double value = 0;
        const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
        const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
            fail("a number");
        return value;
    }

    double millimetres() const { return mmInMetres * number(); }

    Vec3 numbers() const
    {
        std::vector<double> values;
        std::stringstream stream(text);
        for (std::string one; std::getline(stream, one, ',');)
            values.push_back(TypedValue{option, one}.number());
        if (values.size() != 3 || text.ends_with(','))
            fail("three numbers with commas between them, as 10,0,2.5");
        return {values[0], values[1], values[2]};
    }

    /// "x", "-y", or three numbers.
    Vec3 direction() const
    {
        const bool isBack = text.starts_with('-');
        const std::string name = text.substr(isBack || text.starts_with('+') ? 1 : 0);
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            if (name == std::string(1, "xyz"[axis]))
                return (isBack ? -1.0 : 1.0) * Vec3::Unit(axis);
        if (text.find(',') == std::string::npos)
            fail("x, y, z, or three numbers with commas between them");
        return numbers();
    }

    std::array<bool, 3> locks() const
    {
        std::array<bool, 3> locked{};
        std::stringstream stream(text);
        for (std::string one; std::getline(stream, one, ',');) {
            if (one.size() != 1 || one[0] < 'x' || one[0] > 'z')
                fail("some of x, y, z with commas between them");
            locked.at(static_cast<std::size_t>(one[0] - 'x')) = true;
        }
        return locked;
    }

    /// A whole number from `first`, as one from 0.
    std::size_t count(int first, const char* wanted) const
    {
        const double value = number();
        if (value < first || value > 1e9 || value != std::floor(value))
            fail(wanted);
        return static_cast<std::size_t>(value) - static_cast<std::size_t>(first);
    }

    std::string unit() const
    {
        const LengthUnit* known = findLengthUnit(text);
        if (known == nullptr)
            fail("one of " + lengthUnitNames());
        return known->name;
    }
};

using WordIsOf = WishInWords::Of;

/// A word of the command line.
struct DeformationWord {
    const char* name;
    const char* type; ///< of its value; empty: none
    const char* help;
    WordIsOf of;  ///< what it may be said of
    bool isBegin; ///< of a deformation
    void (*apply)(WishInWords&, const TypedValue&);
};

template <NumberKind kind, typename Read>
void begin(WishInWords& wish, Read&& read)
{
    wish.number.kind = kind;
    wish.number.amount = read();
}

const std::array deformationWords{
    DeformationWord{"--field", "FILE", "Deform by a field: results of a simulation, a table, a project, or a scan",
                    WordIsOf::field, true, [](WishInWords& w, const TypedValue& v) { w.field.path = v.text; }},
    DeformationWord{"--bend", "DEG", "Bend into an arc, toward the side", WordIsOf::number, true,
                    [](WishInWords& w, const TypedValue& v) {
                        begin<NumberKind::bend>(w, [&] { return degreeInRadians * v.number(); });
                    }},
    DeformationWord{"--twist", "DEG", "Twist about the axis", WordIsOf::number, true,
                    [](WishInWords& w, const TypedValue& v) {
                        begin<NumberKind::twist>(w, [&] { return degreeInRadians * v.number(); });
                    }},
    DeformationWord{
        "--taper", "FACTOR", "Let cross-sections grow or shrink to so much at the second plane", WordIsOf::number, true,
        [](WishInWords& w, const TypedValue& v) { begin<NumberKind::taper>(w, [&] { return v.number(); }); }},
    DeformationWord{
        "--stretch", "FACTOR", "Make it so many times as long between the planes", WordIsOf::number, true,
        [](WishInWords& w, const TypedValue& v) { begin<NumberKind::stretch>(w, [&] { return v.number(); }); }},
    DeformationWord{
        "--shear", "MM", "Move cross-sections sideways, by so much at the second plane", WordIsOf::number, true,
        [](WishInWords& w, const TypedValue& v) { begin<NumberKind::shear>(w, [&] { return v.millimetres(); }); }},
    DeformationWord{
        "--scale", "FACTOR", "Taper and stretch alike", WordIsOf::number, true,
        [](WishInWords& w, const TypedValue& v) { begin<NumberKind::scale>(w, [&] { return v.number(); }); }},
    DeformationWord{"--axis", "DIRECTION", "x, y, z or dx,dy,dz; without it along the longest side of the parts",
                    WordIsOf::number, false,
                    [](WishInWords& w, const TypedValue& v) { w.number.axis = v.direction(); }},
    DeformationWord{"--side", "DIRECTION", "Toward which it bends or shears, across the axis; without it z, or x",
                    WordIsOf::number, false,
                    [](WishInWords& w, const TypedValue& v) { w.number.side = v.direction(); }},
    DeformationWord{"--origin", "X,Y,Z",
                    "A place of the axis in mm; without it in the middle of the parts, and at 0 along the axis",
                    WordIsOf::number, false,
                    [](WishInWords& w, const TypedValue& v) { w.number.origin = mmInMetres * v.numbers(); }},
    DeformationWord{
        "--from", "MM", "Where the first plane crosses the axis, from its origin; without it where the parts begin",
        WordIsOf::number, false, [](WishInWords& w, const TypedValue& v) { w.number.from = v.millimetres(); }},
    DeformationWord{"--to", "MM", "Where the second plane crosses the axis; without it where the parts end",
                    WordIsOf::number, false,
                    [](WishInWords& w, const TypedValue& v) { w.number.to = v.millimetres(); }},
    DeformationWord{
        "--radius", "MM", "Of a bend, in place of the second plane: that of the plane that keeps its length",
        WordIsOf::number, false, [](WishInWords& w, const TypedValue& v) { w.number.radius = v.millimetres(); }},
    DeformationWord{"--neutral", "MM", "Of a bend: the plane that keeps its length, toward the side from the origin",
                    WordIsOf::number, false,
                    [](WishInWords& w, const TypedValue& v) { w.number.neutral = v.millimetres(); }},
    DeformationWord{"--k-factor", "K", "Of a bend: where that plane lies in the thickness, 0 inside to 1 outside",
                    WordIsOf::number, false,
                    [](WishInWords& w, const TypedValue& v) { w.number.kFactor = v.number(); }},
    DeformationWord{"--stays", "SHARE", "What stays where it is: 0 the first plane, 1 the second one, 0.5 the middle",
                    WordIsOf::number, false, [](WishInWords& w, const TypedValue& v) { w.number.stays = v.number(); }},
    DeformationWord{"--ease", "", "Begin and end gently at the planes", WordIsOf::number, false,
                    [](WishInWords& w, const TypedValue&) { w.number.eases = true; }},
    DeformationWord{
        "--step", "N", "Step of the field, from 1; without it the last one", WordIsOf::field, false,
        [](WishInWords& w, const TypedValue& v) { w.field.choice.step = v.count(1, "the number of a step, from 1"); }},
    DeformationWord{"--entry", "N",
                    "Of a project, in place of a step: the entry of its history; without it the present one",
                    WordIsOf::field, false,
                    [](WishInWords& w, const TypedValue& v) {
                        w.field.choice.step = v.count(0, "the number of an entry, from 0");
                    }},
    DeformationWord{"--component", "NAME", "Which vectors of the file; without it the displacements", WordIsOf::field,
                    false, [](WishInWords& w, const TypedValue& v) { w.field.choice.name = v.text; }},
    DeformationWord{
        "--field-unit", "UNIT", "Length unit of the field, whatever its file says; files that say nothing are in mm",
        WordIsOf::field, false, [](WishInWords& w, const TypedValue& v) { w.field.choice.unit = v.unit(); }},
    DeformationWord{"--in-place", "",
                    "Of a scan: it has the axes of the part; without it, it is laid over the part first",
                    WordIsOf::field, false, [](WishInWords& w, const TypedValue&) { w.field.choice.isInPlace = true; }},
    DeformationWord{"--factor", "F", "So many times the field; -1 for the other way", WordIsOf::field, false,
                    [](WishInWords& w, const TypedValue& v) { w.field.factor = v.number(); }},
    DeformationWord{"--keep-faces", "FACES",
                    "CAD faces that stay exactly where they are, from 0: 3,7,12, or Lid:3,7 of a part", WordIsOf::field,
                    false, [](WishInWords& w, const TypedValue& v) { w.field.kept.push_back(v.text); }},
    DeformationWord{"--fade", "MM",
                    "Over which the field fades toward these; without it a tenth of the size of the parts",
                    WordIsOf::field, false,
                    [](WishInWords& w, const TypedValue& v) {
                        w.field.fade = v.millimetres();
                        if (!(*w.field.fade > 0))
                            v.fail("a length above 0");
                    }},
    DeformationWord{"--lock", "AXES", "Along which nothing moves: some of x, y, z with commas between them",
                    WordIsOf::field, false, [](WishInWords& w, const TypedValue& v) { w.field.locked = v.locks(); }},
};

} // namespace

struct DeformationArguments::Words {
    CLI::App& command;
    std::map<const CLI::Option*, std::size_t> byOption{}; ///< numbers of deformationWords
};

DeformationArguments::DeformationArguments(CLI::App& command)
{
    auto all = std::make_unique<Words>(Words{command});
    for (std::size_t i = 0; i < deformationWords.size(); ++i) {
        const DeformationWord& word = deformationWords[i];
        const bool isFlag = std::string(word.type).empty();
        CLI::Option* option =
            isFlag ? command.add_flag(word.name, word.help) : command.add_option(word.name)->type_name(word.type);
        option->description(word.help)->group(word.isBegin ? "Deformations, in the order given"
                                              : word.of == WordIsOf::number
                                                  ? "Of bend, twist, taper, stretch, shear and scale"
                                                  : "Of a field");
        if (!isFlag)
            option->expected(1)->allow_extra_args(false);
        option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
        all->byOption.emplace(option, i);
    }
    m_words = std::move(all);
}

DeformationArguments::~DeformationArguments() = default;

std::vector<DeformationWish> DeformationArguments::wishes() const
{
    std::vector<WishInWords> all(1); // the first one is what is said before any
    std::map<const CLI::Option*, std::size_t> count;
    for (const CLI::Option* option : m_words->command.parse_order()) {
        const auto found = m_words->byOption.find(option);
        if (found == m_words->byOption.end())
            continue;
        const DeformationWord& word = deformationWords[found->second];
        const TypedValue value{word.name, option->results().at(count[option]++)};
        if (word.isBegin) {
            all.push_back(all.front());
            all.back().of = word.of;
        }
        if (all.size() > 1 && all.back().of != word.of)
            throw Problem(Message("Deformation", "%1 says nothing about what stands before it; put it behind the "
                                                 "deformation that it is for.")
                              .with(word.name));
        word.apply(all.back(), value);
    }
    std::vector<DeformationWish> wishes;
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i].of == WordIsOf::field)
            wishes.emplace_back(std::move(all[i].field));
        else
            wishes.emplace_back(std::move(all[i].number));
    return wishes;
}

} // namespace knead
