#pragma once

#include "fuzz/target.h"

#include <cstddef>

namespace knead::fuzz {

// Each in a file of its name; CMakeLists.txt makes a program of each.
Target modelTarget();     ///< a model as the worker hands it over, and as tool parts are kept
Target answerTarget();    ///< all else that workers hand over: previews, failures, fields, meshes, exported files
Target momentTarget();    ///< a moment of a history, past its checksum
Target aggregateTarget(); ///< a filling, as projects keep it
Target commandsTarget();  ///< the commands of a history, as JSON
Target projectTarget();   ///< a project in which one value of one row is another, past its checksum
Target recipeTarget();    ///< recipes, and studies of a compensation
Target zipTarget();       ///< a 3MF as its zip archive
Target threemfTarget();   ///< the XML text in one
Target fieldsTarget();    ///< a file of displacements or a mesh, of any format

struct NamedTarget {
    const char* name;
    Target target;
    std::size_t trials = 400; ///< of io_fuzz_targets_test, fewer where one takes long
};

inline std::vector<NamedTarget> allTargets()
{
    return {{"model", modelTarget()},         {"answer", answerTarget()},
            {"moment", momentTarget()},       {"commands", commandsTarget()},
            {"aggregate", aggregateTarget()}, {"project", projectTarget(), 40},
            {"recipe", recipeTarget()},       {"zip", zipTarget()},
            {"threemf", threemfTarget()},     {"fields", fieldsTarget()}};
}

} // namespace knead::fuzz
