#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/geometry/vec3.h"
#include "core/message/message.h"
#include "core/task/task_control.h"

namespace knead {

/// How finely bodies are filled, as a person says it.
struct SpacingChoice {
    enum class Kind {
        Length,          ///< value is the lattice spacing [m]
        CellsAlong,      ///< value is the number of cells along the longest side of the box around all bodies
        CellsAcrossWall, ///< value is the number of cells across the thinnest wall of any body
        Objects          ///< value is the wanted number of objects of all bodies together
    };
    Kind kind = Kind::CellsAlong;
    double value = 0;
};

/// What a spacing is chosen by.
struct FillingSize {
    double volume = 0;       ///< [m^3]
    double area = 0;         ///< [m^2]
    double thinnestWall = 0; ///< as wallThickness() finds it; 0: not measured [m]
    Box box;                 ///< [m]

    /// Of several bodies together.
    void add(const FillingSize& other);
};

/// Without the walls, which take longer.
FillingSize sizeOf(const TriangleMesh& mesh);
/// With them. @throws Cancelled
FillingSize sizeWithWalls(const TriangleMesh& mesh, TaskControl& control = TaskControl::none());

/// About how many objects fill() makes: one per cell of the volume, and for the corners of cut cells a layer over the
/// surface, measured as 0.95 to 1.05 cells thick for solids and sheets of any orientation.
double estimatedObjects(const FillingSize& size, double spacing);

/// The spacing that a choice means [m].
/// @pre the value is above 0, and for CellsAcrossWall the walls are measured; else it is 0
double spacingFor(const SpacingChoice& choice, const FillingSize& size);

/// What a spacing leads to.
struct SpacingAssessment {
    double cellsAcrossWall = 0; ///< the thinnest one
    double objects = 0;         ///< about
    double bytes = 0;           ///< of memory for aggregates, simulation and snapshots, about
    double advisedSpacing = 0;  ///< that serves the thinnest wall; 0: this one does [m]
    Message warning;            ///< a sentence when the thinnest wall has too few cells; else empty
};

constexpr double fewestCellsAcrossWall = 1.75; ///< with fewer, bending of the wall may be far too stiff
constexpr double advisedCellsAcrossWall = 2;   ///< bending and twisting are right within 15 %
constexpr double goodCellsAcrossWall = 3;      ///< stress at the skin begins to be as well

/// By how much bending of a wall may come out too stiff at worst, as a share of its stiffness: 0.2 is 20 %. Measured on
/// bars of every thickness at twelve tilts, of material that yields too; infinite below one cell.
double bendingErrorOf(double cellsAcross);

/// Without a warning when no wall is measured.
SpacingAssessment assessSpacing(double spacing, const FillingSize& size);

} // namespace knead
