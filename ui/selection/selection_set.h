#pragma once

#include "core/session/region.h"

#include <QJsonObject>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace knead {

/// A region with a name, to be selected again. Bodies are named by their parts, which are the same in every filling; edges, objects
/// and connections are those of one filling.
struct SelectionSet {
    std::string name;
    Level level = Level::Part;
    std::uint32_t start = 0;                    ///< of the history's, that the numbers belong to
    std::map<std::size_t, Region::Items> items; ///< by index into Model::parts; ascending

    friend bool operator==(const SelectionSet&, const SelectionSet&) = default;
};

/// As it is kept in projects; numbers in a row as pairs of their first and last. None for what is no set.
QJsonObject toJson(const SelectionSet& set);
std::optional<SelectionSet> selectionSetFrom(const QJsonObject& json);

} // namespace knead
