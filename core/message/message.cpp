#include "core/message/message.h"

#include <algorithm>
#include <cassert>

namespace knead {

namespace {

constexpr std::size_t longestSentence = 1U << 16U; // [bytes]

} // namespace

Message Message::sequence(std::vector<Message> sentences)
{
    std::erase_if(sentences, [](const Message& sentence) { return sentence.empty(); });
    assert(sentences.size() <= 9);
    if (sentences.size() == 1)
        return std::move(sentences.front());
    Message all;
    for (std::size_t i = 0; i < sentences.size(); ++i)
        all.m_text += (i == 0 ? "%" : " %") + std::to_string(i + 1);
    all.m_arguments = std::move(sentences);
    return all;
}

Message Message::withAll(std::vector<Message> arguments) const
{
    Message filled = *this;
    filled.m_arguments = std::move(arguments);
    return filled;
}

std::string Message::english() const
{
    if (m_arguments.empty())
        return m_text;
    std::vector<std::string> values;
    values.reserve(m_arguments.size());
    for (const Message& argument : m_arguments)
        values.push_back(argument.english());
    return withPlacesFilled(m_text, values);
}

std::string withPlacesFilled(std::string_view text, const std::vector<std::string>& values)
{
    std::string filled;
    for (std::size_t i = 0; i < text.size() && filled.size() < longestSentence; ++i) {
        const bool isPlace = text[i] == '%' && i + 1 < text.size() && text[i + 1] >= '1' && text[i + 1] <= '9';
        const std::size_t place = isPlace ? static_cast<std::size_t>(text[i + 1] - '1') : values.size();
        if (place < values.size()) {
            filled.append(values[place], 0, longestSentence);
            ++i;
        } else {
            filled += text[i];
        }
    }
    return filled;
}

Message messageOf(const std::exception& error)
{
    const auto* problem = dynamic_cast<const Problem*>(&error);
    return problem != nullptr ? problem->message() : Message::verbatim(error.what());
}

} // namespace knead
