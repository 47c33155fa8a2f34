#include "io/project/packing.h"

#include "core/message/message.h"

#include <zstd.h>

#include <new>

namespace knead {

namespace {

Bytes pack(std::span<const std::byte> bytes)
{
    Bytes packed(ZSTD_compressBound(bytes.size()));
    const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), packingLevel);
    if (ZSTD_isError(size) != 0)
        throw std::bad_alloc();
    packed.resize(size);
    packed.shrink_to_fit();
    return packed;
}

Bytes unpack(std::span<const std::byte> packed, std::size_t size)
{
    if (ZSTD_getFrameContentSize(packed.data(), packed.size()) != size) // before there is room for it
        throw Problem(Message("Project", "it cannot be unpacked"));
    Bytes bytes(size);
    const std::size_t unpacked = ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
    if (ZSTD_isError(unpacked) != 0)
        throw Problem(Message("Project", "it cannot be unpacked"));
    bytes.resize(unpacked);
    return bytes;
}

} // namespace

Packing zstandardPacking()
{
    return {pack, unpack};
}

} // namespace knead
