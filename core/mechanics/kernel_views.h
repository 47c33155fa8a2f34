#pragma once

#include "core/kernels/kernels.h"
#include "core/mechanics/vector_array.h"

namespace knead::kernels {

/// The vectors of an array from object `first` on, as kernels take them.
inline ConstVectors from(const VectorArray& array, std::size_t first)
{
    return {array.component(0) + first, array.component(1) + first, array.component(2) + first};
}
inline Vectors into(VectorArray& array, std::size_t first)
{
    return {array.component(0) + first, array.component(1) + first, array.component(2) + first};
}

} // namespace knead::kernels
