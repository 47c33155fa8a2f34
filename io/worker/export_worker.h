#pragma once

#include "io/formats/cad_format.h"
#include "io/worker/own_process.h"

#include <string>
#include <vector>

namespace knead {

/// The arguments of a program that calls runExportWorker(), its name first.
/// @param path of the file to be, for sentences
std::vector<std::string> argumentsForExport(FormatKind kind, const std::string& path, const OwnLimits& limits);

/// Whether a program was started with argumentsForExport() and should do nothing else.
bool isExportWorker(int argc, char** argv);

/// Carries out the job that the parent handed over and leaves the file's bytes and the report: see serveParent().
[[noreturn]] int runExportWorker(int argc, char** argv);

} // namespace knead
