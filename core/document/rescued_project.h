#pragma once

#include "core/document/project.h"
#include "core/message/message.h"

#include <vector>

namespace knead {

/// What could be read of a damaged project.
struct RescuedProject {
    Project project;              ///< without its model when that is lost; entries whose parents and starts are whole
    std::vector<Message> missing; ///< a phrase each, for the person; empty when nothing is
};

/// A project that is not as it was written, in a sentence. What is whole in it can be rescued.
struct DamagedProject : Problem {
    using Problem::Problem;
};

} // namespace knead
