#pragma once

#include "core/document/kept_work.h"
#include "core/document/moment_bytes.h"
#include "core/document/project.h"
#include "core/message/message.h"
#include "core/task/task_control.h"

#include <vector>

namespace knead {

/// A project with something made good, and what could not be.
struct MendedProject {
    Project project;
    std::vector<Message> missing; ///< a phrase each, for the person
};

/// The gesture that was under way becomes the last entry: it is repeated as far as it had come. Takes as long as it took. When it
/// cannot be repeated, the project is as it was.
/// @param packing of the moments @throws Cancelled
MendedProject withGesture(Project project, const WorkState& state, const Packing& packing, TaskControl& control);

/// Goes to an earlier entry when the moment of the current one can neither be read nor found again, until there is one that can.
/// When there is none, entries and starts are left out: only the parts are whole.
/// @param packing of the moments @throws Cancelled
MendedProject withReachableEntry(Project project, const Packing& packing, TaskControl& control);

} // namespace knead
