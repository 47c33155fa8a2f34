#include "core/session/history_outline.h"

namespace knead {

namespace {

using Entry = History::Entry;
using Children = std::vector<std::vector<Entry>>;

Children childrenIn(const History& history)
{
    Children children(history.records().size());
    for (Entry entry = 1; entry < children.size(); ++entry)
        children[history.record(entry).parent].push_back(entry);
    return children;
}

std::vector<OutlineRow> wayFrom(Entry entry, const Children& children)
{
    std::vector<OutlineRow> way;
    for (;;) {
        OutlineRow& row = way.emplace_back(OutlineRow{entry, {}});
        const std::vector<Entry>& next = children[entry];
        if (next.empty())
            return way;
        for (std::size_t i = 0; i + 1 < next.size(); ++i)
            row.branches.push_back(wayFrom(next[i], children));
        entry = next.back();
    }
}

} // namespace

std::vector<OutlineRow> outlineOf(const History& history)
{
    return wayFrom(0, childrenIn(history));
}

} // namespace knead
