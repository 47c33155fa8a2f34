#pragma once

#include <string>
#include <vector>

namespace knead {

/// What a person may choose about an import.
struct ImportOptions {
    double linearDeflection = 0; ///< chord error of the tessellation [m]; 0: relativeDeflection of each part's diagonal
    double relativeDeflection = 5e-4;
    double angularDeflection = 0.2; ///< [rad]
    bool heal = true;               ///< false: shapes stay as they are in the file
    std::string unit;               ///< that lengths are taken in, whatever the file says; empty: as stated, or mm
    std::vector<std::string> parts; ///< Part::path of those wanted, or of assemblies; empty: all
};

} // namespace knead
