#include "verify/page.h"

#include "verify/picture.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace knead::book {

namespace {

std::string number(double value, const char* pattern = "%.4g")
{
    if (!std::isfinite(value))
        return "&ndash;";
    char text[48];
    std::snprintf(text, sizeof text, pattern, value);
    return text;
}

const char* nameOf(Origin origin)
{
    return origin == Origin::closedForm ? "formula" : origin == Origin::calculix ? "CalculiX" : "published";
}

/// The color of a row says whether all runs are within the tolerance.
const char* verdictOf(const Record& record, std::size_t q)
{
    if (!std::isfinite(record.what.quantities[q].reference))
        return "known"; // CalculiX was not run
    return holds(record, q) ? "holds" : record.what.quantities[q].expected == Expected::holds ? "missed" : "known";
}

std::string rowsOf(const Record& record)
{
    std::string rows;
    for (std::size_t q = 0; q < record.what.quantities.size(); ++q) {
        const Quantity& quantity = record.what.quantities[q];
        rows += "<tr class='" + std::string(verdictOf(record, q)) + "'><td>" + escaped(quantity.name) +
                (quantity.unit.empty() ? "" : " [" + escaped(quantity.unit) + "]") + "</td><td>" +
                number(quantity.reference) + "</td><td>" + nameOf(quantity.origin) + "</td>";
        for (const Outcome& run : record.runs) {
            const double error = errorOf(quantity, run.values[q]);
            rows += "<td>" + number(run.values[q]) +
                    (quantity.reference == 0 ? "" : " <small>" + number(100 * error, "%+.1f") + "&nbsp;%</small>") +
                    "</td>";
        }
        const double calculix = record.calculix.values.empty() ? std::nan("") : record.calculix.values[q];
        rows += "<td>" + number(orderOf(record, q), "%.1f") + "</td><td>" +
                (quantity.reference == 0 ? number(quantity.tolerance)
                                         : number(100 * quantity.tolerance, "%.3g") + "&nbsp;%") +
                "</td><td>" + number(calculix) + "</td></tr>\n";
    }
    return rows;
}

std::string sectionOf(const Record& record)
{
    const Case& what = record.what;
    std::string text = "<section id='" + what.id + "'><h3>" + escaped(what.title) + "</h3><p>" + escaped(what.source) +
                       "</p>\n<table><tr><th></th><th>reference</th><th>from</th>";
    for (std::size_t r = 0; r < record.runs.size(); ++r) {
        const Outcome& run = record.runs[r];
        text += "<th>" + number(record.cells[r], "%.3g") + " cells<br><small>" + number(1000 * run.spacing, "%.3g") +
                " mm, " + std::to_string(run.objects) + "<br>" + number(run.seconds, "%.2f") + " s</small></th>";
    }
    text += "<th>order</th><th>tolerance</th><th>CalculiX<br><small>" +
            (record.calculix.seconds > 0 ? std::to_string(record.calculix.objects) + " nodes<br>" +
                                               number(record.calculix.seconds, "%.2f") + " s"
                                         : std::string("not run")) +
            "</small></th></tr>\n" + rowsOf(record) + "</table>\n";
    for (const Outcome& run : record.runs)
        if (!run.trouble.empty())
            text += "<p class='trouble'>" + escaped(run.trouble) + "</p>\n";
    if (!record.calculix.trouble.empty())
        text += "<p class='trouble'>" + escaped(record.calculix.trouble) + "</p>\n";
    double imbalance = 0;
    for (const Outcome& run : record.runs)
        imbalance = std::max(imbalance, run.imbalance);
    text += "<p><small>Cells across " + escaped(what.across) + ". Imbalance of energy at most " +
            number(100 * imbalance, "%.2g") + " %.</small></p>\n<div class='pictures'>";
    std::vector<Curve> errors;
    for (std::size_t q = 0; q < what.quantities.size(); ++q) {
        errors.push_back({what.quantities[q].name, {}});
        for (std::size_t r = 0; r < record.runs.size(); ++r)
            errors.back().points.push_back(
                {record.cells[r], std::abs(errorOf(what.quantities[q], record.runs[r].values[q]))});
    }
    text += shadedSvg(record.runs.back().picture) + convergenceSvg(errors) +
            curvesSvg(record.runs.back().curves, record.runs.back().curveAxes);
    return text + "</div></section>\n";
}

std::string summaryOf(const std::vector<Record>& records)
{
    std::size_t quantities = 0, within = 0, known = 0, published = 0;
    double kneadSeconds = 0, calculixSeconds = 0;
    for (const Record& record : records) {
        bool measured = false;
        for (std::size_t q = 0; q < record.what.quantities.size(); ++q) {
            const Quantity& quantity = record.what.quantities[q];
            const bool isGood = holds(record, q);
            ++quantities;
            within += isGood ? 1 : 0;
            known += !isGood && (quantity.expected == Expected::notYet || !std::isfinite(quantity.reference)) ? 1 : 0;
            measured = measured || quantity.origin == Origin::measured;
        }
        published += measured ? 1 : 0;
        for (const Outcome& run : record.runs)
            kneadSeconds += run.seconds;
        calculixSeconds += record.calculix.seconds;
    }
    return "<p>" + std::to_string(records.size()) + " cases, " + std::to_string(published) +
           " of them with published measurements or rules of design. Of " + std::to_string(quantities) + " numbers " +
           std::to_string(within) + " are within their tolerance at every spacing, " + std::to_string(known) +
           " miss it as known or wait for CalculiX, " + std::to_string(quantities - within - known) +
           " miss it unexpectedly. Processor time: Knead " + number(kneadSeconds, "%.0f") + " s, CalculiX " +
           number(calculixSeconds, "%.0f") + " s.</p>\n";
}

std::string contentsOf(const std::vector<Record>& records)
{
    std::string text = "<table class='contents'><tr><th>case</th><th>number</th><th>reference</th><th>finest</th>"
                       "<th>error</th><th>tolerance</th></tr>\n";
    std::string group;
    for (const Record& record : records) {
        if (record.what.group != group)
            text += "<tr><th colspan='6'>" + escaped(group = record.what.group) + "</th></tr>\n";
        for (std::size_t q = 0; q < record.what.quantities.size(); ++q) {
            const Quantity& quantity = record.what.quantities[q];
            const double value = record.runs.back().values[q];
            text += "<tr class='" + std::string(verdictOf(record, q)) + "'><td>" +
                    (q == 0 ? "<a href='#" + record.what.id + "'>" + escaped(record.what.title) + "</a>" : "") +
                    "</td><td>" + escaped(quantity.name) + "</td><td>" + number(quantity.reference) + " " +
                    escaped(quantity.unit) + "</td><td>" + number(value) + "</td><td>" +
                    (quantity.reference == 0 ? "" : number(100 * errorOf(quantity, value), "%+.1f") + "&nbsp;%") +
                    "</td><td>" +
                    (quantity.reference == 0 ? number(quantity.tolerance)
                                             : number(100 * quantity.tolerance, "%.3g") + "&nbsp;%") +
                    "</td></tr>\n";
        }
    }
    return text + "</table>\n";
}

} // namespace

