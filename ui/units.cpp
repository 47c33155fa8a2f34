#include "ui/units.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <numbers>
#include <span>
#include <vector>

namespace knead {

namespace {

struct Unit {
    const char* symbol;
    double scale;   ///< SI value of one unit
    bool displayed; ///< chosen for display; the others are understood when typed
};

constexpr Unit lengths[] = {{"mm", 1e-3, true},  {"m", 1, false},       {"cm", 1e-2, false},    {"µm", 1e-6, false},
                            {"um", 1e-6, false}, {"in", 0.0254, false}, {"inch", 0.0254, false}};
constexpr Unit pressures[] = {{"Pa", 1, true},    {"kPa", 1e3, true},    {"MPa", 1e6, true},
                              {"GPa", 1e9, true}, {"N/mm²", 1e6, false}, {"N/mm2", 1e6, false}};
constexpr Unit densities[] = {{"kg/m³", 1, true},    {"kg/m3", 1, false},   {"kg/m^3", 1, false},
                              {"g/cm³", 1e3, false}, {"g/cm3", 1e3, false}, {"g/cm^3", 1e3, false}};
constexpr Unit rates[] = {{"1/s", 1, true}, {"Hz", 1, false}};
constexpr Unit speeds[] = {{"mm/s", 1e-3, true}, {"m/s", 1, true}, {"cm/s", 1e-2, false}, {"in/s", 0.0254, false}};
constexpr Unit forces[] = {{"mN", 1e-3, true}, {"N", 1, true}, {"kN", 1e3, true}, {"MN", 1e6, true}};
constexpr Unit volumes[] = {
    {"mm³", 1e-9, true}, {"cm³", 1e-6, true}, {"m³", 1, false}, {"in³", 0.0254 * 0.0254 * 0.0254, false}};
constexpr Unit times[] = {
    {"µs", 1e-6, true}, {"us", 1e-6, false}, {"ms", 1e-3, true}, {"s", 1, true}, {"min", 60, false}};
constexpr Unit strains[] = {{"%", 1e-2, true}, {"‰", 1e-3, false}};
constexpr Unit areas[] = {
    {"mm²", 1e-6, true}, {"mm2", 1e-6, false},           {"cm²", 1e-4, true}, {"cm2", 1e-4, false}, {"m²", 1, false},
    {"m2", 1, false},    {"in²", 0.0254 * 0.0254, false}};
constexpr Unit angles[] = {
    {"°", std::numbers::pi / 180, true}, {"deg", std::numbers::pi / 180, false}, {"rad", 1, false}};
constexpr Unit masses[] = {{"mg", 1e-6, true}, {"g", 1e-3, true}, {"kg", 1, true}, {"t", 1e3, false}};
constexpr Unit accelerations[] = {{"m/s²", 1, true},      {"m/s2", 1, false},     {"m/s^2", 1, false},
                                  {"mm/s²", 1e-3, false}, {"mm/s2", 1e-3, false}, {"g", 9.80665, false}};
constexpr Unit stiffnesses[] = {{"N/mm", 1e3, true}, {"N/m", 1, false}, {"kN/m", 1e3, false}};
constexpr Unit toughnesses[] = {{"J/m²", 1, true},     {"J/m2", 1, false}, {"J/m^2", 1, false}, {"kJ/m²", 1e3, true},
                                {"kJ/m2", 1e3, false}, {"N/m", 1, false},  {"N/mm", 1e3, false}};
constexpr Unit numbers[] = {{"", 1, true}};

std::span<const Unit> unitsOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Length:
        return lengths;
    case Quantity::Pressure:
        return pressures;
    case Quantity::Density:
        return densities;
    case Quantity::Rate:
        return rates;
    case Quantity::Speed:
        return speeds;
    case Quantity::Force:
        return forces;
    case Quantity::Volume:
        return volumes;
    case Quantity::Time:
        return times;
    case Quantity::Strain:
        return strains;
    case Quantity::Area:
        return areas;
    case Quantity::Angle:
        return angles;
    case Quantity::Mass:
        return masses;
    case Quantity::Acceleration:
        return accelerations;
    case Quantity::Stiffness:
        return stiffnesses;
    case Quantity::Toughness:
        return toughnesses;
    case Quantity::Number:
        break;
    }
    return numbers;
}

