#pragma once

#include "core/model/part.h"

namespace knead {

/// A model with the parts of another one behind its own, which keep their numbers, names and paths. In the tree they are a child of the
/// root, under a name that no other child has, which leads their paths. A doubt about their unit becomes a warning.
Model withAdded(Model model, Model added);

} // namespace knead
