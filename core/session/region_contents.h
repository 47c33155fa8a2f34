#pragma once

#include "core/session/frame.h"
#include "core/session/region.h"

#include <array>
#include <string>
#include <vector>

namespace knead {

/// How much is in a region.
struct RegionSize {
    std::size_t count = 0;
    std::string name = {}; ///< of a face that is alone; empty where the file gives it none
    double length = 0;     ///< of edges and connections, now [m]
    double area = 0;       ///< of faces, now [m^2]
    double volume = 0;     ///< of parts, now; of objects, their share of the body at rest [m^3]
};
RegionSize sizeOf(const Region& region, const FilledModel& content, const Frame& now);

/// Objects that belong to a region, per body, ascending: at faces as fixtures hold them; within a spacing of edges; both ends of
/// connections. All of them for a part.
std::map<BodyId, std::vector<ObjectIndex>> objectsOf(const Region& region, const FilledModel& content);

/// All objects that lie no farther than this from those of a region, now [m]; bodies that touch take part too. Any thread.
Region objectsWithin(const Region& region, double distance, const FilledModel& content, const Frame& now);

/// The two ends of a connection.
std::array<ObjectIndex, 2> endsOf(const Aggregate& aggregate, const ConnectionId& connection);

/// Whether an item names a connection that is there. Any item.
bool isConnection(const Aggregate& aggregate, Region::Item item);

/// All structural connections, and those whose two ends a person can see.
std::vector<ConnectionId> allConnections(const Aggregate& aggregate);
std::vector<ConnectionId> surfaceConnections(const FilledBody& body);

/// Whether parts have CAD faces that can be told apart.
bool hasFaces(const FilledModel& content, BodyId body);

} // namespace knead
