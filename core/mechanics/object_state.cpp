#include "core/mechanics/object_state.h"

namespace knead {

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
