#pragma once

#include "core/aggregate/material.h"

namespace knead {

/// Numbers of Material that came after files had been written: those leave them out, and have what a Material has at first.
inline bool isMissingInOlderFiles(const MaterialField& field)
{
    return field.value == &Material::rubberlike || field.value == &Material::secondInvariantShare ||
           field.value == &Material::lockingElongation;
}

} // namespace knead
