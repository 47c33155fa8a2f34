#pragma once

#include "core/task/task_control.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace knead {

/// The number that a whole word is, with blanks around it: "1.5", "+1e-3", as FORTRAN writes it "1.5D-3" and "1.5-103", "nan".
/// What is too large is infinite. Whatever the locale, the decimal sign is a point.
std::optional<double> numberIn(std::string_view word);

/// The same for whole numbers; none when it is too large.
std::optional<std::int64_t> wholeNumberIn(std::string_view word);

/// `text` without blanks and line ends at its ends.
std::string_view trimmedText(std::string_view text);

/// Goes through the bytes of a file line by line, word by word or as blocks, and tells how far it got.
class TextScanner {
public:
    /// @param bytes outlive this
    TextScanner(std::string_view bytes, TaskControl& control);

    bool isAtEnd() const { return m_at >= m_bytes.size(); }
    std::size_t place() const { return m_at; }
    std::size_t left() const { return m_bytes.size() - m_at; }
    void goTo(std::size_t place);

    /// The rest of the line without its end; empty at the end of the file. @throws Cancelled
    std::string_view line();
    /// The next word between blanks; empty at the end of the file. @throws Cancelled
    std::string_view word();
    /// @throws Problem, when there is another word or none
    double number();
    std::int64_t wholeNumber();
    /// A whole number >= 0. @throws Problem likewise
    std::size_t count();
    /// The next bytes as they are. @throws Problem, when there are not as many
    std::string_view block(std::size_t length);
    /// Behind the next place of `mark`, or the end. @return whether it is there
    bool skipBehind(std::string_view mark);

    /// @throws Problem: the file is damaged at the line where this is
    [[noreturn]] void failHere() const;

private:
    void tell();

    std::string_view m_bytes;
    TaskControl& m_control;
    std::size_t m_at = 0;
    std::size_t m_nextTold = 0;
};

} // namespace knead
