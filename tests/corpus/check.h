#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace knead::corpus {

/// Looks at an exported STEP file and at the STL of the same moment with OpenCASCADE alone, as another program would: solids,
/// faces, free edges, validity, volume, largest tolerance, names, colors, and how far the two are from each other, both ways.
/// Lengths in mm.
/// @return an object; with the member "error" where the file could not be read
nlohmann::ordered_json checkFiles(const std::string& step, const std::string& stl);

} // namespace knead::corpus
