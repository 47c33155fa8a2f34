#pragma once

#include "core/aggregate/material.h"

#include <QIcon>

namespace knead {

/// A small picture of a material: a ball that looks as it does. Those of the program have looks of their own; the others get
/// one from their numbers. Painted once for each preset and kept.
QIcon materialSwatch(const MaterialPreset& preset);

} // namespace knead
