#pragma once

#include "core/geometry/triangle_mesh.h"

#include <functional>
#include <string>
#include <vector>

/// The book of verification: cases with a reference that does not come from Knead.
namespace knead::book {

/// Where a reference comes from.
enum class Origin {
    closedForm, ///< a formula, or its numerical evaluation
    calculix,   ///< the same part in CalculiX, when the book is made
    measured,   ///< a published measurement, rule of design or standard
};

/// Whether a number is within its tolerance today, as far as known. Printed beside what comes out.
enum class Expected { holds, notYet };

/// One number that a case is judged by.
struct Quantity {
    std::string name; ///< "force"
    std::string unit; ///< "N"; "" for pure numbers
    double reference = 0;
    double tolerance = 0; ///< share of the reference; of a reference of 0: in the unit
    Origin origin = Origin::closedForm;
    Expected expected = Expected::holds;
};

struct Curve {
    struct Point {
        double x;
        double y;
    };
    std::string name;
    std::vector<Point> points;
};

/// What Knead or CalculiX made of a case.
struct Outcome {
    std::vector<double> values; ///< of the quantities, in their units; NaN: none
    std::vector<Curve> curves;  ///< of loads over displacements, if the case has any
    std::string curveAxes;      ///< "displacement [mm]; force [N]"
    TriangleMesh picture;       ///< the part in its last shape
    std::size_t objects = 0;    ///< or nodes of CalculiX
    double spacing = 0;         ///< [m]; 0 for CalculiX
    double seconds = 0;         ///< of processor time
    double imbalance = 0;       ///< of energy, as a share of what was turned over
    std::string trouble;        ///< a sentence when it did not come to its end; values are NaN then
};

struct Case {
    std::string id;    ///< "tension-nu-0.25"
    std::string group; ///< a chapter of the page
    std::string title;
    std::string source; ///< of the references, in words
    std::vector<Quantity> quantities;
    double cells = 4;   ///< across the section named in `across`, at the default spacing
    std::string across; ///< "the bar"
    std::function<Outcome(double cells)> run;
    std::function<Outcome()> calculix = {}; ///< runs CalculiX; empty: not compared. @throws std::runtime_error
    bool quick = true; ///< seconds at the default spacing: part of ./dev verify --quick and, if it holds, of the tests
    std::vector<double> finer = {1.5, 2}; ///< cells of the finer runs, times those of the first
};

/// All cases, in the order of the page.
std::vector<Case> allCases();

/// Relative to the reference; of a reference of 0 the value itself.
double errorOf(const Quantity& quantity, double value);
bool isWithin(const Quantity& quantity, double value);

} // namespace knead::book
