#pragma once

#include "core/document/kept_work.h"
#include "core/document/rescued_project.h"
#include "core/task/task_control.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace knead {

/// Projects on the disk. The functions may be called from any thread and block; what they throw is a std::runtime_error with a
/// sentence for the person, or Cancelled.
struct ProjectServices {
    std::string ending; ///< of project files: "knead"

    /// The file appears whole or not at all.
    std::function<void(const std::string& path, const Project&, TaskControl&)> write;
    /// @throws DamagedProject, of which rescue() may bring back a part
    std::function<Project(const std::string& path, TaskControl&)> read;
    std::function<RescuedProject(const std::string& path, TaskControl&)> rescue;

    /// Keeps other windows from a project as long as the result lives. @throws when another window works on it
    std::function<std::shared_ptr<void>(const std::string& path)> lock;

    std::function<std::unique_ptr<KeptWork>()> keepWork; ///< work of a window that begins
    /// Of a window that is gone. @throws when another window was quicker
    std::function<std::unique_ptr<KeptWork>(const Recovery&)> takeOver;
    std::function<std::vector<Recovery>()> findRecoveries; ///< the latest first
    std::function<void(const Recovery&)> dropRecovery;     ///< which the person does not want
};

} // namespace knead
