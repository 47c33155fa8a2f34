#include "io/fields/text_scanner.h"

#include "core/message/message.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>
#include <string>

namespace knead {

namespace {

constexpr std::size_t toldEvery = 1U << 20U; // bytes

bool isBlank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/// FORTRAN's ways put as C's: "1.5D-3", "1.5-103".
std::string withExponent(std::string_view word)
{
    std::string text;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const char c = word[i] == 'D' || word[i] == 'd' ? 'e' : word[i];
        const bool isDigitBefore =
            i > 0 && (std::isdigit(static_cast<unsigned char>(word[i - 1])) != 0 || word[i - 1] == '.');
        if ((c == '-' || c == '+') && isDigitBefore)
            text += 'e';
        if (c != '+')
            text += c;
    }
    return text;
}

} // namespace

std::string_view trimmedText(std::string_view text)
{
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

std::optional<double> numberIn(std::string_view word)
{
    word = trimmedText(word);
    if (word.starts_with('+') && !word.starts_with("+-"))
        word.remove_prefix(1);
    double number = 0;
    const auto parsed = [&](std::string_view text) -> std::optional<double> {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (end != text.data() + text.size())
            return {};
        if (error == std::errc{})
            return number;
        if (error != std::errc::result_out_of_range)
            return {};
        const bool isSmall = text.find("e-") != text.npos || text.find("E-") != text.npos;
        return isSmall ? 0 : std::numeric_limits<double>::infinity();
    };
    if (const auto result = parsed(word))
        return result;
    const bool isNumber = !word.empty() && word.find_first_not_of("0123456789+-.eEdD") == word.npos;
    return isNumber ? parsed(withExponent(word)) : std::nullopt;
}

std::optional<std::int64_t> wholeNumberIn(std::string_view word)
{
    word = trimmedText(word);
    if (word.starts_with('+') && !word.starts_with("+-"))
        word.remove_prefix(1);
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool isWhole = error == std::errc{} && end == word.data() + word.size();
    return isWhole ? std::optional(number) : std::nullopt;
}

TextScanner::TextScanner(std::string_view bytes, TaskControl& control)
    : m_bytes(bytes)
    , m_control(control)
{
}

void TextScanner::tell()
{
    if (m_at < m_nextTold)
        return;
    m_nextTold = m_at + toldEvery;
    m_control.throwIfCancelled();
    m_control.report(static_cast<double>(m_at) / static_cast<double>(std::max<std::size_t>(m_bytes.size(), 1)),
                     "reading the file");
}

void TextScanner::goTo(std::size_t place)
{
    m_at = std::min(place, m_bytes.size());
}

std::string_view TextScanner::line()
{
    tell();
    const std::string_view rest = m_bytes.substr(m_at);
    std::string_view line = rest.substr(0, std::min(rest.find('\n'), rest.size()));
    goTo(m_at + line.size() + 1);
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    return line;
}

std::string_view TextScanner::word()
{
    tell();
    while (m_at < m_bytes.size() && isBlank(m_bytes[m_at]))
        ++m_at;
    const std::size_t begin = m_at;
    while (m_at < m_bytes.size() && !isBlank(m_bytes[m_at]))
        ++m_at;
    return m_bytes.substr(begin, m_at - begin);
}

double TextScanner::number()
{
    const auto found = numberIn(word());
    if (!found)
        failHere();
    return *found;
}

std::int64_t TextScanner::wholeNumber()
{
    const auto found = wholeNumberIn(word());
    if (!found)
        failHere();
    return *found;
}

std::size_t TextScanner::count()
{
    const std::int64_t number = wholeNumber();
    if (number < 0)
        failHere();
    return static_cast<std::size_t>(number);
}

std::string_view TextScanner::block(std::size_t length)
{
    tell();
    if (length > left())
        failHere();
    m_at += length;
    return m_bytes.substr(m_at - length, length);
}

bool TextScanner::skipBehind(std::string_view mark)
{
    tell();
    const char* const begin = m_bytes.data() + m_at;
    const void* const found = memmem(begin, left(), mark.data(), mark.size());
    goTo(found == nullptr ? m_bytes.size()
                          : m_at + static_cast<std::size_t>(static_cast<const char*>(found) - begin) + mark.size());
    return found != nullptr;
}

void TextScanner::failHere() const
{
    const auto line = 1 + std::count(m_bytes.begin(), m_bytes.begin() + static_cast<std::ptrdiff_t>(m_at), '\n');
    throw Problem(
        Message("Field", "the file is damaged or cut off at line %1; write it again with the program it comes from.")
            .with(line));
}

} // namespace knead
