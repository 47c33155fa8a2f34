#pragma once

#include "core/geometry/vec3.h"

#include <pybind11/numpy.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace knead::python {

/// Numbers that lie in memory of ours, as an array of NumPy that nobody may write to. Nothing is copied: the array holds on to the owner.
/// @param strides [bytes]
template <typename Number>
pybind11::array keptArray(const Number* data, std::vector<pybind11::ssize_t> shape,
                          std::vector<pybind11::ssize_t> strides, std::shared_ptr<const void> owner)
{
    using Owner = std::shared_ptr<const void>;
    const pybind11::capsule keeper(new Owner(std::move(owner)), [](void* kept) { delete static_cast<Owner*>(kept); });
    pybind11::array array(pybind11::dtype::of<Number>(), std::move(shape), std::move(strides), data, keeper);
    array.attr("setflags")(pybind11::arg("write") = false);
    return array;
}

/// One number each.
template <typename Number>
pybind11::array keptArray(const std::vector<Number>& numbers, std::shared_ptr<const void> owner)
{
    return keptArray(numbers.data(), {static_cast<pybind11::ssize_t>(numbers.size())}, {sizeof(Number)},
                     std::move(owner));
}

/// Three coordinates each.
inline pybind11::array keptArray(const std::vector<Vec3>& places, std::shared_ptr<const void> owner)
{
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    return keptArray(places.empty() ? nullptr : places.front().data(),
                     {static_cast<pybind11::ssize_t>(places.size()), 3}, {sizeof(Vec3), sizeof(double)},
                     std::move(owner));
}

} // namespace knead::python
