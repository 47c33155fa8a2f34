#pragma once

#include "core/model/export_options.h"

namespace knead {

/// What a person asked to be exported, and how.
struct ExportRequest {
    enum class Which { all, visible, selected };

    Which which = Which::all;
    ExportOptions options;
    bool onePerPart = false;  ///< a file for each part instead of one for all
    bool keepsReport = false; ///< as a JSON file beside it
};

} // namespace knead
