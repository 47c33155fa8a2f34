#include "verify/record.h"

#include "verify/experiment.h"
#include "verify/part.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace knead::book {

namespace {

constexpr double noise = 0.01; // below this errors do not show an order

constexpr double allowedImbalance = 0.01; // of energy; more is told

std::string errorText(const Quantity& quantity, double error)
{
    char text[48];
    if (!std::isfinite(error))
        return "-";
    if (quantity.reference == 0)
        std::snprintf(text, sizeof text, "%.3g %s", error, quantity.unit.c_str());
    else
        std::snprintf(text, sizeof text, "%+.1f %%", 100 * error);
    return text;
}

} // namespace

Record record(const Case& what, const RecordOptions& options)
{
    const std::size_t count = what.quantities.size();
    Record record{.what = what, .cells = {what.cells}, .runs = {}, .calculix = {}};
    if (options.finer)
        for (const double times : what.finer)
            record.cells.push_back(times * what.cells);
    const auto complete = [&](Outcome outcome) {
        outcome.values.resize(count, std::numeric_limits<double>::quiet_NaN());
        return outcome;
    };
    if (options.calculix && what.calculix)
        record.calculix = complete(guarded(count, what.calculix));
    for (std::size_t q = 0; q < count; ++q)
        if (what.quantities[q].origin == Origin::calculix)
            record.what.quantities[q].reference =
                record.calculix.values.empty() ? std::numeric_limits<double>::quiet_NaN() : record.calculix.values[q];
    for (const double cells : record.cells)
        record.runs.push_back(complete(guarded(count, [&] { return what.run(cells); })));
    return record;
}

double orderOf(const Record& record, std::size_t quantity)
{
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    bool positive = false, negative = false, small = false;
    for (std::size_t r = 0; r < record.runs.size(); ++r) {
        const double error = errorOf(record.what.quantities[quantity], record.runs[r].values[quantity]);
        if (!std::isfinite(error))
            continue;
        positive = positive || error > 0;
        negative = negative || error < 0;
        small = small || std::abs(error) < noise;
        n += 1;
        x += std::log(record.cells[r]);
        y += std::log(std::abs(error));
        xx += std::pow(std::log(record.cells[r]), 2);
        xy += std::log(record.cells[r]) * std::log(std::abs(error));
    }
    if (n < 2 || small || (positive && negative))
        return std::numeric_limits<double>::quiet_NaN();
    return -(n * xy - x * y) / (n * xx - x * x);
}

bool holds(const Record& record, std::size_t quantity)
{
    return std::all_of(record.runs.begin(), record.runs.end(), [&](const Outcome& run) {
        return isWithin(record.what.quantities[quantity], run.values[quantity]);
    });
}

bool isAsExpected(const Record& record)
{
    if (!record.calculix.trouble.empty())
        return false;
    for (std::size_t q = 0; q < record.what.quantities.size(); ++q) {
        const Quantity& quantity = record.what.quantities[q];
        if (quantity.expected == Expected::holds && std::isfinite(quantity.reference) && !holds(record, q))
            return false;
    }
    return std::all_of(record.runs.begin(), record.runs.end(),
                       [](const Outcome& run) { return run.trouble.empty() && run.imbalance <= allowedImbalance; });
}

std::string tableHead()
{
    char line[240];
    std::snprintf(line, sizeof line, "%-30s %-22s %11s %11s  %-28s %5s %9s %8s %8s  %s", "case", "quantity",
                  "reference", "finest", "error, coarse to fine", "order", "tolerance", "Knead s", "ccx s", "");
    return line;
}

std::string tableOf(const Record& record)
{
    std::string table;
    double seconds = 0;
    for (const Outcome& run : record.runs)
        seconds += run.seconds;
    for (std::size_t q = 0; q < record.what.quantities.size(); ++q) {
        const Quantity& quantity = record.what.quantities[q];
        std::string errors;
        for (const Outcome& run : record.runs)
            errors += (errors.empty() ? "" : ", ") + errorText(quantity, errorOf(quantity, run.values[q]));
        const double finest = record.runs.back().values[q];
        const double order = orderOf(record, q);
        const bool isGood = holds(record, q);
        const bool expected = quantity.expected == Expected::holds;
        const char* verdict = !std::isfinite(quantity.reference) ? "not judged without CalculiX"
                              : isGood && expected               ? "holds"
                              : isGood                           ? "holds (not expected yet)"
                              : expected                         ? "MISSED"
                                                                 : "missed (as known)";
        char line[400];
        std::snprintf(
            line, sizeof line, "%-30s %-22s %11.4g %11.4g  %-28s %5s %8.3g%s %8.1f %8s  %s\n",
            q == 0 ? record.what.id.c_str() : "", (quantity.name + " " + quantity.unit).c_str(), quantity.reference,
            finest, errors.c_str(), std::isfinite(order) ? std::to_string(order).substr(0, 4).c_str() : "-",
            quantity.reference == 0 ? quantity.tolerance : 100 * quantity.tolerance,
            quantity.reference == 0 ? " " : "%", seconds,
            record.calculix.seconds > 0 ? std::to_string(record.calculix.seconds).substr(0, 5).c_str() : "-", verdict);
        table += line;
    }
    for (const Outcome& run : record.runs)
        if (!run.trouble.empty())
            table += "    " + run.trouble + "\n";
    double imbalance = 0;
    for (const Outcome& run : record.runs)
        imbalance = std::max(imbalance, run.imbalance);
    if (imbalance > allowedImbalance)
        table += "    imbalance of energy " + std::to_string(100 * imbalance).substr(0, 5) + " %\n";
    if (!record.calculix.trouble.empty())
        table += "    " + record.calculix.trouble + "\n";
    return table;
}

} // namespace knead::book
