#pragma once

#include "core/geometry/vec3.h"
#include "core/message/message.h"
#include "core/model/field_file.h"
#include "core/task/task_control.h"
#include "io/fields/nodal_mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// What is wanted of a file: displacements as they are chosen, or nodes and cells alone.
struct FieldRequest {
    FieldChoice choice;
    bool isForMesh = false;
};

/// What a file holds, in its own units and order.
struct FieldContent {
    std::string format;               ///< as FieldFile::format
    std::vector<Vec3> nodes;          ///< not finite where the file says nothing
    std::vector<std::int64_t> labels; ///< may be empty
    std::string unit;                 ///< of nodes, as the file writes it; empty: not said
    NodalCells cells;                 ///< for those who want the mesh

    std::vector<std::string> steps;
    std::vector<std::string> names;
    std::size_t step = 0;
    std::string name;
    std::vector<Vec3> values;   ///< one per node, not finite where there is none; empty for those who want the mesh
    std::string valueUnit;      ///< as unit; empty: that of the nodes
    bool areNodesMoved = false; ///< nodes are where they came to lie: X = x - u
    std::vector<Message> warnings;
};

/// Vec3 that says nothing: not finite.
Vec3 noVector();

/// Which of `count` steps is meant, the last where nothing is said.
/// @throws Problem, when there are not as many
std::size_t chosenStep(const FieldChoice& choice, std::size_t count);

/// Which of the names is meant. Where nothing is said: the only one, else the first that is a word for displacements.
/// @throws Problem: there is none, or no such one, or several could be meant
std::size_t chosenName(const FieldChoice& choice, const std::vector<std::string>& names);

/// Sets what of the content is chosen. @pre content.steps and names are set. @throws as the two above
void choose(const FieldChoice& choice, FieldContent& content);

/// The unit at the end of a name such as "displacement [mm]" or "X (in)"; empty when there is no known one.
std::string unitIn(std::string_view name);

/// "displacement" of "displacement [mm]": the name without what is in brackets at its end.
std::string_view withoutUnit(std::string_view name);

/// A number as names of time steps have it: "0.25".
std::string shortNumber(double number);

/// Appends three numbers at a time. @throws Problem, when some are left over
void appendVectors(std::span<const double> numbers, std::vector<Vec3>& vectors);

/// @throws Problem, when there is not one value per node
void checkCount(const std::string& name, std::size_t values, std::size_t nodes);

/// Makes places in `nodes` of the labels that stand in the cells. @throws Problem, when a node is missing
void connectCells(FieldContent& content);

/// @throws Problem: the file is damaged, whatever the place
[[noreturn]] void failAsDamaged();

// Each reads the bytes of a file of its format. @throws Problem without the name of the file; Cancelled
FieldContent readFrd(std::string_view bytes, const FieldRequest& request, TaskControl& control);
FieldContent readLegacyVtk(std::string_view bytes, const FieldRequest& request, TaskControl& control);
FieldContent readXmlVtk(std::string_view bytes, const FieldRequest& request, TaskControl& control);
FieldContent readGmsh(std::string_view bytes, const FieldRequest& request, TaskControl& control);
FieldContent readTable(std::string_view bytes, const FieldRequest& request, TaskControl& control);
FieldContent readReport(std::string_view bytes, const FieldRequest& request, TaskControl& control);
FieldContent readInput(std::string_view bytes, const FieldRequest& request, TaskControl& control);

} // namespace knead
