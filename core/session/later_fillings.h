#pragma once

#include "core/document/moment_bytes.h"
#include "core/document/project.h"

#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace knead {

/// Fillings of bodies after their first ones, by body and how many objects they have.
using LaterFillings = std::map<std::pair<BodyId, std::size_t>, std::shared_ptr<const Aggregate>>;

/// Those that moments of a project keep, on the way to its present entry. @throws Problem for damaged moments; Cancelled
LaterFillings laterFillingsOf(const Project& project, const Packing& packing, TaskControl& control);

/// Which objects of the first filling were nearest to given ones of a later filling, when that was made, ascending; none where the
/// body was in pieces then.
std::vector<ObjectIndex> objectsInFirst(const Aggregate& later, const std::vector<ObjectIndex>& objects);

} // namespace knead
