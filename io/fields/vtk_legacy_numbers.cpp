#include "io/fields/vtk_legacy_numbers.h"

#include "io/fields/byte_numbers.h"
#include "io/files/lower_case.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace knead {

namespace {

constexpr std::array<LegacyTypeName, 16> legacyTypes{{
    {"float", LegacyType::float32, 4},
    {"double", LegacyType::float64, 8},
    {"char", LegacyType::int8, 1},
    {"signed_char", LegacyType::int8, 1},
    {"unsigned_char", LegacyType::uint8, 1},
    {"short", LegacyType::int16, 2},
    {"unsigned_short", LegacyType::uint16, 2},
    {"int", LegacyType::int32, 4},
    {"vtkidtype", LegacyType::int32, 4},
    {"unsigned_int", LegacyType::uint32, 4},
    {"long", LegacyType::int64, 8},
    {"unsigned_long", LegacyType::uint64, 8},
    {"vtktypeint64", LegacyType::int64, 8},
    {"vtktypeuint64", LegacyType::uint64, 8},
    {"long_long", LegacyType::int64, 8},
    {"unsigned_long_long", LegacyType::uint64, 8},
}};

double legacyNumberAt(std::string_view bytes, std::size_t place, LegacyType type)
{
    const auto as = [&]<typename Number>(Number) {
        return static_cast<double>(numberAt<Number>(bytes, place, std::endian::big));
    };
    switch (type) {
    case LegacyType::float32:
        return as(float{});
    case LegacyType::float64:
        return as(double{});
    case LegacyType::int8:
        return as(std::int8_t{});
    case LegacyType::uint8:
        return as(std::uint8_t{});
    case LegacyType::int16:
        return as(std::int16_t{});
    case LegacyType::uint16:
        return as(std::uint16_t{});
    case LegacyType::int32:
        return as(std::int32_t{});
    case LegacyType::uint32:
        return as(std::uint32_t{});
    case LegacyType::int64:
        return as(std::int64_t{});
    default:
        return as(std::uint64_t{});
    }
}

/// Calls visit(number) for each of the numbers that follow.
template <typename Visit>
void forEachNumber(TextScanner& text, bool isBinary, std::size_t count, const LegacyTypeName& type, Visit&& visit)
{
    if (!isBinary) {
        for (std::size_t i = 0; i < count; ++i)
            visit(text.number());
        return;
    }
    text.line();
    const std::string_view bytes = text.block(count * type.width);
    for (std::size_t i = 0; i < count; ++i)
        visit(legacyNumberAt(bytes, i * type.width, type.type));
}

} // namespace

std::string decodedName(std::string_view name)
{
    std::string text;
    for (std::size_t i = 0; i < name.size(); ++i) {
        unsigned code = 0;
        const char* const digits = name.data() + i + 1;
        if (name[i] == '%' && i + 2 < name.size() && std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
            text += static_cast<char>(code);
            i += 2;
        } else {
            text += name[i];
        }
    }
    return text;
}

std::string LegacyNumbers::keyword()
{
    return lowerCase(std::string(m_text.word()));
}

LegacyTypeName LegacyNumbers::type()
{
    const std::string name = keyword();
    const auto found = std::ranges::find(legacyTypes, name, &LegacyTypeName::name);
    if (found == legacyTypes.end())
        m_text.failHere();
    return *found;
}

std::size_t LegacyNumbers::checkedCount(std::size_t count, std::size_t each, const LegacyTypeName& type) const
{
    const std::size_t width = m_isBinary ? type.width : 1;
    if (each == 0 || count > m_text.left() / width / each)
        m_text.failHere();
    return count * each;
}

std::vector<double> LegacyNumbers::numbers(std::size_t count, const LegacyTypeName& type)
{
    std::vector<double> all;
    all.reserve(count);
    forEachNumber(m_text, m_isBinary, count, type, [&](double number) { all.push_back(number); });
    return all;
}

std::vector<std::int64_t> LegacyNumbers::wholeNumbers(std::size_t count, const LegacyTypeName& type)
{
    std::vector<std::int64_t> all;
    all.reserve(count);
    forEachNumber(m_text, m_isBinary, count, type, [&](double number) {
        all.push_back(std::abs(number) < 1e15 ? static_cast<std::int64_t>(number) : -1);
    });
    return all;
}

void LegacyNumbers::skipNumbers(std::size_t count, const LegacyTypeName& type)
{
    if (!m_isBinary) {
        for (std::size_t i = 0; i < count; ++i)
            m_text.word();
        return;
    }
    m_text.line();
    m_text.block(count * type.width);
}

} // namespace knead
