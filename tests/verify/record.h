#pragma once

#include "verify/book.h"

#include <string>
#include <vector>

namespace knead::book {

/// What came out of a case: Knead at several spacings, from coarse to fine, and CalculiX.
struct Record {
    Case what; ///< with references filled in that CalculiX found
    std::vector<double> cells;
    std::vector<Outcome> runs;
    Outcome calculix; ///< without values when it was not run
};

struct RecordOptions {
    bool calculix = true;
    bool finer = true; ///< runs the two finer spacings as well
};

/// Runs a case. Errors become Outcome::trouble.
Record record(const Case& what, const RecordOptions& options);

/// Order of convergence of a quantity: by how much log |error| falls per log of the cells, at least squares.
/// NaN with fewer than two runs, or where errors are below a percent or of different signs: there it says nothing.
double orderOf(const Record& record, std::size_t quantity);

/// Whether a quantity is within its tolerance at every spacing.
bool holds(const Record& record, std::size_t quantity);

/// Whether all is as the case expects it: it came to its end, with CalculiX where that was asked for, no energy is missing, and each
/// quantity that is expected to hold does. What waits for CalculiX is not judged.
bool isAsExpected(const Record& record);

/// "value reference error ..." as one line per quantity.
std::string tableOf(const Record& record);
std::string tableHead();

} // namespace knead::book
