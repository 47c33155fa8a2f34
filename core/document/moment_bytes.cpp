#include "core/document/moment_bytes.h"

#include "core/document/moment_content.h"
#include "core/message/message.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr std::uint64_t mark = 0x31544E4D4F4D4B4EULL; // "NKMOMNT1"

// Objects have a few hundred bytes; joints, selections and texts have room enough besides.
constexpr std::size_t mostBytesPerObject = 8192;
constexpr std::size_t mostOtherBytes = std::size_t{1} << 26U;

std::size_t mostBytes(std::span<const Body> bodies)
{
    std::size_t most = mostOtherBytes;
    for (const Body& body : bodies)
        most += mostBytesPerObject * body.aggregate->size();
    return most;
}

struct Unpacked {
    std::uint32_t version = 0;
    Bytes content;
};

Unpacked unpacked(ByteReader& bytes, std::span<const Body> bodies, const Packing& packing)
{
    std::uint64_t markRead = 0;
    std::uint32_t version = 0;
    std::uint64_t size = 0;
    std::uint64_t sum = 0;
    std::uint64_t packedSize = 0;
    bytes(markRead);
    if (markRead != mark)
        throw Problem(Message("History", "it does not begin as one"));
    bytes(version);
    if (version < 1 || version > momentVersion)
        throw Problem(Message("History", "it was written by another version of Knead"));
    bytes(size);
    bytes(packedSize);
    bytes(sum);
    const std::span<const std::byte> packed = bytes.next(packedSize);
    if (!bytes.atEnd() || momentSum(version, packed) != sum || size > mostBytes(bodies))
        throw Problem(Message("History", "its bytes are not those that were written"));
    Bytes content = packing.unpack ? packing.unpack(packed, size) : Bytes(packed.begin(), packed.end());
    if (content.size() != size)
        throw Problem(Message("History", "its bytes are not those that were written"));
    return {version, std::move(content)};
}

} // namespace

ToolParts toolPartsOf(const Scene& scene, std::span<const RecordedCommand> commands)
{
    ToolParts parts;
    const auto add = [&](const std::shared_ptr<const ToolPart>& part) {
        if (part && std::ranges::find(parts, part) == parts.end())
            parts.push_back(part);
    };
    for (const Manipulator& manipulator : scene.manipulators)
        add(manipulator.part);
    for (const RecordedCommand& recorded : commands) {
        if (const auto* added = std::get_if<AddManipulator>(&recorded.command))
            add(added->manipulator.part);
        if (const auto* reshaped = std::get_if<ReshapeManipulator>(&recorded.command))
            add(reshaped->part);
    }
    return parts;
}

/// Content of two versions may be the same, but must not pass for the other one.
std::uint64_t momentSum(std::uint32_t version, std::span<const std::byte> packed)
{
    return checksumOf(packed) + (version < 10 ? 0 : version);
}

Bytes momentToBytes(const Moment& moment, const Packing& packing)
{
    const Bytes content = momentContent(moment);
    const Bytes packed = packing.pack ? packing.pack(content) : content;
    ByteWriter header;
    header(mark);
    header(momentVersion);
    header(static_cast<std::uint64_t>(content.size()));
    header(static_cast<std::uint64_t>(packed.size()));
    header(momentSum(momentVersion, packed));
    Bytes bytes = header.take();
    bytes.insert(bytes.end(), packed.begin(), packed.end());
    return bytes;
}

Moment momentFromBytes(std::span<const std::byte> bytes, std::span<const Body> bodies, const ToolParts& parts,
                       const Packing& packing)
{
    try {
        ByteReader reader(bytes);
        const Unpacked moment = unpacked(reader, bodies, packing);
        return momentFromContent(moment.content, bodies, parts, moment.version);
    } catch (const std::runtime_error& error) {
        throw Problem(
            Message("History",
                    "This moment of the history cannot be read: %1. Go to an earlier one and repeat from there.")
                .with(messageOf(error)));
    }
}

} // namespace knead
