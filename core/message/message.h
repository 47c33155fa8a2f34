#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace knead {

/// A sentence for a person before it is put in words: a text with places "%1" to "%9", and what goes into them. What goes in
/// is said as it is (a name, a number with its unit) or is a message in turn. A value; of any thread.
///
///     Message("Filling", "A spacing of %1 needs more than %2 objects.").with(inMillimetres(spacing), most)
///
/// Subject and text stand in the code as literals, side by side: that is where translators are given them from. The text is
/// English, and so what says it where nothing is translated.
class Message {
public:
    Message() = default; ///< says nothing

    /// @param subject what it is about, for translators: "Filling", "Import", "Run"
    Message(std::string subject, std::string text)
        : m_subject(std::move(subject))
        , m_text(std::move(text))
    {
    }

    /// What is the same in every language: a name, a number, or what another program or an older file said.
    static Message verbatim(std::string text) { return {{}, std::move(text)}; }

    /// One sentence after the other; those that say nothing are left out. At most 9.
    static Message sequence(std::vector<Message> sentences);

    /// With its places filled, the first with the first. At most 9.
    template <typename... Arguments>
    Message with(const Arguments&... arguments) const
    {
        static_assert(sizeof...(Arguments) <= 9, "places are %1 to %9");
        Message filled = *this;
        (filled.m_arguments.push_back(argument(arguments)), ...);
        return filled;
    }

    /// The same with these in its places, as when it is read from a file. At most 9.
    Message withAll(std::vector<Message> arguments) const;

    bool empty() const { return m_text.empty(); }
    bool isVerbatim() const { return m_subject.empty() && m_arguments.empty(); }
    const std::string& subject() const { return m_subject; } ///< empty: not translated
    const std::string& text() const { return m_text; }
    const std::vector<Message>& arguments() const { return m_arguments; }

    std::string english() const;

    friend bool operator==(const Message&, const Message&) = default;

private:
    static Message argument(const Message& message) { return message; }
    static Message argument(std::string_view text) { return verbatim(std::string(text)); }
    template <typename Number>
    requires std::is_integral_v<Number>
    static Message argument(Number number) { return verbatim(std::to_string(number)); }
    static Message argument(double) = delete; ///< how many digits, and what unit?

    std::string m_subject;
    std::string m_text;
    std::vector<Message> m_arguments;
};

/// `text` with "%1" to "%9" replaced by `values`; places that have none stay. What gets longer than any sentence, as of a damaged
/// file, is cut off.
std::string withPlacesFilled(std::string_view text, const std::vector<std::string>& values);

/// What the world did wrong (a file, a value, a geometry that cannot be), in a sentence that a person can act on.
/// what() is English.
class Problem : public std::runtime_error {
public:
    explicit Problem(Message message)
        : std::runtime_error(message.english())
        , m_message(std::move(message))
    {
    }

    const Message& message() const { return m_message; }

private:
    Message m_message;
};

/// Of a Problem its message; of any other exception what() as it is.
Message messageOf(const std::exception& error);

} // namespace knead
