#pragma once

#include <string>
#include <vector>

namespace knead {

struct LibraryVersion {
    std::string name;
    std::string version; ///< of what runs where it can be asked, else of what was built with
    std::string license;
};

/// What files are read and written with, and what computes. Any thread.
std::vector<LibraryVersion> libraryVersions();

} // namespace knead
