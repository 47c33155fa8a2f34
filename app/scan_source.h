#pragma once

#include "core/model/field_file.h"
#include "core/model/part.h"

#include <string>
#include <vector>

namespace knead {

/// What a scan is of.
struct ScannedParts {
    const Model& model;
    const std::vector<bool>& which; ///< per part of the model
    bool isInPlace = false;         ///< the scan has the axes of the parts, and is not moved
};

/// How far a scanned surface is from parts, as a field at their surfaces: it is laid over them as a rigid thing first, where it is not in place.
/// @param unit of lengths in the file, as ImportOptions::unit; empty: as the file says, else mm
/// @throws std::runtime_error, in a sentence; Cancelled
FieldFile readScan(const std::string& path, const std::string& unit, const ScannedParts& parts, TaskControl& control);

} // namespace knead