/// Units that a person may have lengths in, with those that follow; null: the displayed ones.
struct LengthSystem {
    const char* length;
    const char* speed;
    const char* area;
    const char* volume;
};

constexpr LengthSystem systems[] = {{"mm", nullptr, nullptr, nullptr},
                                    {"cm", "cm/s", "cm²", "cm³"},
                                    {"m", "m/s", "m²", "m³"},
                                    {"in", "in/s", "in²", "in³"}};
std::atomic<const LengthSystem*> lengthSystem = systems; // tasks write numbers, too

/// How numbers are written in a language.
struct NumberStyle {
    const char* code;
    char16_t point; ///< before decimals
    char16_t group; ///< between thousands
};

constexpr NumberStyle numberStyles[] = {
    {"en", u'.', u','}, {"de", u',', u'.'}, {"fr", u',', u'\u202f'}, {"nl", u',', u'.'}};
std::atomic<const NumberStyle*> numberStyle = numberStyles; // tasks write numbers, too

/// The unit that was chosen for a quantity; null: none.
const Unit* chosenUnit(Quantity quantity)
{
    const LengthSystem& system = *lengthSystem.load();
    const char* symbol = quantity == Quantity::Length   ? (&system == systems ? nullptr : system.length)
                         : quantity == Quantity::Speed  ? system.speed
                         : quantity == Quantity::Area   ? system.area
                         : quantity == Quantity::Volume ? system.volume
                                                        : nullptr;
    if (symbol == nullptr)
        return nullptr;
    const std::span<const Unit> units = unitsOf(quantity);
    return &*std::ranges::find_if(units, [symbol](const Unit& unit) { return std::strcmp(unit.symbol, symbol) == 0; });
}

/// The unit zero is shown in: the plain one, not the smallest.
const Unit& unitOfZero(Quantity quantity)
{
    const std::span<const Unit> units = unitsOf(quantity);
    const bool startsSmall = quantity == Quantity::Force || quantity == Quantity::Time;
    if (quantity == Quantity::Mass)
        return units[1];
    return startsSmall ? *std::ranges::find(units, 1.0, &Unit::scale) : units.front();
}

/// The largest displayed unit that leaves at least one unit, the smallest one otherwise.
const Unit& displayUnit(double value, Quantity quantity)
{
    if (const Unit* chosen = chosenUnit(quantity))
        return *chosen;
    if (value == 0 || !std::isfinite(value))
        return unitOfZero(quantity);
    const std::span<const Unit> units = unitsOf(quantity);
    const Unit* best = &units.front();
    for (const Unit& unit : units)
        // The margin lets 0.9999999e6 Pa, which rounds to one megapascal, be shown as such.
        if (unit.displayed && std::abs(value) >= unit.scale * (1 - 1e-7))
            best = &unit;
    return *best;
}

const Unit* findUnit(const QString& symbol, Quantity quantity)
{
    const Unit* loose = nullptr;
    int looseMatches = 0;
    for (const Unit& unit : unitsOf(quantity)) {
        const QString name = QString::fromUtf8(unit.symbol);
        if (name == symbol)
            return &unit;
        if (name.compare(symbol, Qt::CaseInsensitive) == 0) {
            loose = &unit;
            ++looseMatches;
        }
    }
    return looseMatches == 1 ? loose : nullptr; // "mn" could be millinewton or meganewton
}

} // namespace

Quantity quantityOfUnit(const std::string& unit)
{
    if (unit == "Pa")
        return Quantity::Pressure;
    if (unit == "kg/m^3")
        return Quantity::Density;
    if (unit == "1/s")
        return Quantity::Rate;
    if (unit == "J/m^2")
        return Quantity::Toughness;
    if (unit == "m")
        return Quantity::Length;
    if (unit == "m/s")
        return Quantity::Speed;
    if (unit == "s")
        return Quantity::Time;
    if (unit == "N")
        return Quantity::Force;
    return Quantity::Number;
}

