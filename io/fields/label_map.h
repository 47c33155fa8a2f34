#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace knead {

/// Where nodes stand that another program numbers. Quick for those who ask in the order of the list.
class LabelMap {
public:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /// @param labels outlive this
    explicit LabelMap(const std::vector<std::int64_t>& labels)
        : m_labels(labels)
    {
    }

    /// The place of the label in the list, or `none`.
    std::size_t find(std::int64_t label)
    {
        if (m_next < m_labels.size() && m_labels[m_next] == label)
            return m_next++;
        if (m_places.empty())
            for (std::size_t i = 0; i < m_labels.size(); ++i)
                m_places.emplace(m_labels[i], i);
        const auto found = m_places.find(label);
        if (found == m_places.end())
            return none;
        m_next = found->second + 1;
        return found->second;
    }

private:
    const std::vector<std::int64_t>& m_labels;
    std::unordered_map<std::int64_t, std::size_t> m_places;
    std::size_t m_next = 0; ///< where the next one probably is
};

} // namespace knead
