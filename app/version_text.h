#pragma once

#include <string>

namespace knead {

/// "knead 0.1.0", in a line.
std::string versionText();

/// With what it stands on: the versions of libraries, the program that reads files of others, and how far the kernel here locks that
/// in; what it lacks, with what that means. A line each.
std::string verboseVersionText();

} // namespace knead
