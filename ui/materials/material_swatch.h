#pragma once

#include "core/aggregate/material.h"

#include <QIcon>
#include <QString>

namespace knead {

/// A small picture of a material: a ball that looks as it does. Those of the program have looks of their own; the others get
/// one from their numbers. Painted once for each preset and kept.
QIcon materialSwatch(const MaterialPreset& preset);

/// What a material is called in the language of the window; those that the person saved are called as the person said.
QString materialName(const MaterialPreset& preset);

/// What there is to say of a number of materials.
const MaterialField& fieldOf(double Material::*value);

} // namespace knead
