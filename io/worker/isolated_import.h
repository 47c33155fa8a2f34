#pragma once

#include "core/model/file_preview.h"
#include "core/model/import_options.h"
#include "core/model/part.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <string>

namespace knead {

/// What reading one file may take.
struct ImportLimits {
    std::uint64_t memory = 0; ///< of address space [bytes]; 0: none
    double processorTime = 0; ///< [s]; 0: none
    double wallTime = 0;      ///< [s]; 0: none
};

/// Generous for honest files: 3 GiB and 400 times the size of the file, at most three quarters of the machine's memory; two
/// minutes of processor time and 30 s for each MB; twice that by the clock on the wall.
/// What a person chose instead comes first.
ImportLimits limitsFor(const std::string& path, const ImportOptions& options = {});

/// As importFile(), in a process of its own: a file that makes the CAD reader crash, hang or eat memory ends that process and
/// gives a sentence. Cancelling ends it at once. Any number of imports may run beside each other, on threads of their own.
///
/// @param program that calls runImportWorker() when isImportWorker()
/// @throws Problem: which file, what is wrong, what to do. @throws Cancelled
Model importIsolated(const std::string& program, const std::string& path, const ImportOptions& options,
                     const ImportLimits& limits, TaskControl& control);

/// As previewFile(), in a process of its own. @throws as importIsolated()
FilePreview previewIsolated(const std::string& program, const std::string& path, const ImportLimits& limits,
                            TaskControl& control);

} // namespace knead
