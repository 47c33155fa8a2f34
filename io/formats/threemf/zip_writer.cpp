#include "io/formats/threemf/zip_writer.h"

#include <zlib.h>

#include <limits>
#include <new>
#include <stdexcept>

namespace knead {

namespace {

constexpr std::uint16_t version = 20;    // 2.0: deflation
constexpr std::uint16_t sizesFollow = 8; // flag: checksum and sizes come behind the bytes
constexpr std::uint16_t deflated = 8;
constexpr std::uint32_t date = 0x0021'0000; // 1980-01-01: the same parts give the same bytes

template <typename Number>
void append(std::string& bytes, Number number)
{
    for (unsigned i = 0; i < sizeof number; ++i)
        bytes += static_cast<char>(number >> 8U * i & 0xFFU);
}

std::uint32_t checked(std::uint64_t size)
{
    if (size >= std::numeric_limits<std::uint32_t>::max())
        throw std::length_error("more than 4 GB in a zip archive");
    return static_cast<std::uint32_t>(size);
}

} // namespace

ZipWriter::ZipWriter(ByteSink& sink)
    : m_sink(sink)
    , m_packed(1U << 18U)
{
}

ZipWriter::~ZipWriter()
{
    if (m_deflater)
        deflateEnd(m_deflater.get());
}

void ZipWriter::beginFile(const std::string& name)
{
    endFile();
    m_entries.push_back({name, m_passed, 0, 0, static_cast<std::uint32_t>(crc32(0, nullptr, 0))});
    std::string head = "PK\x03\x04";
    for (const std::uint16_t number : {version, sizesFollow, deflated})
        append(head, number);
    append(head, date);
    head.append(12, '\0'); // checksum and sizes
    append(head, static_cast<std::uint16_t>(name.size()));
    append(head, std::uint16_t{0});
    pass(head + name);

    m_deflater = std::make_unique<z_stream_s>();
    constexpr int rawBits = -MAX_WBITS; // without a header of zlib's own
    if (deflateInit2(m_deflater.get(), Z_BEST_SPEED, Z_DEFLATED, rawBits, 8, Z_DEFAULT_STRATEGY) != Z_OK) {
        m_deflater.reset();
        throw std::bad_alloc();
    }
}

void ZipWriter::write(std::string_view bytes)
{
    Entry& entry = m_entries.back();
    entry.size += bytes.size();
    checked(entry.size);
    entry.checksum = static_cast<std::uint32_t>(
        crc32_z(entry.checksum, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
    deflateAll(bytes, false);
}

void ZipWriter::deflateAll(std::string_view bytes, bool isLast)
{
    m_deflater->next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data())); // zlib only reads it
    m_deflater->avail_in = checked(bytes.size());
    do {
        m_deflater->next_out = m_packed.data();
        m_deflater->avail_out = static_cast<unsigned>(m_packed.size());
        deflate(m_deflater.get(), isLast ? Z_FINISH : Z_NO_FLUSH);
        const std::size_t packed = m_packed.size() - m_deflater->avail_out;
        m_entries.back().packedSize += packed;
        pass({reinterpret_cast<const char*>(m_packed.data()), packed});
    } while (m_deflater->avail_out == 0);
}

void ZipWriter::endFile()
{
    if (!m_deflater)
        return;
    deflateAll({}, true);
    deflateEnd(m_deflater.get());
    m_deflater.reset();
    const Entry& entry = m_entries.back();
    std::string tail = "PK\x07\x08";
    append(tail, entry.checksum);
    append(tail, checked(entry.packedSize));
    append(tail, checked(entry.size));
    pass(tail);
}

void ZipWriter::finish()
{
    endFile();
    std::string list;
    for (const Entry& entry : m_entries) {
        list += "PK\x01\x02";
        for (const std::uint16_t number : {version, version, sizesFollow, deflated})
            append(list, number);
        append(list, date);
        append(list, entry.checksum);
        append(list, checked(entry.packedSize));
        append(list, checked(entry.size));
        append(list, static_cast<std::uint16_t>(entry.name.size()));
        list.append(12, '\0'); // lengths of extras and comment, disk, attributes
        append(list, checked(entry.begin));
        list += entry.name;
    }
    const std::uint64_t begin = m_passed;
    pass(list);
    std::string end = "PK\x05\x06";
    append(end, std::uint32_t{0}); // disks
    append(end, static_cast<std::uint16_t>(m_entries.size()));
    append(end, static_cast<std::uint16_t>(m_entries.size()));
    append(end, checked(list.size()));
    append(end, checked(begin));
    append(end, std::uint16_t{0}); // length of a comment
    pass(end);
}

void ZipWriter::pass(std::string_view bytes)
{
    m_sink.write(bytes);
    m_passed += bytes.size();
}

} // namespace knead
