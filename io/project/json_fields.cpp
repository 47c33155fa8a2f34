#include "io/project/json_fields.h"

#include "core/message/message.h"
#include "io/json/exact_number.h"
#include "io/json/json_text.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr std::uint64_t largestWhole = (1ULL << 53U) - 1; // beyond it doubles leave numbers out

double numberIn(const JsonNode& node)
{
    if (!node.isString())
        return node.number();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return readChoice<double>(
        node, {{"infinity", infinity}, {"-infinity", -infinity}, {"nan", std::numeric_limits<double>::quiet_NaN()}});
}

template <std::size_t count>
std::array<double, count> numbersIn(const JsonNode& node)
{
    const std::vector<JsonNode> items = node.items();
    if (items.size() != count)
        node.failExpecting(Message("Recipe", "must hold %1 numbers").with(count));
    std::array<double, count> numbers;
    std::transform(items.begin(), items.end(), numbers.begin(), numberIn);
    return numbers;
}

std::uint32_t indexIn(const JsonNode& node)
{
    return static_cast<std::uint32_t>(node.count(std::numeric_limits<std::uint32_t>::max()));
}

} // namespace

std::uint32_t ToolPartTable::numberOf(const std::shared_ptr<const ToolPart>& part)
{
    const auto found = std::find(m_parts.begin(), m_parts.end(), part);
    const auto number = static_cast<std::uint32_t>(found - m_parts.begin());
    if (found == m_parts.end())
        m_parts.push_back(part);
    return number;
}

// --- writing ----------------------------------------------------------------------------------------------------------

void FieldWriter::operator()(const char* key, const std::shared_ptr<const ToolPart>& value)
{
    if (value != nullptr)
        (*this)(key, m_tools.numberOf(value));
}

// --- reading ----------------------------------------------------------------------------------------------------------

void FieldReader::operator()(const char* key, double& value) const
{
    value = numberIn(m_node.at(key));
}

void FieldReader::operator()(const char* key, std::uint32_t& value) const
{
    value = indexIn(m_node.at(key));
}

void FieldReader::operator()(const char* key, std::uint64_t& value) const
{
    value = m_node.at(key).count(largestWhole);
}

void FieldReader::operator()(const char* key, std::vector<std::string>& value) const
{
    value.clear();
    for (const JsonNode& item : m_node.at(key).items())
        value.push_back(item.anyText());
}

void FieldReader::operator()(const char* key, std::optional<double>& value) const
{
    const std::optional<JsonNode> node = m_node.find(key);
    value = node ? std::optional(numberIn(*node)) : std::nullopt;
}

void FieldReader::operator()(const char* key, Vec3& value) const
{
    const auto numbers = numbersIn<3>(m_node.at(key));
    value = {numbers[0], numbers[1], numbers[2]};
}

void FieldReader::operator()(const char* key, Quaternion& value) const
{
    const auto numbers = numbersIn<4>(m_node.at(key));
    value = {numbers[0], numbers[1], numbers[2], numbers[3]};
}

void FieldReader::operator()(const char* key, std::vector<std::uint32_t>& value) const
{
    value.clear();
    const auto add = [&](const JsonNode& item, std::uint64_t first, std::uint64_t last) {
        if (last < first)
            item.failExpecting(Message("Recipe", "must hold the first and the last number of a stretch"));
        if (last - first >= m_longList)
            item.failExpecting(Message("Recipe", "makes a list longer than any that this program writes"));
        m_longList -= last - first + 1;
        for (std::uint64_t number = first; number <= last; ++number)
            value.push_back(static_cast<std::uint32_t>(number));
    };
    for (const JsonNode& item : m_node.at(key).items()) {
        if (!item.isList()) {
            add(item, indexIn(item), indexIn(item));
            continue;
        }
        const std::vector<JsonNode> ends = item.items();
        if (ends.size() != 2)
            item.failExpecting(Message("Recipe", "must hold the first and the last number of a stretch"));
        add(item, indexIn(ends[0]), indexIn(ends[1]));
    }
}

void FieldReader::operator()(const char* key, std::shared_ptr<const ToolPart>& value) const
{
    value = nullptr;
    const std::optional<JsonNode> node = m_node.find(key);
    if (!node)
        return;
    const std::uint32_t number = indexIn(*node);
    if (number >= m_tools.parts().size() || m_tools.parts()[number] == nullptr)
        node->failExpecting(Message("Recipe", "must be the number of a tool part of the project"));
    value = m_tools.parts()[number];
}

} // namespace knead
