#pragma once

#include <iostream>
#include <string>

namespace knead {

/// Tells the person at the terminal what went wrong.
/// @return `status`, with which the command then ends
inline int complain(const std::string& sentence, int status)
{
    std::cerr << "knead: " << sentence << '\n';
    return status;
}

} // namespace knead
