#pragma once

#include "core/geometry/vec3.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <string>
#include <vector>

namespace knead {

/// Whose input is written: they differ in how stress at the start is told.
enum class Solver : std::uint8_t { calculix, abaqus };

/// What an input of a solver takes up of a body: where its nodes are, and what its elements bear at the start.
struct SolverInclude {
    struct Node {
        std::int64_t label = 0;
        Vec3 place = Vec3::Zero(); ///< [m]
    };
    struct Element {
        std::int64_t label = 0;
        std::vector<Mat3> stresses; ///< for CalculiX at each of its integration points, for Abaqus at its center [Pa]
        double plasticStrain = 0;   ///< equivalent, at its center
    };

    Solver solver = Solver::calculix;
    std::string unit = "mm";       ///< LengthUnit::name; stress is in newtons per square of it
    std::vector<Node> nodes;       ///< *NODE; none: no such block
    std::vector<Element> elements; ///< *INITIAL CONDITIONS, TYPE=STRESS; none: no such block
    bool hasFlow = false; ///< plastic strain, too: *INITIAL CONDITIONS, TYPE=HARDENING, which CalculiX does not know
};

/// Writes a file for *INCLUDE. Numbers have 12 digits, since CalculiX looks at 20 letters of each. It appears whole or not at all.
/// @throws Problem that names the file and why the disk refused. @throws Cancelled
void writeSolverInclude(const std::string& path, const SolverInclude& include,
                        TaskControl& control = TaskControl::none());

} // namespace knead
