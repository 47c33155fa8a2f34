#pragma once

#include "io/fields/text_scanner.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

enum class LegacyType { float32, float64, int8, uint8, int16, uint16, int32, uint32, int64, uint64 };

struct LegacyTypeName {
    std::string_view name; ///< in lower case
    LegacyType type;
    std::size_t width; ///< [bytes]
};

inline constexpr LegacyTypeName legacyByte{"unsigned_char", LegacyType::uint8, 1};
inline constexpr LegacyTypeName legacyInt{"int", LegacyType::int32, 4};

/// "displacement [mm]" of "displacement%20[mm]".
std::string decodedName(std::string_view name);

/// Words and numbers of VTK's older format: numbers as text, or as bytes, highest first, behind the end of a line.
class LegacyNumbers {
public:
    /// @param text outlives this
    explicit LegacyNumbers(TextScanner& text)
        : m_text(text)
    {
    }

    void setBinary(bool isBinary) { m_isBinary = isBinary; }
    bool isBinary() const { return m_isBinary; }

    /// The next word in lower case.
    std::string keyword();
    /// The next word as a type of numbers. @throws Problem for any other
    LegacyTypeName type();
    /// count * each. @throws Problem, when the rest of the file cannot hold as many numbers
    std::size_t checkedCount(std::size_t count, std::size_t each, const LegacyTypeName& type) const;

    /// The numbers that follow. @throws Problem, when there are not as many
    std::vector<double> numbers(std::size_t count, const LegacyTypeName& type);
    std::vector<std::int64_t> wholeNumbers(std::size_t count, const LegacyTypeName& type);
    void skipNumbers(std::size_t count, const LegacyTypeName& type);

private:
    TextScanner& m_text;
    bool m_isBinary = false;
};

} // namespace knead
