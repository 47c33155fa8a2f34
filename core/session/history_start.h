#pragma once

#include "core/document/project.h"
#include "core/session/filled_model.h"
#include "core/simulation/scripted_events.h"

#include <memory>

namespace knead {

/// What the steps of entries of a history count from.
struct HistoryStart {
    ProjectStart start;
    std::shared_ptr<const FilledModel> content; ///< null where it has to be made anew to be shown
    ScriptedEventsMaker script = {};            ///< of a recipe that the document was opened from
    ImportChoices choices = {};                 ///< that the content is made for
};

} // namespace knead
