#pragma once

#include "core/document/history.h"

#include <vector>

namespace knead {

/// An entry as a list shows it: what was done next stands below it, and what was done instead, earlier, is indented under it.
struct OutlineRow {
    History::Entry entry = 0;
    std::vector<std::vector<OutlineRow>> branches; ///< older ways on from this entry, each a list of its own
};

/// All entries; the first list begins with entry 0. The newest way on from an entry stays in its list, so that work goes on in
/// a straight line, and what was undone moves aside.
std::vector<OutlineRow> outlineOf(const History& history);

} // namespace knead
