#pragma once

#include "core/geometry/vec3.h"
#include "core/task/task_control.h"
#include "io/files/byte_sink.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>

namespace knead {

// STL, binary PLY, glTF and VTP are little-endian, and so is every machine this runs on.
static_assert(std::endian::native == std::endian::little);

/// Collects text and numbers, as bytes or digits, and passes them on a quarter of a megabyte at a time; then it also tells progress
/// and looks whether the person cancelled.
class NumberStream {
public:
    /// @param expectedBytes about how many there will be, for the progress
    NumberStream(ByteSink& sink, TaskControl& control, double expectedBytes);

    void add(std::string_view text);
    template <typename Number>
    void addBinary(Number number);
    void addBinary(const Vec3& v); ///< in single precision
    void addText(std::size_t number);
    /// The shortest digits that give the same number in single precision again, with a point whatever the locale.
    void addText(double number);
    /// Three numbers, each behind `before`.
    void addText(const Vec3& v, std::string_view before);

    /// Passes on what is left.
    void flush();

private:
    static constexpr std::size_t capacity = 1U << 18U;
    static constexpr std::size_t longestNumber = 32;

    /// Where up to `size` bytes may be put.
    char* room(std::size_t size)
    {
        if (m_used + size > capacity)
            flush();
        return m_buffer.get() + m_used;
    }

    ByteSink& m_sink;
    TaskControl& m_control;
    double m_expected;
    double m_passed = 0;
    std::unique_ptr<char[]> m_buffer;
    std::size_t m_used = 0;
};

template <typename Number>
void NumberStream::addBinary(Number number)
{
    std::memcpy(room(sizeof number), &number, sizeof number);
    m_used += sizeof number;
}

} // namespace knead