std::string htmlOf(const std::vector<Record>& records)
{
    std::string page =
        R"(<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>Knead: book of verification</title>
<style>
body{font:15px/1.45 sans-serif;max-width:1100px;margin:2em auto;padding:0 1em;color:#222}
table{border-collapse:collapse;font-size:13px}td,th{border:1px solid #ccc;padding:3px 7px;text-align:right;vertical-align:top}
td:first-child,th{text-align:left}small{color:#555}.pictures{display:flex;flex-wrap:wrap;gap:10px}
tr.holds{background:#e6f4e6}tr.known{background:#fdf3d8}tr.missed{background:#f9d9d5}.trouble{color:#a02010}
section{border-top:1px solid #ddd;margin-top:1.5em}h2{margin-top:2em}
</style></head><body><h1>Knead: book of verification</h1>
)";
    page += summaryOf(records);
    page += "<p>Green: within the tolerance at every spacing. Yellow: not, as known. Red: not, unexpectedly. The "
            "first "
            "spacing of each case is its default, the others are finer.</p>\n";
    page += contentsOf(records);
    std::string group;
    for (const Record& record : records) {
        if (record.what.group != group)
            page += "<h2>" + escaped(group = record.what.group) + "</h2>\n";
        page += sectionOf(record);
    }
    return page + "</body></html>\n";
}

std::string jsonOf(const std::vector<Record>& records)
{
    const auto orNull = [](double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(); };
    nlohmann::json cases = nlohmann::json::array();
    for (const Record& record : records) {
        nlohmann::json quantities = nlohmann::json::array();
        for (std::size_t q = 0; q < record.what.quantities.size(); ++q) {
            const Quantity& quantity = record.what.quantities[q];
            nlohmann::json values = nlohmann::json::array();
            nlohmann::json errors = nlohmann::json::array();
            for (const Outcome& run : record.runs) {
                values.push_back(orNull(run.values[q]));
                errors.push_back(orNull(errorOf(quantity, run.values[q])));
            }
            quantities.push_back(
                {{"name", quantity.name},
                 {"unit", quantity.unit},
                 {"reference", orNull(quantity.reference)},
                 {"reference_from", nameOf(quantity.origin)},
                 {"tolerance", quantity.tolerance},
                 {"values", values},
                 {"errors", errors},
                 {"order", orNull(orderOf(record, q))},
                 {"calculix", record.calculix.values.empty() ? nlohmann::json() : orNull(record.calculix.values[q])},
                 {"holds", holds(record, q)},
                 {"expected_to_hold", quantity.expected == Expected::holds}});
        }
        nlohmann::json runs = nlohmann::json::array();
        for (std::size_t r = 0; r < record.runs.size(); ++r)
            runs.push_back({{"cells_across", record.cells[r]},
                            {"spacing_m", record.runs[r].spacing},
                            {"objects", record.runs[r].objects},
                            {"seconds", record.runs[r].seconds},
                            {"imbalance", orNull(record.runs[r].imbalance)},
                            {"trouble", record.runs[r].trouble}});
        cases.push_back({{"id", record.what.id},
                         {"group", record.what.group},
                         {"title", record.what.title},
                         {"source", record.what.source},
                         {"quantities", quantities},
                         {"runs", runs},
                         {"calculix_seconds", record.calculix.seconds},
                         {"calculix_nodes", record.calculix.objects},
                         {"calculix_trouble", record.calculix.trouble}});
    }
    return nlohmann::json{{"cases", cases}}.dump(1);
}

} // namespace knead::book
