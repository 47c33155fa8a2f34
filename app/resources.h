#pragma once

#include <string>

namespace knead {

/// The folder with examples, materials and the handbook: $KNEAD_RESOURCES, else share/knead in the nearest folder above the
/// program that has one. The installed program finds it beside bin, a program of the build tree at the top of that.
/// @throws std::runtime_error when neither exists, naming what was looked for.
std::string resourcesFolder();

/// The program whose resources these are: by default the running one. For programs that are not knead, such as Python.
void setProgramWithResources(const std::string& path);

/// The bundled materials. @throws as resourcesFolder()
std::string materialsFile();

} // namespace knead
