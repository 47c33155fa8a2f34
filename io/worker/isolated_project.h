#pragma once

#include "core/document/rescued_project.h"
#include "core/task/task_control.h"

#include <string>

namespace knead {

// A project may be of a stranger, and what it is made of has to come into this process in the end. It is read in a process of
// its own first, which is locked in and limited as for a CAD file, and then let go: what makes the reader crash, hang or eat memory does so
// there, and costs a sentence. The same file is read here afterwards by the same functions, and comes to the same; somebody
// who changes it in between could have changed it before.

/// As readProject(), after a trial. It takes twice as long, and some 30 ms.
/// @param program that calls runProjectWorker() when isProjectWorker()
/// @throws DamagedProject; Problem: which file, what is wrong, what to do; Cancelled
Project readTriedProject(const std::string& program, const std::string& path, TaskControl& control);

/// As rescueProject(), likewise.
RescuedProject rescueTriedProject(const std::string& program, const std::string& path, TaskControl& control);

} // namespace knead
