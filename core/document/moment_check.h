#pragma once

#include "core/message/message.h"
#include "core/simulation/moment.h"

#include <span>

namespace knead {

/// Why a simulation of these bodies cannot go to a moment, in a phrase such as "a material is out of range"; empty when it
/// can. For moments that come from a file.
Message momentProblem(const Moment& moment, std::span<const Body> bodies);

} // namespace knead
