#pragma once

#include <string>

namespace knead {

/// Where the program knead-cad-worker is that belongs to another program: beside it, as in a build tree, else, as it is installed, in
/// ../libexec/knead from there.
/// @return a path; beside it when it is in neither
std::string cadProgramBeside(const std::string& program);

/// That of the running program, as it was when this was first called: it stays the same when its file is replaced by one of another
/// version. Any thread.
std::string ownCadProgram();

} // namespace knead
