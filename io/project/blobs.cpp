#include "io/project/blobs.h"

#include "core/message/message.h"
#include "io/project/packing.h"

#include <zstd.h>

#include <algorithm>
#include <limits>
#include <new>

namespace knead {

namespace {

constexpr std::size_t pieceSize = std::size_t{8} << 20U;

std::int64_t piecesOf(std::size_t size)
{
    return std::max<std::int64_t>(1, static_cast<std::int64_t>((size + pieceSize - 1) / pieceSize));
}

/// @throws std::bad_alloc
void packInto(std::span<const std::byte> bytes, Bytes& packed)
{
    packed.resize(ZSTD_compressBound(bytes.size()));
    const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), packingLevel);
    if (ZSTD_isError(size) != 0)
        throw std::bad_alloc();
    packed.resize(size);
}

/// @throws DamagedData when it does not become as long as it was
void unpackInto(const Bytes& packed, std::int64_t size, Bytes& bytes, std::size_t& budget)
{
    if (size < 0 || size > static_cast<std::int64_t>(std::min(pieceSize, budget)))
        throw DamagedData(Message("Project", "a number in the table blobs is out of range"));
    if (ZSTD_getFrameContentSize(packed.data(), packed.size()) != static_cast<unsigned long long>(size))
        throw DamagedData(Message("Project", "a row of the table blobs cannot be unpacked"));
    const std::size_t begin = bytes.size();
    const auto wanted = static_cast<std::size_t>(size);
    budget -= wanted;
    bytes.resize(begin + wanted);
    const std::size_t unpacked = ZSTD_decompress(bytes.data() + begin, wanted, packed.data(), packed.size());
    if (ZSTD_isError(unpacked) != 0 || unpacked != wanted)
        throw DamagedData(Message("Project", "a row of the table blobs cannot be unpacked"));
}

/// How many pieces follow each other from the first one. All but the last are full.
std::int64_t countFrom(const Row& first, std::size_t budget)
{
    const std::int64_t count = first.integer(2);
    if (count > piecesOf(budget) || first.integer(0) > std::numeric_limits<std::int64_t>::max() - count)
        throw DamagedData(Message("Project", "a number in the table blobs is out of range"));
    return count;
}

} // namespace

std::int64_t Blobs::reserve(std::size_t size)
{
    const std::int64_t id = m_next;
    m_next += piecesOf(size);
    return id;
}

void Blobs::put(std::int64_t id, std::span<const std::byte> bytes, TaskControl& control)
{
    const std::int64_t count = piecesOf(bytes.size());
    for (std::int64_t i = 0; i < count; ++i) {
        control.throwIfCancelled();
        const std::span<const std::byte> piece = bytes.first(std::min(pieceSize, bytes.size()));
        bytes = bytes.subspan(piece.size());
        packInto(piece, m_packed);
        putRow(m_database, "blobs", {id + i, i, count, static_cast<std::int64_t>(piece.size()), m_packed});
    }
}

std::int64_t Blobs::put(std::span<const std::byte> bytes, TaskControl& control)
{
    const std::int64_t id = reserve(bytes.size());
    put(id, bytes, control);
    return id;
}

void Blobs::drop(std::int64_t id, std::size_t size)
{
    for (std::int64_t i = 0; i < piecesOf(size); ++i)
        dropRow(m_database, "blobs", id + i);
}

Bytes Blobs::read(SQLite::Database& database, std::int64_t id, std::size_t& budget, TaskControl& control)
{
    Bytes bytes;
    std::int64_t count = 1;
    for (std::int64_t i = 0; i < count; ++i) {
        control.throwIfCancelled();
        const Row row = rowAt(database, "blobs", id + i);
        if (i == 0)
            count = countFrom(row, budget);
        if (row.integer(1) != i || row.integer(2) != count)
            throw DamagedData(Message("Project", "pieces of the table blobs are mixed up"));
        unpackInto(row.bytes(4), row.integer(3), bytes, budget);
    }
    return bytes;
}

} // namespace knead
