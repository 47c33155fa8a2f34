#pragma once

#include "core/model/export_job.h"
#include "core/model/export_report.h"
#include "core/model/field_file.h"
#include "core/model/file_preview.h"
#include "core/model/import_options.h"
#include "core/model/part.h"
#include "core/task/task_control.h"

#include <string>
#include <vector>

namespace knead {

struct NodalMesh; // io/fields/nodal_mesh.h
struct Project;
struct RescuedProject;

/// Reads a file in a process of its own (knead-cad-worker), which is locked in, see io/worker/confinement.h, with the limits that its size calls for. Every import of the program goes this way:
/// window, commands and recipes. On any thread, any number at a time.
/// @throws std::runtime_error, in a sentence for the person. @throws Cancelled
Model importInChild(const std::string& path, const ImportOptions& options, TaskControl& control);

/// Several files beside each other, as many as there are cores; they become one model with a node per file. What cannot be
/// read is missing from it, and Model::missing says why.
/// @throws std::runtime_error when not one of them can be read. @throws Cancelled
Model importInChildren(const std::vector<std::string>& paths, const ImportOptions& options, TaskControl& control);

/// Looks into a file in a process of its own. @throws as importInChild()
FilePreview previewInChild(const std::string& path, TaskControl& control);

/// Writes parts to STEP, IGES or BREP in a process of its own, reads that back and compares.
/// @throws std::runtime_error, in a sentence for the person; the file that was there before is there still. @throws Cancelled
ExportReport exportInChild(const std::string& path, const ExportJob& job, TaskControl& control);

/// Reads the displacements at the nodes of another program's result in a process of its own, see io/fields/field_reader.h.
/// @throws as importInChild()
FieldFile readFieldInChild(const std::string& path, const FieldChoice& choice, TaskControl& control);

/// Reads the nodes of a mesh, and its cells where there are some, in a process of its own.
/// @param unit of lengths in the file; empty: that which the file says, else mm
/// @throws as importInChild()
NodalMesh readNodesInChild(const std::string& path, const std::string& unit, TaskControl& control);

/// Reads a project after a trial in a process of its own, see io/worker/isolated_project.h. Every project that somebody names is read
/// this way; what the program itself kept for recovery is not.
/// @throws DamagedProject, of which rescueProjectAfterTrial() may bring back a part; as importInChild()
Project readProjectAfterTrial(const std::string& path, TaskControl& control);
RescuedProject rescueProjectAfterTrial(const std::string& path, TaskControl& control);

/// Which program reads and writes CAD files: at first that of the running program, see app/cad_program.h. For programs that are
/// not knead, such as tests.
void setCadProgram(const std::string& path);

} // namespace knead
