#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/cut_cells.h"
#include "core/task/task_control.h"

namespace knead {

/// Gives the connections of an aggregate weights that have the moments of the material, so that walls bend and twist as they should.
///
/// A connection of cut-cell weight stands for the mean of the cells around it, as if their material filled them evenly. Its
/// sum is right, but a wall gets a second moment that is too large: by 1.1 / n^2 for n cells across when the lattice divides
/// it, by up to three times that when not. Here each family of parallel connections, at their middles x_b, gets
///   sum w_b p(x_b) = integral over the material of p + softness a^2 / 2 (p_uu + p_vv + p_ww)
/// for quadratic p, in blocks of two cells per axis: what their cut cells lack is spread over the connections around them
/// (MomentSpread). Of full cells only the sides to others count, as between two full cells what one has too much the other takes.
///
/// Diagonal connections across a wall of less than three cells have two layers of middles at most, and so one second moment
/// whatever their weights, too small at two cells and too large at one. Connections along the axes make up for that.
///
/// Walls of more than 8 cells keep their weights, which are right to 3 % there. So do lumps, which go on for no more than one and a half
/// times their thickness: their ends would be weaker than their middle, and flow by 8 % too early where a plate presses them. Between them
/// it passes over, see WallMeasure. Sides that are skin are fitted up to four whole cells in lumps too: what leads inwards keeps its weights
/// there.
/// The volume of an object is an eighteenth of the weights of its connections, as before, so that no object is light against
/// its springs; they sum to the volume of all cells, the weights of each family to it over a^3.
///
/// Measured on square bars of material that does not yield (nu = 1/4) in steps of a twentieth of a cell, stiffness by beam theory's,
/// along the lattice, at 29 degrees across it, and tilted in three axes: bending .90 to 1.10 from 1.75 cells on, up to 1.20 from 1.3,
/// and from one cell on up to 1.23, tilted in three axes 1.48. Torsion from two cells on up to 1.15 along the lattice, 1.19 at 29
/// degrees, 1.13 tilted; from three on up to 1.15, 1.11 and 1.07. Material that yields has another law for its objects: with a former
/// fit it bent by .91 to 1.10 from 1.75 cells on.
/// Uniform strain, exact before along the lattice, is up to 3 % too soft in cut walls there, .3 % in bars of four whole cells:
/// families are fitted one by one, which leaves small forces at the skin. Sheets of whole cells stay exact: see ThinBlock.
/// The result does not depend on the number of threads.
/// @param aggregate with the weights of joinCells() from the same cells
/// @throws Cancelled
Aggregate withFittedMoments(const CutCells& cells, Aggregate aggregate, TaskControl& control);

} // namespace knead
