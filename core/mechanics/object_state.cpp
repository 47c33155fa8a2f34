#include "core/mechanics/object_state.h"

#include "core/task/block_sums.h"

#include <cmath>
#include <limits>

namespace knead {

double largestSpeed(const ObjectState& state)
{
    constexpr std::size_t blockSize = 4096;
    const std::vector<double> squares =
        ofEachBlock<double>(state.size(), blockSize, [&](std::size_t begin, std::size_t end) {
            double largest = 0;
            for (std::size_t i = begin; i < end; ++i) {
                const double squared = state.velocity.at(i).squaredNorm();
                if (!(squared <= largest))
                    largest = std::isfinite(squared) ? squared : std::numeric_limits<double>::infinity();
            }
            return largest;
        });
    return squares.empty() ? 0 : std::sqrt(*std::max_element(squares.begin(), squares.end()));
}

ObjectState objectsAtRest(const Aggregate& aggregate)
{
    ObjectState state;
    const std::size_t count = aggregate.size();
    for (VectorArray* array : {&state.position, &state.velocity, &state.force, &state.damping})
        array->resize(count);
    state.mass.resize(count);
    state.inverseMass.resize(count);
    for (ObjectIndex i = 0; i < count; ++i)
        state.position.set(i, aggregate.lattice.position(i));
    return state;
}

} // namespace knead
