#include "io/formats/number_stream.h"

#include <algorithm>
#include <charconv>

namespace knead {

NumberStream::NumberStream(ByteSink& sink, TaskControl& control, double expectedBytes)
    : m_sink(sink)
    , m_control(control)
    , m_expected(expectedBytes)
    , m_buffer(std::make_unique<char[]>(capacity))
{
}

void NumberStream::add(std::string_view text)
{
    if (text.size() > capacity - m_used)
        flush();
    if (text.size() > capacity)
        return m_sink.write(text);
    std::memcpy(m_buffer.get() + m_used, text.data(), text.size());
    m_used += text.size();
}

void NumberStream::addBinary(const Vec3& v)
{
    for (const double coordinate : v)
        addBinary(static_cast<float>(coordinate));
}

void NumberStream::addText(std::size_t number)
{
    char* const begin = room(longestNumber);
    m_used += static_cast<std::size_t>(std::to_chars(begin, begin + longestNumber, number).ptr - begin);
}

void NumberStream::addText(double number)
{
    char* const begin = room(longestNumber);
    const auto end = std::to_chars(begin, begin + longestNumber, static_cast<float>(number));
    m_used += static_cast<std::size_t>(end.ptr - begin);
}

void NumberStream::addText(const Vec3& v, std::string_view before)
{
    for (const double coordinate : v) {
        add(before);
        addText(coordinate);
    }
}

void NumberStream::flush()
{
    m_control.throwIfCancelled();
    m_sink.write({m_buffer.get(), m_used});
    m_passed += static_cast<double>(m_used);
    m_used = 0;
    m_control.report(std::min(1.0, m_passed / m_expected), "writing the file");
}

} // namespace knead
