#pragma once

#include "ui/project/encoded_path.h"
#include "ui/project/project_keeper.h"

#include <string>

namespace knead {

/// Where a script finds what the project holds now; empty: it is saved nowhere, or its file is behind.
inline std::string savedPath(const ProjectKeeper& projects)
{
    return projects.isModified() ? std::string() : encoded(projects.path());
}

} // namespace knead
