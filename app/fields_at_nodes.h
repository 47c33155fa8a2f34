#pragma once

#include "core/session/nodal_states.h"
#include "core/task/task_control.h"
#include "io/fields/nodal_mesh.h"
#include "io/fields/solver_include.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace knead {

/// What a person wants to know at the nodes of a mesh, and where it is written.
struct FieldsRequest {
    std::string nodes; ///< file with the mesh; empty: nothing is wanted
    std::string unit;  ///< of lengths in it; empty: that which it says, else mm
    NodesAt at = NodesAt::rest;
    std::vector<std::string> fields; ///< words of fieldWords(); none: all that are known but for the velocity
    Solver solver = Solver::calculix;
    std::string output; ///< .vtu, .csv or .inp
};

/// What was written.
struct WrittenFields {
    std::vector<std::string> names; ///< of the fields, as in the file
    std::size_t nodes = 0;
    std::size_t outside = 0;         ///< nodes outside of all bodies
    double farthest = 0;             ///< of these from the nearest body [m]
    std::vector<std::size_t> ofBody; ///< how many nodes are of each
    double largestDisplacement = 0;  ///< at a node [m]
    double largestStress = 0;        ///< von Mises, at a node [Pa]
    std::vector<Message> warnings;
};

/// Adds the arguments for it to a command. @param unit how the one for the unit is called
void addFieldsArguments(CLI::App& command, FieldsRequest& request, const std::string& unit, const std::string& output);

/// Says what is wrong before anything is done: unknown words, an ending that is not written, one argument without the other.
/// @throws Problem
void checkFields(const FieldsRequest& request);

/// Tells what the material does at the nodes, and at the centers of elements for a solver, and writes it.
/// @param mesh of request.nodes @throws Problem, in a sentence; Cancelled
WrittenFields writeFieldsAtNodes(const FieldsRequest& request, const NodalMesh& mesh,
                                 std::span<const BodyAtNodes> bodies, TaskControl& control);

} // namespace knead
