#pragma once

#include <string>

namespace knead {

std::string eigenVersion(); ///< that core was built with
std::string tbbVersion();   ///< that runs

} // namespace knead
