#pragma once

#include "core/model/part.h"
#include "io/export/exact_part.h"

#include <TopoDS_Shape.hxx>

#include <vector>

namespace knead {

/// Measures how far the faces that were read back are from where the map takes those of the source: inside, on their borders,
/// and where their fit was worst; more closely on faces whose fit fell short. The one number of the report is what is
/// found, and remarks name the faces that are off by more than was allowed.
/// @param back as it was read, its faces in the order in which they were written [mm]
/// @return how far each face of the source is off [m]; 0 for those that are triangles
std::vector<double> measureDeviation(const ReadyPart& written, const TopoDS_Shape& back, PartExportReport& report);

/// Measures how far the triangles in the place of some faces are from the skin, both ways.
/// @param backs as they were read, their faces in the order in which they were written
/// @return false when nothing says which face is which
bool measurePatches(const ReadyPart& written, const std::vector<const Part*>& backs, PartExportReport& report);

/// Measures how far flat faces that were read back and the skin are from each other, both ways.
/// @param skin closed, finely divided [m]
void measureFlatDeviation(const TriangleMesh& skin, const std::vector<const Part*>& backs, PartExportReport& report);

} // namespace knead
