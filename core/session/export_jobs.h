#pragma once

#include "core/model/export_job.h"
#include "core/model/part.h"
#include "core/simulation/snapshot.h"

#include <cstddef>
#include <span>
#include <vector>

namespace knead {

/// All parts of a model as a snapshot shows them, in the unit they came in: what is written to a file, whoever asks for it.
/// Parts that are no bodies are written as they were imported.
/// @param partOfBody per body of the snapshot, index into Model::parts
/// @param keep per part of the model; empty: all
ExportJob exportJobOf(const Model& model, std::span<const std::size_t> partOfBody, const Snapshot& snapshot,
                      const std::vector<bool>& keep = {});

} // namespace knead
