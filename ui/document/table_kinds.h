#pragma once

#include "core/aggregate/material.h"
#include "core/simulation/command.h"

#include <QString>

#include <span>

namespace knead {

/// What the floor is made of, as a table that parts are worked on.
struct TableKind {
    const char* name; ///< to be translated, context "TableKinds"
    const char* tip;
    double friction;     ///< see SetFloor
    double adhesion = 0; ///< [Pa]
};

/// Smooth, rough, sticky; the same for the life of the program.
std::span<const TableKind> tableKinds();

inline constexpr std::size_t stickyTable = 2; ///< into tableKinds()

/// Index into tableKinds() of the one with these numbers; -1: none.
int tableKindOf(double friction, double adhesion);

/// Whether a material is worked on a table that it sticks to, under its own weight: clay, putty.
bool isKneaded(const Material& material);

} // namespace knead
