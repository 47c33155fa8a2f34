#pragma once

#include "core/geometry/vec3.h"

#include <string>
#include <vector>

namespace knead {

/// What a person may choose about an import.
struct ImportOptions {
    double linearDeflection = 0;      ///< chord error of the tessellation [m]; 0: relativeDeflection
    double angularDeflection = 0.2;   ///< [rad]
    double relativeDeflection = 5e-4; ///< of the diagonal of each part, where linearDeflection is 0
    bool heal = true;                 ///< false: shapes stay as they are in the file
    bool capsFlatOpenings = false;    ///< closes surfaces whose openings are all flat with planes; needs heal
    /// Of STEP: no names, colors and assemblies. The reader chooses that where reading these crashes; it is not kept.
    bool onlyShapes = false;
    std::string unit;               ///< that lengths are taken in, whatever the file says; empty: as stated, or mm
    std::vector<std::string> parts; ///< Part::path of those wanted, or of assemblies; empty: all
    Vec3 shift = Vec3::Zero();      ///< that parts are moved by [m]
    double memoryLimit = 0;         ///< of the process that reads [bytes]; 0: by the size of the file
    double timeLimit = 0;           ///< of processor time for reading [s]; 0: by the size of the file

    friend bool operator==(const ImportOptions&, const ImportOptions&) = default;
};

} // namespace knead
