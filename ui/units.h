#pragma once

#include "core/model/quantity.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <string>
#include <utility>

namespace knead {

/// The quantity measured in an SI unit as MaterialField spells it: "Pa", "kg/m^3", "1/s"; Number for anything else.
Quantity quantityOfUnit(const std::string& unit);

/// Has lengths shown in another unit: "mm" as it comes, "cm", "m" or "in". Speeds and volumes follow.
void setLengthUnit(const QString& symbol);
QString lengthUnit();

/// Has numbers written as people of a language do: "en" as it comes, "de", "fr" or "nl". Any thread.
void setNumberLanguage(const QString& code);
/// A number written with a point, as the language has it: "2,5" in German.
QString localNumber(QString number);
QString localNumber(double value, char format, int digits);

/// A number with a unit that keeps it short: 1.2e6 Pa becomes "1.2 MPa".
QString formatQuantity(double value, Quantity quantity);

/// The same with three digits, for readings that change all the time. Lengths below 10 µm are in micrometres.
QString formatReading(double value, Quantity quantity);

/// The units in which a quantity may be typed, each once: "mm", "m", "cm", "µm", "in".
QStringList unitsFor(Quantity quantity);

/// The unit in which a number is shown, for several numbers that share one, as on an axis.
struct ShownUnit {
    QString symbol;   ///< empty for pure numbers
    double scale = 1; ///< SI value of one unit
};
ShownUnit shownUnit(double value, Quantity quantity);

/// In one unit per quantity, whatever the size: what a spreadsheet can add up.
std::pair<QString, double> plainUnit(Quantity quantity);

/// Reads a number with or without a unit: "1,2 MPa", "1.2e6 Pa", "2 000". Point and comma both are decimal separators.
/// A bare number takes the unit in which `shown` is displayed, since that is what the person sees in the field.
/// @param shown the value now in the field (SI)
/// @return SI; empty when the text is not a number of this quantity
std::optional<double> parseQuantity(const QString& text, Quantity quantity, double shown = 0);

/// "-0.14 %"; no sign where rounding leaves nothing. @param share 0.01 is 1 %
QString formatChange(double share);

/// "12,345": whole numbers with separators, "12.345" in German.
QString formatCount(std::size_t count);

} // namespace knead
