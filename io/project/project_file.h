#pragma once

#include "core/document/rescued_project.h"
#include "core/task/task_control.h"

#include <string>

namespace knead {

// Project files, "bracket.knead": SQLite databases, see schema.h. All functions may be called on any thread and throw
// Problem for the person: which file, what is wrong, what to do.

/// Writes a project. The file appears whole or not at all, and is on the disk when this returns: until then, and whatever ends
/// the program, what lay at the path before stays. It is read back before it takes that place. A link is followed.
/// @pre indices are of what is there, and every body of a start has its part and its aggregate
/// @throws Cancelled; nothing has changed
void writeProject(const std::string& path, const Project& project, TaskControl& control = TaskControl::none());

/// Reads what writeProject() wrote, to the last bit; files of older versions too, which stay as they are. A file of a newer
/// version, one that is no project, and one in which anything is not as it was written are refused.
/// @throws DamagedProject, in a sentence; Cancelled
Project readProject(const std::string& path, TaskControl& control = TaskControl::none());

/// Whether a file begins as projects do, whatever its name; no promise that it can be read.
bool isProjectFile(const std::string& path);

/// Takes from a file what is whole. @throws Problem when no table of a project is left; Cancelled
RescuedProject rescueProject(const std::string& path, TaskControl& control = TaskControl::none());

} // namespace knead
