#pragma once

#include "core/model/field_file.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace knead {

/// Faces of parts, by the names of the parts and the numbers of the faces.
using FacesOfParts = std::vector<std::pair<std::string, std::vector<std::uint32_t>>>;

/// How a compensation goes from round to round, see nextCompensation().
struct CompensationMethod {
    double tolerance = 0;  ///< largest deviation that is good enough [m], > 0
    int rounds = 6;        ///< at most
    double factor = 1;     ///< of what is taken back of a deviation
    double smoothing = 0;  ///< deviations are smoothed over this distance [m]; 0: taken as they are
    bool fitsBest = false; ///< deviations are what is left when what came out is moved rigidly to where it fits best
};

/// What is to come out right, and how to find out what comes out. SI units.
struct CompensationStudy {
    std::string file;   ///< where it was read from
    std::string part;   ///< the target: path of a CAD or mesh file, ready to open
    FacesOfParts faces; ///< that count; empty: all
    double spacing = 0; ///< of the points that the compensation knows [m]; 0: chosen
    CompensationMethod method;

    std::string recipe;               ///< path; empty: a command
    std::vector<std::string> command; ///< words, with placeholders; empty: a recipe
    std::vector<std::string> files;   ///< paths, which each round gets with their placeholders filled
    std::string field;                ///< name of the file that the command writes
    FieldChoice choice;               ///< which field of it
    double meshSpacing = 0;           ///< of {mesh} [m]; 0: chosen
    double timeLimit = 3600;          ///< of a round's command [s]
};

} // namespace knead
