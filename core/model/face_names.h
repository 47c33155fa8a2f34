#pragma once

#include "core/model/part.h"

#include <cstdint>
#include <string>
#include <vector>

namespace knead {

/// Whether names say anything of which face is which: some have one, and not all of several the same.
bool haveTellingNames(const std::vector<PartFace>& faces);

/// The name of a face where it tells something; else empty, also for a face that is not among them.
std::string tellingName(const std::vector<PartFace>& faces, std::uint32_t face);

} // namespace knead
