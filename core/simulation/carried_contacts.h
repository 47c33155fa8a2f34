#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/mechanics/contacts.h"

#include <functional>
#include <vector>

namespace knead {

/// Where an object of any body is [m].
using PlaceOfObject = std::function<Vec3(const ObjectRef&)>;

/// Joints of a body that is filled anew are as much too long or too short between its new objects as they were between the old ones.
/// @param joints by the old objects, changed
/// @param before, now of an old object, and of the new one in its place
void keepStretch(std::vector<Joint>& joints, std::uint32_t body, const PlaceOfObject& before, const PlaceOfObject& now);

/// Objects of a body have other numbers: its joints are between those, and end where connections of the filling take their place. What
/// else contacts remember of its objects is forgotten.
/// @param aggregate, broken the filling and its cracks
void renumber(Contacts::Memory& memory, std::uint32_t body, const std::vector<ObjectIndex>& newOfOld,
              const Aggregate& aggregate, const std::vector<BrokenConnection>& broken);

} // namespace knead
