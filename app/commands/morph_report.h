#pragma once

#include "app/deformation_plan.h"
#include "core/model/export_report.h"
#include "core/model/part.h"

#include <vector>

namespace knead {

/// What `knead morph` says at its end.
struct MorphReport {
    const Model& model; ///< before
    const std::vector<DeformationWish>& wishes;
    const DeformationPlan& plan;
    const ExportReport& written;
};

/// In lines for a person, to the output.
void printMorph(const MorphReport& report);

/// As one JSON object.
void printMorphJson(const MorphReport& report);

} // namespace knead
