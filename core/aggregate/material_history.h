#pragma once

#include "core/aggregate/material.h"

#include <cstdint>

namespace knead {

/// The version of moments with which a number of Material came; 1 for those that there were at first.
inline std::uint32_t momentVersionOf(const MaterialField& field)
{
    if (field.value == &Material::toughness)
        return 7;
    const bool isOfRubber = field.value == &Material::rubberlike || field.value == &Material::secondInvariantShare ||
                            field.value == &Material::lockingElongation;
    return isOfRubber ? 3 : 1;
}

/// Numbers of Material that came after files had been written: those leave them out, and have what a Material has at first.
inline bool isMissingInOlderFiles(const MaterialField& field)
{
    return momentVersionOf(field) > 1;
}

} // namespace knead
