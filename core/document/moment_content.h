#pragma once

#include "core/document/byte_stream.h"
#include "core/document/moment_bytes.h"

#include <cstdint>
#include <span>

namespace knead {

/// Of what momentContent() gives; all from 1 on can be read. 2: objects have a plastic metric, where each connection had a plastic
/// strain, and what a run is measured by is kept, which begins anew in a moment of 1. 3: rubberlike material. 4: contacts know what
/// friction holds against, which begins anew in older ones. 5: tools at their limit need no resistance, and steps have a pace. 6: bodies
/// may have another filling than they were opened with. 7: knives and toughness. 8: what sticks to tools and floor. 9: what carries
/// the former shape of a filling may be a filling that has one itself. 10: what was filled may have been in pieces.
/// 11: tools roll. 12: what yields keeps its volume, which begins anew in older ones.
inline constexpr std::uint32_t momentVersion = 12;

/// What momentToBytes() packs: all of a moment, value after value.
Bytes momentContent(const Moment& moment);

/// The other way.
/// @param version that it was written with, 1 .. momentVersion
/// @throws Problem, a phrase such as "it ends early", when it is no moment of these bodies
Moment momentFromContent(std::span<const std::byte> content, std::span<const Body> bodies, const ToolParts& parts,
                         std::uint32_t version = momentVersion);

} // namespace knead
