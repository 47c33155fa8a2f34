#include "core/geometry/assignment.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace knead {

namespace {

constexpr std::uint32_t nobody = 0xffffffffU;
constexpr double unreached = std::numeric_limits<double>::infinity();

/// Rows are items; columns are the others, and behind them one for each item that stays alone.
class Pairing {
public:
    Pairing(std::span<const std::vector<PairingOption>> options, std::size_t others, double costOfNone)
        : m_options(options)
        , m_others(others)
        , m_costOfNone(costOfNone)
        , m_rowPrice(options.size(), 0)
        , m_columnPrice(others + options.size(), 0)
        , m_rowOf(others + options.size(), nobody)
        , m_columnOf(options.size(), nobody)
    {
    }

    std::vector<std::optional<std::uint32_t>> solve(const TaskControl& control)
    {
        for (std::uint32_t row = 0; row < m_options.size(); ++row) {
            control.throwIfCancelled();
            augment(row);
        }
        std::vector<std::optional<std::uint32_t>> partners;
        for (const std::uint32_t column : m_columnOf)
            partners.push_back(column < m_others ? std::optional(column) : std::nullopt);
        return partners;
    }

private:
    using Reached = std::pair<double, std::uint32_t>; // cost, column

    /// Dijkstra on reduced costs from a row that is alone to the nearest column that is free.
    void augment(std::uint32_t row)
    {
        m_distance.assign(m_rowOf.size(), unreached);
        m_from.assign(m_rowOf.size(), nobody);
        m_isSettled.assign(m_rowOf.size(), false);
        m_queue = {};
        std::vector<std::uint32_t> settled;
        leave(row, 0);
        std::uint32_t end = nobody;
        while (end == nobody) {
            const auto [distance, column] = m_queue.top();
            m_queue.pop();
            if (m_isSettled[column])
                continue;
            m_isSettled[column] = true; // rounding must not lead back
            if (m_rowOf[column] == nobody) {
                end = column;
            } else {
                settled.push_back(column);
                leave(m_rowOf[column], distance);
            }
        }
        const double length = m_distance[end];
        m_rowPrice[row] += length;
        for (const std::uint32_t column : settled) {
            m_rowPrice[m_rowOf[column]] += length - m_distance[column];
            m_columnPrice[column] -= length - m_distance[column];
        }
        for (std::uint32_t column = end; column != nobody;) {
            const std::uint32_t owner = m_from[column];
            m_rowOf[column] = owner;
            column = std::exchange(m_columnOf[owner], column);
        }
    }

    void leave(std::uint32_t row, double distance)
    {
        const auto reach = [&](std::uint32_t column, double cost) {
            const double there = distance + cost - m_rowPrice[row] - m_columnPrice[column];
            if (!m_isSettled[column] && there < m_distance[column]) {
                m_distance[column] = there;
                m_from[column] = row;
                m_queue.emplace(there, column);
            }
        };
        for (const PairingOption& option : m_options[row])
            reach(option.other, option.cost);
        reach(static_cast<std::uint32_t>(m_others + row), m_costOfNone);
    }

    std::span<const std::vector<PairingOption>> m_options;
    std::size_t m_others;
    double m_costOfNone;
    std::vector<double> m_rowPrice;
    std::vector<double> m_columnPrice;
    std::vector<std::uint32_t> m_rowOf; // per column
    std::vector<std::uint32_t> m_columnOf;
    std::vector<double> m_distance; // per column
    std::vector<std::uint32_t> m_from;
    std::vector<bool> m_isSettled;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> m_queue;
};

} // namespace

std::vector<std::optional<std::uint32_t>> leastCostPairs(std::span<const std::vector<PairingOption>> options,
                                                         std::size_t others, double costOfNone,
                                                         const TaskControl& control)
{
    return Pairing(options, others, costOfNone).solve(control);
}

} // namespace knead
