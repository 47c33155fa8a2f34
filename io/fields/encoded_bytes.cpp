#include "io/fields/encoded_bytes.h"

#include "io/fields/field_content.h"

#include <algorithm>
#include <array>

namespace knead {

namespace {

constexpr signed char noLetter = -1;
constexpr signed char blankLetter = -2;
constexpr signed char padLetter = -3;

constexpr std::array<signed char, 256> base64Values = [] {
    std::array<signed char, 256> values{};
    values.fill(noLetter);
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < letters.size(); ++i)
        values[static_cast<unsigned char>(letters[i])] = static_cast<signed char>(i);
    for (const char c : {' ', '\t', '\r', '\n'})
        values[static_cast<unsigned char>(c)] = blankLetter;
    values['='] = padLetter;
    return values;
}();

} // namespace

std::string EncodedBytes::take(std::uint64_t count)
{
    // Four letters are three bytes.
    const std::uint64_t most = m_isBase64 ? m_text.size() / 4 * 3 + 3 + m_ahead.size() : m_text.size();
    if (count > most)
        failAsDamaged();
    if (m_isBase64)
        return takeDecoded(static_cast<std::size_t>(count));
    std::string bytes(m_text.substr(0, static_cast<std::size_t>(count)));
    m_text.remove_prefix(static_cast<std::size_t>(count));
    return bytes;
}

std::string EncodedBytes::takeDecoded(std::size_t count)
{
    m_ahead.reserve(count + 3);
    while (m_ahead.size() < count && !m_isOver)
        decodeFour();
    if (m_ahead.size() < count)
        failAsDamaged();
    std::string bytes = std::move(m_ahead);
    m_ahead = bytes.substr(count);
    bytes.resize(count);
    return bytes;
}

int EncodedBytes::nextLetter()
{
    while (!m_text.empty()) {
        const signed char value = base64Values[static_cast<unsigned char>(m_text.front())];
        if (value == noLetter)
            break;
        m_text.remove_prefix(1);
        if (value != blankLetter)
            return value;
    }
    m_isOver = true;
    return noLetter;
}

/// Appends the bytes of the next four letters; fewer before padding.
void EncodedBytes::decodeFour()
{
    unsigned bits = 0;
    int letters = 0;
    for (int i = 0; i < 4; ++i) {
        const int value = nextLetter();
        if (value == noLetter)
            return;
        bits = bits << 6U | (value < 0 ? 0U : static_cast<unsigned>(value));
        letters += value < 0 ? 0 : 1;
    }
    for (int i = 0; i + 1 < letters; ++i)
        m_ahead += static_cast<char>(bits >> (16U - 8U * static_cast<unsigned>(i)) & 255U);
}

} // namespace knead
