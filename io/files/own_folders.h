#pragma once

#include <string>

namespace knead {

/// The folder that an XDG variable names, when that is absolute; else one below the home of the person. The home is $HOME, else that
/// which the system knows; it is never a folder that others may write to: where there is none, the result is a path at which nothing
/// can be made.
/// @param variable "XDG_CONFIG_HOME" @param belowHome ".config"
std::string ownFolder(const char* variable, const std::string& belowHome);

} // namespace knead