void setLengthUnit(const QString& symbol)
{
    for (const LengthSystem& system : systems)
        if (symbol == QLatin1String(system.length))
            lengthSystem = &system;
}

QString lengthUnit()
{
    return lengthSystem.load()->length;
}

void setNumberLanguage(const QString& code)
{
    for (const NumberStyle& style : numberStyles)
        if (code == QLatin1String(style.code))
            numberStyle = &style;
}

QString localNumber(QString number)
{
    return number.replace(QLatin1Char('.'), QChar(numberStyle.load()->point));
}

QString localNumber(double value, char format, int digits)
{
    return localNumber(QString::number(value, format, digits));
}

QString formatQuantity(double value, Quantity quantity)
{
    const Unit& unit = displayUnit(value, quantity);
    const QString number = localNumber(value / unit.scale, 'g', 5);
    const QString symbol = QString::fromUtf8(unit.symbol);
    const bool isClose = symbol.isEmpty() || symbol == QString::fromUtf8("°");
    return isClose ? number + symbol : number + ' ' + symbol;
}

QStringList unitsFor(Quantity quantity)
{
    QStringList symbols;
    std::vector<double> scales;
    for (const Unit& unit : unitsOf(quantity)) {
        if (std::ranges::find(scales, unit.scale) != scales.end() || *unit.symbol == '\0')
            continue; // another spelling
        scales.push_back(unit.scale);
        symbols << QString::fromUtf8(unit.symbol);
    }
    return symbols;
}

ShownUnit shownUnit(double value, Quantity quantity)
{
    const Unit& unit = displayUnit(value, quantity);
    return {QString::fromUtf8(unit.symbol), unit.scale};
}

QString formatReading(double value, Quantity quantity)
{
    constexpr double fineLength = 1e-5; // [m]; less would be millimetres with many zeros
    const double rounded = QString::number(value, 'g', 3).toDouble();
    const bool isFine = quantity == Quantity::Length && rounded != 0 && std::abs(rounded) < fineLength;
    if (isFine && chosenUnit(quantity) == nullptr)
        return localNumber(1e6 * rounded, 'g', 5) + QStringLiteral(" µm");
    return formatQuantity(rounded, quantity);
}

std::pair<QString, double> plainUnit(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Length:
        return {"mm", 1e-3};
    case Quantity::Volume:
        return {"mm³", 1e-9};
    case Quantity::Mass:
        return {"g", 1e-3};
    case Quantity::Angle:
        return {"°", 0.017453292519943295};
    default:
        return {QString(), 1};
    }
}

std::optional<double> parseQuantity(const QString& text, Quantity quantity, double shown)
{
    // Digits may be grouped by spaces; a comma or a point, never both, starts the decimals.
    static const QRegularExpression pattern(
        QStringLiteral(
            R"(^\s*([+-]?(?:\d+(?:\s\d{3})*(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?)\s*([^\s\d.,+-].*?|1/s)?\s*$)"),
        QRegularExpression::UseUnicodePropertiesOption);
    const QRegularExpressionMatch match = pattern.match(text);
    if (!match.hasMatch())
        return std::nullopt;

    QString digits = match.captured(1);
    digits.remove(QRegularExpression(QStringLiteral("\\s"))).replace(',', '.');
    bool ok = false;
    const double number = QLocale::c().toDouble(digits, &ok);
    if (!ok || !std::isfinite(number))
        return std::nullopt;

    const QString symbol = match.captured(2);
    const Unit* unit = symbol.isEmpty() ? &displayUnit(shown, quantity) : findUnit(symbol, quantity);
    if (unit == nullptr)
        return std::nullopt;
    return number * unit->scale;
}

QString formatChange(double share)
{
    constexpr double least = 5e-5;
    return std::abs(share) < least ? QStringLiteral("0 %") : localNumber(QString::asprintf("%+.2f %%", 100 * share));
}

QString formatCount(std::size_t count)
{
    QString digits = QString::number(static_cast<qulonglong>(count));
    constexpr qsizetype together = 3;
    for (qsizetype at = digits.size() - together; at > 0; at -= together)
        digits.insert(at, QChar(numberStyle.load()->group));
    return digits;
}

} // namespace knead
