#include "core/document/byte_stream.h"

#include "core/message/message.h"

#include <algorithm>
#include <bit>

namespace knead {

namespace {

constexpr std::size_t planeCount = sizeof(double);

/// Small for small differences of either sign.
std::uint64_t folded(std::uint64_t difference)
{
    return (difference << 1U) ^ (0 - (difference >> 63U));
}

std::uint64_t unfolded(std::uint64_t number)
{
    return (number >> 1U) ^ (0 - (number & 1U));
}

/// What a row that goes on straight would have at a place, as bits. Objects of a row lie next to each other: measured on
/// pressed blocks, what is left of the difference packs to 0.74 of its size, plain differences to 0.77, the numbers themselves to 0.95.
std::uint64_t expectedAt(const double* values, std::size_t i)
{
    return i < 2 ? 0 : std::bit_cast<std::uint64_t>(2 * values[i - 1] - values[i - 2]);
}

} // namespace

std::uint64_t checksumOf(std::span<const std::byte> bytes)
{
    std::uint64_t sum = 0xcbf29ce484222325ULL ^ bytes.size();
    for (std::size_t begin = 0; begin < bytes.size(); begin += 8) {
        std::uint64_t word = 0;
        for (std::size_t i = begin; i < std::min(begin + 8, bytes.size()); ++i)
            word |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * (i - begin));
        sum = (sum ^ word) * 0x100000001b3ULL;
        sum ^= sum >> 29U; // multiplying carries upwards only
    }
    return sum;
}

void ByteWriter::operator()(const double& value)
{
    (*this)(std::bit_cast<std::uint64_t>(value));
}

void ByteWriter::operator()(const std::string& value)
{
    (*this)(static_cast<std::uint32_t>(value.size()));
    for (const char letter : value)
        m_bytes.push_back(static_cast<std::byte>(letter));
}

void ByteWriter::operator()(const Vec3& value)
{
    for (const double component : value)
        (*this)(component);
}

void ByteWriter::operator()(const Quaternion& value)
{
    for (const double component : value.coeffs())
        (*this)(component);
}

void ByteWriter::planes(const double* values, std::size_t count)
{
    const std::size_t begin = m_bytes.size();
    m_bytes.resize(begin + planeCount * count);
    std::byte* place = m_bytes.data() + begin;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t number = folded(std::bit_cast<std::uint64_t>(values[i]) - expectedAt(values, i));
        for (std::size_t plane = 0; plane < planeCount; ++plane)
            place[plane * count + i] = static_cast<std::byte>(number >> (8 * plane));
    }
}

void ByteWriter::numbers(const LaneVector<double>& values, std::size_t /*count*/)
{
    (*this)(!values.empty());
    planes(values.data(), values.size());
}

void ByteWriter::numbers(const VectorArray& values, std::size_t /*count*/)
{
    (*this)(values.size() > 0);
    for (std::size_t c = 0; c < 3; ++c)
        planes(values.component(c), values.size());
}

std::span<const std::byte> ByteReader::next(std::size_t count)
{
    if (count > m_rest.size())
        throw Problem(Message("History", "it ends early"));
    const std::span<const std::byte> bytes = m_rest.first(count);
    m_rest = m_rest.subspan(count);
    return bytes;
}

void ByteReader::requireTruth(std::uint64_t bits)
{
    if (bits > 1)
        throw Problem(Message("History", "a yes or no is neither"));
}

void ByteReader::failAtChoice()
{
    throw Problem(Message("History", "a choice is none of those there are"));
}

void ByteReader::operator()(double& value)
{
    std::uint64_t bits = 0;
    (*this)(bits);
    value = std::bit_cast<double>(bits);
}

void ByteReader::operator()(std::string& value)
{
    std::uint32_t size = 0;
    (*this)(size);
    value.clear();
    for (const std::byte letter : next(size))
        value += static_cast<char>(letter);
}

void ByteReader::operator()(Vec3& value)
{
    for (double& component : value)
        (*this)(component);
}

void ByteReader::operator()(Quaternion& value)
{
    for (double& component : value.coeffs())
        (*this)(component);
}

bool ByteReader::hasNumbers()
{
    bool has = false;
    (*this)(has);
    return has;
}

void ByteReader::planes(double* values, std::size_t count)
{
    const std::span<const std::byte> bytes = next(planeCount * count);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint64_t number = 0;
        for (std::size_t plane = 0; plane < planeCount; ++plane)
            number |= std::to_integer<std::uint64_t>(bytes[plane * count + i]) << (8 * plane);
        values[i] = std::bit_cast<double>(expectedAt(values, i) + unfolded(number));
    }
}

void ByteReader::numbers(LaneVector<double>& values, std::size_t count)
{
    values.assign(hasNumbers() ? count : 0, 0);
    planes(values.data(), values.size());
}

void ByteReader::numbers(VectorArray& values, std::size_t count)
{
    values.resize(hasNumbers() ? count : 0);
    for (std::size_t c = 0; c < 3; ++c)
        planes(values.component(c), values.size());
}

} // namespace knead
