#pragma once

#include <string>

namespace knead {

/// Where the time of the bare calls went [s].
struct BareTimes {
    double reading = 0;
    double transfer = 0; ///< making shapes and an XCAF document of them
    double meshing = 0;
};

/// What a program does that calls OpenCASCADE and nothing else: reads a STEP, IGES or BREP file and triangulates each solid
/// (and what belongs to none) with the deflection that importFile() takes by default. No checks, no measures, no healing.
/// @param parallel whether BRepMesh takes all cores
/// @throws std::runtime_error when the file cannot be read
BareTimes bareImport(const std::string& path, bool parallel);

} // namespace knead
