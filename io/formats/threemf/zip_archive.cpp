#include "io/formats/threemf/zip_archive.h"

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <new>
#include <utility>

namespace knead {

namespace {

// Sizes and places in the records are those of APPNOTE.TXT, sections 4.3.7, 4.3.12, 4.3.14 to 4.3.16 and 4.5.3.
constexpr std::string_view localMark = "PK\x03\x04";
constexpr std::string_view entryMark = "PK\x01\x02";
constexpr std::string_view endMark = "PK\x05\x06";
constexpr std::string_view longEndMark = "PK\x06\x06";
constexpr std::string_view longEndPlaceMark = "PK\x06\x07";
constexpr std::size_t localLength = 30;
constexpr std::size_t entryLength = 46;
constexpr std::size_t endLength = 22;
constexpr std::size_t longEndLength = 56;
constexpr std::size_t longEndPlaceLength = 20;
constexpr std::uint64_t isLongNumber = 0xFFFF'FFFF; // the number has 64 bits and stands elsewhere
constexpr unsigned longNumbers = 1;                 // what holds them behind the name
constexpr std::size_t longestComment = 65'535;
constexpr std::size_t mostEntries = 1000;
constexpr std::size_t longestDirectory = 1U << 20U; // read of it
constexpr unsigned isEncrypted = 1;
constexpr unsigned storedMethod = 0;
constexpr unsigned deflatedMethod = 8;
constexpr std::size_t unpackedPiece = 1U << 18U;

std::uint64_t zipNumber(std::string_view bytes, std::size_t at, std::size_t length)
{
    std::uint64_t value = 0;
    for (std::size_t i = length; i-- > 0;)
        value = (value << 8U) | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

std::string bytesAt(std::ifstream& file, std::uint64_t at, std::size_t length)
{
    std::string bytes(length, '\0');
    file.clear();
    file.seekg(static_cast<std::streamoff>(at));
    file.read(bytes.data(), static_cast<std::streamsize>(length));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

/// Puts in what does not fit into 32 bits, from the records behind the name.
void takeLongNumbers(std::string_view records, ZipEntry& entry)
{
    while (records.size() >= 4) {
        const std::uint64_t length = zipNumber(records, 2, 2);
        if (length > records.size() - 4)
            return;
        std::string_view record = records.substr(4, length);
        if (zipNumber(records, 0, 2) == longNumbers)
            for (std::uint64_t* value : {&entry.size, &entry.packedSize, &entry.begin})
                if (*value == isLongNumber && record.size() >= 8) {
                    *value = zipNumber(record, 0, 8);
                    record.remove_prefix(8);
                }
        records.remove_prefix(4 + length);
    }
}

std::vector<ZipEntry> entriesOf(std::string_view directory)
{
    std::vector<ZipEntry> entries;
    while (directory.size() >= entryLength && directory.starts_with(entryMark) && entries.size() < mostEntries) {
        const std::uint64_t nameLength = zipNumber(directory, 28, 2);
        const std::uint64_t recordsLength = zipNumber(directory, 30, 2);
        const std::uint64_t commentLength = zipNumber(directory, 32, 2);
        ZipEntry entry{.name = std::string(directory.substr(entryLength, nameLength)),
                       .flags = static_cast<unsigned>(zipNumber(directory, 8, 2)),
                       .method = static_cast<unsigned>(zipNumber(directory, 10, 2)),
                       .checksum = static_cast<std::uint32_t>(zipNumber(directory, 16, 4)),
                       .packedSize = zipNumber(directory, 20, 4),
                       .size = zipNumber(directory, 24, 4),
                       .begin = zipNumber(directory, 42, 4)};
        directory.remove_prefix(std::min<std::size_t>(entryLength + nameLength, directory.size()));
        takeLongNumbers(directory.substr(0, recordsLength), entry);
        entries.push_back(std::move(entry));
        directory.remove_prefix(std::min<std::size_t>(recordsLength + commentLength, directory.size()));
    }
    return entries;
}

/// Inflates what deflate packed, without a header of zlib's own.
class Inflater {
public:
    Inflater()
    {
        if (inflateInit2(&m_stream, -MAX_WBITS) != Z_OK)
            throw std::bad_alloc();
    }
    ~Inflater() { inflateEnd(&m_stream); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    void take(std::string_view packed, const std::function<void(std::string_view)>& give)
    {
        m_stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(packed.data())); // zlib only reads it
        m_stream.avail_in = static_cast<unsigned>(packed.size());
        do {
            m_stream.next_out = reinterpret_cast<unsigned char*>(m_room.data());
            m_stream.avail_out = static_cast<unsigned>(m_room.size());
            const int result = inflate(&m_stream, Z_NO_FLUSH);
            if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR)
                throw DamagedZip();
            m_isOver = result == Z_STREAM_END;
            give(std::string_view(m_room).substr(0, m_room.size() - m_stream.avail_out));
        } while (m_stream.avail_out == 0 && !m_isOver);
    }

    bool isOver() const { return m_isOver; }

private:
    z_stream m_stream{};
    std::string m_room = std::string(unpackedPiece, '\0');
    bool m_isOver = false;
};

/// Where the bytes of an entry begin.
std::uint64_t packedBeginOf(std::ifstream& file, const ZipEntry& entry)
{
    const std::string head = bytesAt(file, entry.begin, localLength);
    if (head.size() != localLength || !head.starts_with(localMark))
        throw DamagedZip();
    return entry.begin + localLength + zipNumber(head, 26, 2) + zipNumber(head, 28, 2);
}

} // namespace

std::optional<std::vector<ZipEntry>> zipEntries(const std::string& path)
{
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const auto size = static_cast<std::uint64_t>(std::max<std::streamoff>(file.tellg(), 0));
    const auto tailLength =
        static_cast<std::size_t>(std::min<std::uint64_t>(size, endLength + longestComment + longEndPlaceLength));
    const std::string tail = bytesAt(file, size - tailLength, tailLength);
    const std::size_t end = tail.rfind(endMark);
    if (end == std::string::npos || end + endLength > tail.size())
        return std::nullopt;

    std::uint64_t length = zipNumber(tail, end + 12, 4);
    std::uint64_t begin = zipNumber(tail, end + 16, 4);
    if ((length == isLongNumber || begin == isLongNumber) && end >= longEndPlaceLength &&
        tail.compare(end - longEndPlaceLength, longEndPlaceMark.size(), longEndPlaceMark) == 0) {
        const std::string longEnd = bytesAt(file, zipNumber(tail, end - longEndPlaceLength + 8, 8), longEndLength);
        if (longEnd.size() != longEndLength || !longEnd.starts_with(longEndMark))
            return std::nullopt;
        length = zipNumber(longEnd, 40, 8);
        begin = zipNumber(longEnd, 48, 8);
    }
    if (begin > size)
        return std::nullopt;
    std::vector<ZipEntry> entries =
        entriesOf(bytesAt(file, begin, static_cast<std::size_t>(std::min<std::uint64_t>(length, longestDirectory))));
    return entries.empty() ? std::nullopt : std::optional(std::move(entries));
}

void unpack(const std::string& path, const ZipEntry& entry, const std::function<void(std::string_view)>& take)
{
    if ((entry.flags & isEncrypted) != 0 || (entry.method != storedMethod && entry.method != deflatedMethod))
        throw DamagedZip();
    std::uint64_t left = entry.size;
    uLong checksum = crc32(0, nullptr, 0);
    const auto give = [&](std::string_view bytes) {
        if (bytes.size() > left)
            throw DamagedZip();
        left -= bytes.size();
        checksum = crc32_z(checksum, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
        if (!bytes.empty())
            take(bytes);
    };
    std::ifstream file(path, std::ios::binary);
    std::uint64_t at = packedBeginOf(file, entry);
    Inflater inflater;
    for (std::uint64_t packed = entry.packedSize; packed > 0;) {
        const std::string bytes =
            bytesAt(file, at, static_cast<std::size_t>(std::min<std::uint64_t>(packed, unpackedPiece)));
        if (bytes.empty())
            throw DamagedZip();
        at += bytes.size();
        packed -= bytes.size();
        if (entry.method == storedMethod)
            give(bytes);
        else if (!inflater.isOver())
            inflater.take(bytes, give);
    }
    if (left > 0 || checksum != entry.checksum)
        throw DamagedZip();
}

} // namespace knead
