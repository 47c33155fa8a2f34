#pragma once

#include "core/geometry/vec3.h"
#include "core/task/task_control.h"
#include "io/fields/nodal_mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace knead {

/// Values at nodes, to be written for other programs.
struct NodalFields {
    struct Array {
        std::string name; ///< with its unit, as it is to be shown: "displacement [mm]"
        int components = 3;
        std::vector<double>
            values; ///< components of the first node, of the second ..., in that unit; no number: not known
    };

    std::vector<Vec3> nodes;          ///< X, where they were before anything moved [m]
    std::vector<std::int64_t> labels; ///< their numbers in another program; empty: none
    std::string unit = "mm";          ///< LengthUnit::name in which nodes are written
    std::vector<Array> arrays;        ///< components of one node are 1, 3, or 6 as xx, yy, zz, xy, yz, xz
    NodalCells cells;                 ///< VTU only; where there are none each node is a cell of its own
};

/// Writes .vtu (XML, numbers in double precision appended as they lie in memory) or .csv (a line per node: `node`, `X [mm]` ...,
/// then a column per component, as `displacement x [mm]`). The file appears whole or not at all. readField() takes up both.
/// @throws Problem, which names the file: another ending, an array of another length, or why the disk refused. @throws Cancelled
void writeFields(const std::string& path, const NodalFields& fields, TaskControl& control = TaskControl::none());

} // namespace knead
