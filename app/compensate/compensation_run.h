#pragma once

#include "app/compensate/compensation_folder.h"
#include "app/compensate/round_command.h"
#include "core/model/export_report.h"
#include "core/session/compensation.h"
#include "core/session/compensation_study.h"
#include "core/task/task_control.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace knead {

/// What a compensation came to.
struct CompensationResult {
    TargetPoints points;
    std::vector<CompensationRound> rounds;
    std::size_t finishedBefore = 0; ///< rounds of an earlier call
    std::size_t best = 0;           ///< index of the round whose shape was written
    CompensationEnd end = CompensationEnd::rounds;
    ExportReport written; ///< on compensated.step
};

/// Carries out rounds in a folder, those that are finished there left out, until they are over, and writes the shape of the best one.
/// Tables and plot are up to date after each round.
/// @param read the fields that commands write
/// @param say takes sentences for the person at once
/// @throws std::runtime_error, in a sentence. @throws Cancelled
CompensationResult compensate(const CompensationStudy& study, const CompensationFolder& folder,
                              const RoundEngine& engine, const ReadField& read,
                              const std::function<void(const std::string&)>& say, TaskControl& control);

} // namespace knead
