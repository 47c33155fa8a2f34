#include "bench/paper_report.h"

#include "bench/growth_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <functional>
#include <ostream>
#include <sstream>

namespace knead {

namespace {

// The paper reads its growth off at 3500 and 7000 objects; these are the multiples of 425 next to them.
constexpr std::size_t publishedFrom = 3400;
constexpr std::size_t publishedTo = 2 * publishedFrom;

using Property = double PaperMeasurement::*;

std::optional<double> growth(const PaperReport& report, VicinityMethod method, std::size_t objects, Property property)
{
    const PaperMeasurement* one = report.find(method, objects / 2);
    const PaperMeasurement* twice = report.find(method, objects);
    if (objects % 2 != 0 || one == nullptr || twice == nullptr || !(one->*property > 0))
        return {};
    return twice->*property / one->*property;
}

/// Over all doublings: the n-th root of the whole growth.
std::optional<double> meanGrowth(const PaperReport& report, VicinityMethod method, Property property)
{
    double product = 1;
    int doublings = 0;
    for (const PaperMeasurement& measurement : report.measurements)
        if (measurement.method == method)
            if (const auto factor = growth(report, method, measurement.objects, property)) {
                product *= *factor;
                ++doublings;
            }
    if (doublings == 0)
        return {};
    return std::pow(product, 1.0 / doublings);
}

/// As printf.
__attribute__((format(printf, 1, 2))) std::string text(const char* format, ...)
{
    char line[512];
    va_list values;
    va_start(values, format);
    std::vsnprintf(line, sizeof line, format, values);
    va_end(values);
    return line;
}

std::string factorOrDash(const std::optional<double>& factor)
{
    return factor ? text("%.2f", *factor) : "-";
}

std::string factorOrNull(const std::optional<double>& factor)
{
    return factor ? text("%.4f", *factor) : "null";
}

std::string name(VicinityMethod method)
{
    return std::string(nameOf(method));
}

/// A function of n through the point of a measurement, at the numbers of objects measured.
PlotCurve reference(const std::string& label, const std::string& color, const std::vector<double>& objects,
                    const PaperMeasurement& through, const std::function<double(double)>& function)
{
    PlotCurve curve{.label = label, .color = color};
    const double scale = 1e3 * through.system / function(static_cast<double>(through.objects));
    for (const double n : objects)
        curve.points.push_back({n, scale * function(n)});
    return curve;
}

PlotCurve measured(const PaperReport& report, VicinityMethod method, const std::string& color, PlotMarker marker)
{
    PlotCurve curve{.label = name(method), .color = color, .marker = marker};
    for (const PaperMeasurement& measurement : report.measurements)
        if (measurement.method == method)
            curve.points.push_back({static_cast<double>(measurement.objects), 1e3 * measurement.system});
    return curve;
}

} // namespace

const PaperMeasurement* PaperReport::find(VicinityMethod method, std::size_t objects) const
{
    const auto found = std::find_if(measurements.begin(), measurements.end(), [&](const PaperMeasurement& m) {
        return m.method == method && m.objects == objects;
    });
    return found == measurements.end() ? nullptr : &*found;
}

std::vector<PaperGrowth> growthOf(const PaperReport& report)
{
    std::vector<PaperGrowth> result;
    for (const VicinityMethod method : vicinityMethods) {
        PaperGrowth row{.method = method};
        if (method == VicinityMethod::halfPartition)
            row.published = 2.25;
        if (method == VicinityMethod::medianPartition)
            row.published = 3.0;
        row.timeThere = growth(report, method, publishedTo, &PaperMeasurement::system);
        row.testsThere = growth(report, method, publishedTo, &PaperMeasurement::sphereTests);
        row.meanTime = meanGrowth(report, method, &PaperMeasurement::system);
        row.meanTests = meanGrowth(report, method, &PaperMeasurement::sphereTests);
        result.push_back(row);
    }
    return result;
}

void printMeasurements(std::ostream& out, const PaperReport& report)
{
    out << text("%7s  %-16s %12s %18s %14s %9s %9s %6s  %s\n", "", "", "vicinity", "whole system", "sphere tests", "",
                "", "", "f(2n)/f(n)");
    out << text("%7s  %-16s %12s %18s %14s %9s %9s %6s  %6s %6s\n", "n", "back-end", "[ms/step]", "[ms/step]",
                "per step", "pairs", "spanning", "depth", "time", "tests");
    for (const PaperMeasurement& m : report.measurements)
        out << text("%7zu  %-16s %12.3f %9.3f +- %-5.2g %14.0f %9.0f %9.0f %6d  %6s %6s\n", m.objects,
                    name(m.method).c_str(), 1e3 * m.vicinity, 1e3 * m.system, 1e3 * m.systemUncertainty, m.sphereTests,
                    m.pairs, m.spanningObjects, m.depth,
                    factorOrDash(growth(report, m.method, m.objects, &PaperMeasurement::system)).c_str(),
                    factorOrDash(growth(report, m.method, m.objects, &PaperMeasurement::sphereTests)).c_str());
}

void printGrowth(std::ostream& out, const PaperReport& report)
{
    out << "\nAn aggregate has 425 objects and " << report.connectionsPerAggregate
        << " connections; the published one has 425 and 3883.\n"
        << "Growth f(2n)/f(n), whole system. Theta(n lg n) gives a little above 2, Theta(n^(5/3)) 3.17, "
           "Theta(n^2) almost 4.\n";
    out << text("%-16s  %-15s  %-17s  %s\n", "", "3400 to 6800", "all doublings", "published,");
    out << text("%-16s  %6s  %6s   %6s  %6s     %s\n", "back-end", "time", "tests", "time", "tests", "3500 to 7000");
    for (const PaperGrowth& row : growthOf(report))
        out << text("%-16s  %6s  %6s   %6s  %6s     %s\n", name(row.method).c_str(),
                    factorOrDash(row.timeThere).c_str(), factorOrDash(row.testsThere).c_str(),
                    factorOrDash(row.meanTime).c_str(), factorOrDash(row.meanTests).c_str(),
                    factorOrDash(row.published).c_str());
}

std::string jsonOf(const PaperReport& report)
{
    std::ostringstream json;
    json << "{\n  \"connections_per_aggregate\": " << report.connectionsPerAggregate << ",\n  \"measurements\": [";
    const char* separator = "\n";
    for (const PaperMeasurement& m : report.measurements) {
        json << separator << "    {\"objects\": " << m.objects << ", \"back_end\": \"" << nameOf(m.method)
             << "\", \"steps\": " << m.steps
             << text(", \"vicinity_s\": %.6g, \"system_s\": %.6g, \"system_uncertainty_s\": %.3g", m.vicinity, m.system,
                     m.systemUncertainty)
             << text(", \"sphere_tests\": %.1f, \"pairs\": %.1f, \"spanning_objects\": %.1f, \"depth\": %d}",
                     m.sphereTests, m.pairs, m.spanningObjects, m.depth);
        separator = ",\n";
    }
    json << "\n  ],\n  \"growth\": [";
    separator = "\n";
    for (const PaperGrowth& row : growthOf(report)) {
        json << separator << "    {\"back_end\": \"" << nameOf(row.method)
             << "\", \"published\": " << factorOrNull(row.published)
             << ", \"time_3400_to_6800\": " << factorOrNull(row.timeThere)
             << ", \"tests_3400_to_6800\": " << factorOrNull(row.testsThere)
             << ", \"time_mean\": " << factorOrNull(row.meanTime) << ", \"tests_mean\": " << factorOrNull(row.meanTests)
             << "}";
        separator = ",\n";
    }
    json << "\n  ]\n}\n";
    return json.str();
}

std::string figureOf(const PaperReport& report)
{
    GrowthPlot plot{.title = "Growth of the time per step: copies of a bar of 425 objects in a loose pile",
                    .xLabel = "number of objects n",
                    .yLabel = "time per step of the whole system [ms]",
                    .dashedLabel = "for comparison, through the first point of half-partition"};
    for (const PaperMeasurement& measurement : report.measurements)
        if (measurement.method == vicinityMethods[0])
            plot.xTicks.push_back(static_cast<double>(measurement.objects));
    plot.curves = {measured(report, VicinityMethod::bruteForce, "#555555", PlotMarker::diamond),
                   measured(report, VicinityMethod::medianPartition, "#d55e00", PlotMarker::square),
                   measured(report, VicinityMethod::halfPartition, "#0072b2", PlotMarker::disc),
                   measured(report, VicinityMethod::uniformGrid, "#009e73", PlotMarker::triangle)};
    // As in the paper, the curves to compare with start where the published algorithms do.
    const PaperMeasurement* first = report.find(VicinityMethod::halfPartition, report.measurements.front().objects);
    plot.curves.push_back(reference("a n^2", "#8a8a8a", plot.xTicks, *first, [](double n) { return n * n; }));
    plot.curves.push_back(
        reference("c n^5/3", "#8a8a8a", plot.xTicks, *first, [](double n) { return std::pow(n, 5.0 / 3.0); }));
    plot.curves.push_back(
        reference("b n lg n", "#8a8a8a", plot.xTicks, *first, [](double n) { return n * std::log2(n); }));
    return svgOf(plot);
}

} // namespace knead
