#pragma once

#include "core/document/kept_work.h"
#include "core/message/message.h"
#include "ui/document/document.h"
#include "ui/project/project_services.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// Which project is wanted, and how.
struct ProjectRequest {
    std::string path;                 ///< of the file; empty for a recovery
    std::optional<Recovery> recovery; ///< instead of a file
    bool isCopy = false;              ///< without the name and the lock of the file
    bool rescues = false;             ///< takes what is whole of a damaged one
    std::shared_ptr<void> lock;       ///< of the file, when this window has it already
};

/// A project that is ready to be shown, or why there is none.
struct ReadProject {
    enum class Obstacle { none, lock, damage };
    Obstacle obstacle = Obstacle::none;
    Message sentence; ///< about the obstacle

    std::string path;               ///< that it is saved to; empty: none yet
    std::shared_ptr<void> lock;     ///< of the file there
    std::shared_ptr<KeptWork> kept; ///< of a recovery: it is gone on with
    std::vector<Message> missing;   ///< a phrase each: what could not be brought back
    bool isSaved = false;           ///< nothing differs from the file

    std::optional<PreparedProject> project;
    std::optional<PreparedModel> parts; ///< instead, when only they are whole
    ProjectView view;
    std::vector<ProjectMark> marks;
    std::map<std::string, std::string> panels;
};

/// Reads a project and prepares what it shows. Runs on a task thread.
/// @throws std::runtime_error with a sentence about what has no remedy; Cancelled
ReadProject readProjectFor(const ProjectRequest& request, const ProjectServices& services, const Packing& packing,
                           TaskControl& control);

} // namespace knead
