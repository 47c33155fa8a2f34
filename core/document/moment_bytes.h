#pragma once

#include "core/document/byte_stream.h"
#include "core/simulation/command.h"
#include "core/simulation/moment.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace knead {

/// How bytes are made smaller and large again. By default they are not.
struct Packing {
    std::function<Bytes(std::span<const std::byte> bytes)> pack;

    /// @param size how many bytes there were, for what was packed by pack(); damaged bytes may give another number
    /// @throws Problem for bytes that nothing was packed to
    std::function<Bytes(std::span<const std::byte> packed, std::size_t size)> unpack;
};

/// Imported parts that tools are made of.
using ToolParts = std::vector<std::shared_ptr<const ToolPart>>;

/// All that tools of a scene or of commands are made of. A moment of a document has no others.
ToolParts toolPartsOf(const Scene& scene, std::span<const RecordedCommand> commands);

/// The checksum of what is packed, and of the version from 10 on: 64 bits.
std::uint64_t momentSum(std::uint32_t version, std::span<const std::byte> packed);

/// A moment as bytes, the same on any machine: a mark, a version, a checksum, then what is packed. Tool parts are not among
/// them, only fingerprints of their surfaces.
Bytes momentToBytes(const Moment& moment, const Packing& packing = {});

/// The other way. Trusts nothing: sizes, indices and numbers are checked, so that a simulation of these bodies can go to
/// whatever comes back.
/// @param bodies of the scene that the moment is of
/// @param parts those of the document, in any order
/// @throws Problem for bytes that are damaged, of a newer version, or of another scene
Moment momentFromBytes(std::span<const std::byte> bytes, std::span<const Body> bodies, const ToolParts& parts = {},
                       const Packing& packing = {});

} // namespace knead
