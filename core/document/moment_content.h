#pragma once

#include "core/document/byte_stream.h"
#include "core/document/moment_bytes.h"

#include <span>

namespace knead {

/// What momentToBytes() packs: all of a moment, value after value.
Bytes momentContent(const Moment& moment);

/// The other way.
/// @throws std::runtime_error, a phrase such as "it ends early", when it is no moment of these bodies
Moment momentFromContent(std::span<const std::byte> content, std::span<const Body> bodies, const ToolParts& parts);

} // namespace knead
