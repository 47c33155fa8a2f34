#pragma once

#include "core/session/compensation_study.h"

#include <string>

namespace knead {

/// Reads and checks the study of a compensation; resources/handbook/compensating.md documents every key. Nothing is guessed: an
/// unknown key, a wrong type or a number out of range is an error.
/// @throws Problem, in a sentence: the file, the place in it, and what is allowed there
CompensationStudy readStudy(const std::string& path);

} // namespace knead
