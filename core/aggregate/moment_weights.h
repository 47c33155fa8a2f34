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
///   sum w_b p(x_b) = integral over the material of p + a^2 / 2 (s_u p_uu + s_v p_vv + s_w p_ww)
/// for quadratic p, with small s that make up for what the lattice itself bends and does not warp (see thin_blocks.cpp), in blocks of
/// two cells per axis: what their cut cells lack is spread over the connections around them
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
/// its springs; they sum to the volume of all cells, the weights of each family to it over a^3. Walls of less than 1.75 cells then keep a
/// part of their weights alone, see loosenThinWalls().
///
/// Measured on square bars of material that does not yield (nu = 1/4) in steps of a twentieth of a cell, stiffness by beam theory's,
/// along the lattice, at 29 degrees across it, and tilted in three axes: bending .91 to 1.05 from 1.75 cells on, and from one cell on
/// 1.02 to 1.17, .81 to 1.08 and 1.03 to 1.26. Torsion .94 to 1.15, .99 to 1.15 and 1.00 to 1.10 from two cells on. Plates bend as
/// bars do, .92 to 1.01. At nine other tilts, a few thicknesses each: bending .90 to 1.14 from 1.75 cells on, .87 to 1.66 from one,
/// torsion .96 to 1.15, at 45 degrees 1.19. Material that yields has another law for its objects, stiffer by 0 to 4 % from 1.75 cells on
/// and by 9 to 12 % at one.
/// Uniform strain, exact before along the lattice, is up to 3 % too soft in cut walls there, .3 % in bars of four whole cells:
/// families are fitted one by one, which leaves small forces at the skin that withBalancedSkin() takes away. Sheets of
/// whole cells stay exact: see ThinBlock.
/// The result does not depend on the number of threads.
/// @param aggregate with the weights of joinCells() from the same cells
/// @throws Cancelled
Aggregate withFittedMoments(const CutCells& cells, Aggregate aggregate, TaskControl& control);

} // namespace knead
