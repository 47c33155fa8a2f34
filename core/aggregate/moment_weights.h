#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/cut_cells.h"
#include "core/task/task_control.h"

namespace knead {

/// Gives the connections of an aggregate weights that have the moments of the material, so that walls bend as they should.
///
/// A connection of cut-cell weight stands for the mean of the cells around it, as if their material filled them evenly. Its
/// sum is right, but a wall gets a second moment that is too large: by 1.1 / n^2 for n cells across when the lattice divides
/// it, by up to three times that when not. Here each family of parallel connections, at their middles x_b, gets
///   sum w_b p(x_b) = integral over the material of p + 0.025 a^2 / 2 (p_uu + p_vv + p_ww)
/// for quadratic p, cell by cell: what a cut cell lacks is spread over the connections around it (MomentStencil). The
/// second term makes up for the lattice bending a little softer than the continuum between its surfaces. Of full cells
/// only the sides to others count, as between two full cells what one has too much the other takes.
///
/// Walls of more than 8 cells keep their weights, which are right to 5 % in bending there, and so do walls of three
/// and more whose skin lies on nodes: uniform strain is exact in them.
/// The volume of an object is an eighteenth of the weights of its connections, as before, so that no object is light against
/// its springs; they sum to the volume of all cells, the weights of each family to it over a^3.
///
/// Measured on square bars, stiffness in bending by beam theory's: .92 to 1.10 from 1.75 cells on, at any tilt. Below one
/// and a half cells two layers of objects cannot have the second moment: up to 1.3 at 1.4 cells, 1.8 at one along the
/// lattice, 2.4 at one across it. Uniform strain, exact before along the lattice, is up to 1.2 % too soft in walls of less
/// than three cells there: families are fitted one by one, which leaves small forces at the skin.
/// The result does not depend on the number of threads.
/// @param aggregate with the weights of joinCells() from the same cells
/// @throws Cancelled
Aggregate withFittedMoments(const CutCells& cells, Aggregate aggregate, TaskControl& control);

} // namespace knead
