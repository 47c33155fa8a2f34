#pragma once

#include "core/vicinity/vicinity.h"

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// What one back-end took for one number of objects. Times and counts are means over the steps timed.
struct PaperMeasurement {
    std::size_t objects = 0;
    VicinityMethod method = VicinityMethod::uniformGrid;
    std::size_t steps = 0;        ///< timed
    double vicinity = 0;          ///< time of the vicinity calculation [s]
    double system = 0;            ///< time of the whole step: vicinity, connection forces, motion [s]
    double systemUncertainty = 0; ///< standard error of the mean [s]; 0 for a single step
    double sphereTests = 0;       ///< distances computed
    double spanningObjects = 0;   ///< spheres held by inner nodes
    double pairs = 0;             ///< found
    int depth = 0;                ///< of the deepest tree
};

/// All measurements: numbers of objects ascending, each twice the one before, every back-end within.
struct PaperReport {
    std::size_t connectionsPerAggregate = 0;
    std::vector<PaperMeasurement> measurements;

    /// The measurement of one back-end, or nothing.
    const PaperMeasurement* find(VicinityMethod method, std::size_t objects) const;
};

/// Growth f(2n) / f(n) of one back-end.
struct PaperGrowth {
    VicinityMethod method = VicinityMethod::uniformGrid;
    std::optional<double> published;  ///< of the whole system, read off the paper's graph: f(7000) / f(3500)
    std::optional<double> timeThere;  ///< f(6800) / f(3400), whole system
    std::optional<double> testsThere; ///< f(6800) / f(3400)
    std::optional<double> meanTime;   ///< geometric mean over all doublings, whole system
    std::optional<double> meanTests;  ///< geometric mean over all doublings
};
std::vector<PaperGrowth> growthOf(const PaperReport& report);

/// All measurements as a table, growth against half the number of objects included.
void printMeasurements(std::ostream& out, const PaperReport& report);

void printGrowth(std::ostream& out, const PaperReport& report);

std::string jsonOf(const PaperReport& report);

/// Figure 6 of the paper, drawn from the measurements, as SVG.
std::string figureOf(const PaperReport& report);

} // namespace knead
