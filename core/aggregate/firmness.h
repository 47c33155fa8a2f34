#pragma once

#include "core/aggregate/material.h"

namespace knead {

/// The same material as it is colder or drier (factor > 1), or warmer or wetter (< 1): stiffness, yield stress, hardening, strength and
/// toughness by the factor, within what a Material may have, so that it yields and tears at the strains that it did. How it flows in
/// time, sticks and heals stays.
/// @param factor > 0
Material firmer(const Material& material, double factor);

} // namespace knead
