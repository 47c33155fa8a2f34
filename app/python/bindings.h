#pragma once

#include <nlohmann/json_fwd.hpp>
#include <pybind11/pybind11.h>

#include <string>
#include <string_view>

namespace knead::python {

/// Each adds a part of what the module `knead` has. Called once, in this order.
void bindMaterial(pybind11::module_& module);
void bindParts(pybind11::module_& module);
void bindSimulation(pybind11::module_& module);
void bindFiles(pybind11::module_& module);

/// Finds the program that reads files and the materials, from where the module lies.
void findOwnFiles();

/// A text of Knead for Python; what is no UTF-8, as in names of files, becomes what can be read.
pybind11::str readable(std::string_view text);

/// What a JSON document says, as Python's own objects.
pybind11::object fromJson(const std::string& text);
pybind11::object fromJson(const nlohmann::ordered_json& json);

} // namespace knead::python
