#include "app/python/bindings.h"
#include "app/python/handles.h"
#include "app/python/kept_array.h"
#include "app/python/script_control.h"
#include "core/skin/deformed_surface.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <utility>

namespace py = pybind11;

namespace knead::python {

namespace {

constexpr std::size_t mostTriangles = 400'000; // of a surface

const Snapshot::BodyState& stateOf(const SeenState& state, BodyId body)
{
    return state.snapshot().bodies[body];
}

py::array positions(const BodyHandle& handle)
{
    const SeenStatePointer state = withoutLock([&] { return handle.simulation->state(); });
    return keptArray(stateOf(*state, handle.body).positions, state);
}

py::array displacements(const BodyHandle& handle)
{
    SeenStatePointer state;
    const std::vector<Vec3>* moved = nullptr;
    withoutLock([&] {
        state = handle.simulation->state();
        moved = &state->displacements(handle.body);
    });
    return keptArray(*moved, state);
}

/// One of the matrices of all objects, (n, 3, 3): they lie in what core made.
py::array matrices(const BodyHandle& handle, Mat3 ObjectStrain::*which)
{
    SeenStatePointer state;
    const std::vector<ObjectStrain>* strains = nullptr;
    withoutLock([&] {
        state = handle.simulation->state();
        strains = &state->strains(handle.body);
    });
    return keptArray(strains->empty() ? nullptr : (strains->front().*which).data(),
                     {static_cast<py::ssize_t>(strains->size()), 3, 3},
                     {sizeof(ObjectStrain), sizeof(double), 3 * sizeof(double)}, state);
}

py::array vonMises(const BodyHandle& handle)
{
    SeenStatePointer state;
    const std::vector<double>* stresses = nullptr;
    withoutLock([&] {
        state = handle.simulation->state();
        stresses = &state->vonMises(handle.body);
    });
    return keptArray(*stresses, state);
}

/// Vertices and triangles of the skin where the objects have taken it.
std::pair<py::array, py::array> surface(const BodyHandle& handle, py::object progress)
{
    const auto mesh = computing(std::move(progress), [&](TaskControl& control) {
        const SeenStatePointer state = handle.simulation->state();
        return std::make_shared<const TriangleMesh>(deformedSurface(
            *handle.simulation->bodies()[handle.body]->body.surface, *stateOf(*state, handle.body).aggregate,
            state->displacements(handle.body), mostTriangles, control));
    });
    const std::vector<TriangleMesh::Triangle>& triangles = mesh->triangles;
    return {keptArray(mesh->vertices, mesh), keptArray(triangles.empty() ? nullptr : triangles.front().data(),
                                                       {static_cast<py::ssize_t>(triangles.size()), 3},
                                                       {sizeof(TriangleMesh::Triangle), sizeof(std::uint32_t)}, mesh)};
}

} // namespace

void bindBodies(py::module_& module)
{
    py::class_<BodyHandle>(module, "Body",
                           "A body of a simulation. Its arrays are of the moment in which they are asked for: they "
                           "stay as they are while the "
                           "simulation goes on, and are good for as long as one keeps them. Asked for again before "
                           "anything has changed, they are "
                           "the same memory. Nothing is copied for them, and nobody may write to them. Where material "
                           "that yields is filled anew, "
                           "there are other objects from then on.")
        .def_property_readonly(
            "filling", [](const BodyHandle& handle) { return handle.simulation->bodies()[handle.body]; },
            "What it began as.")
        .def_property_readonly(
            "name", [](const BodyHandle& handle) { return handle.simulation->bodies()[handle.body]->body.name; })
        .def_property_readonly("positions", &positions, "Places of its objects [m], (n, 3).")
        .def_property_readonly("displacements", &displacements, "Of its objects, from rest [m], (n, 3).")
        .def_property_readonly(
            "strains", [](const BodyHandle& handle) { return matrices(handle, &ObjectStrain::strain); },
            "Hencky strain of the material around each object, ln sqrt(F F^T), plastic flow included, (n, 3, 3).")
        .def_property_readonly(
            "stresses", [](const BodyHandle& handle) { return matrices(handle, &ObjectStrain::stress); },
            "Cauchy stress of the material around each object [Pa], (n, 3, 3).")
        .def_property_readonly("von_mises", &vonMises, "Equivalent stress of each object [Pa], (n,).")
        .def("surface", &surface, py::arg("progress") = py::none(),
             "Its skin as triangles, fine enough to bend: places of the vertices [m] and three vertices each. Computed "
             "anew "
             "with each call.")
        .def("__repr__", [](const BodyHandle& handle) {
            return "<knead.Body \"" + handle.simulation->bodies()[handle.body]->body.name + "\">";
        });
}

} // namespace knead::python
