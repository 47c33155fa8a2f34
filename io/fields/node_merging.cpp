#include "io/fields/node_merging.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace knead {

namespace {

/// Beyond this a number in a file is damage: larger than what anybody makes, and small enough for its square to be one [m].
constexpr double mostSensible = 1e9;
/// Places that were found as differences of numbers in single precision are one when they differ by less, of the largest.
constexpr double singlePrecision = 1e-6;

std::uint64_t hashOf(const Vec3& place)
{
    std::uint64_t hash = 0;
    for (const double coordinate : place) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) * 0x9E3779B97F4A7C15ULL;
        hash ^= hash >> 29U;
    }
    return hash;
}

/// Which of the places is where another one was before.
class Places {
public:
    explicit Places(std::size_t most)
        : m_slots(std::bit_ceil(2 * most + 2), empty)
    {
        m_keys.reserve(most);
    }

    /// The number of the place, which is new when it is as many as there were.
    std::size_t numberOf(const Vec3& key)
    {
        const std::size_t mask = m_slots.size() - 1;
        for (std::size_t slot = hashOf(key) & mask;; slot = (slot + 1) & mask) {
            if (m_slots[slot] == empty) {
                m_slots[slot] = m_keys.size();
                m_keys.push_back(key);
                return m_slots[slot];
            }
            if (m_keys[m_slots[slot]] == key)
                return m_slots[slot];
        }
    }

private:
    static constexpr std::size_t empty = static_cast<std::size_t>(-1);
    std::vector<std::size_t> m_slots;
    std::vector<Vec3> m_keys;
};

/// 0: places are one only where all digits are the same.
double grid(const FieldContent& content)
{
    if (!content.areNodesMoved)
        return 0;
    double largest = 0;
    for (const Vec3& node : content.nodes)
        if (node.allFinite())
            largest = std::max(largest, node.cwiseAbs().maxCoeff());
    return singlePrecision * largest;
}

} // namespace

bool isSensible(const Vec3& v)
{
    return v.allFinite() && v.cwiseAbs().maxCoeff() < mostSensible;
}

DisplacementField mergedField(const FieldContent& content, double metresOfNodes, double metresOfValues,
                              std::vector<Message>& warnings)
{
    const double step = metresOfNodes * grid(content);
    DisplacementField field;
    std::vector<double> counts;
    Places places(content.nodes.size());
    std::size_t missing = 0;
    for (std::size_t i = 0; i < content.nodes.size(); ++i) {
        const Vec3 value = metresOfValues * content.values[i];
        const Vec3 node = metresOfNodes * content.nodes[i] - (content.areNodesMoved ? value : Vec3::Zero());
        if (!isSensible(node) || !isSensible(value)) {
            ++missing;
            continue;
        }
        const std::size_t number = places.numberOf(step > 0 ? Vec3((node / step).array().round()) : node);
        if (number == field.nodes.size()) {
            field.nodes.push_back(node);
            field.displacements.push_back(value);
            counts.push_back(1);
        } else {
            counts[number] += 1;
            field.displacements[number] += (value - field.displacements[number]) / counts[number];
        }
    }
    if (missing > 0)
        warnings.push_back(Message("Field", "%1 of %2 nodes have no displacement and were left out.")
                               .with(missing, content.nodes.size()));
    if (const std::size_t merged = content.nodes.size() - missing - field.nodes.size(); merged > 0)
        warnings.push_back(
            Message("Field",
                    "%1 nodes lie where another one does; each such place has the mean of their displacements.")
                .with(merged));
    return field;
}

} // namespace knead
