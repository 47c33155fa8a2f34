#pragma once

#include "core/model/part.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace knead {

/// What a file holds, as far as it can be told without making any shape.
struct FilePreview {
    std::string file;       ///< path as given
    std::uint64_t size = 0; ///< [bytes]
    std::string format;     ///< as Model::format
    std::size_t solids = 0; ///< in the file, instances not counted; 0 also when unknown
    std::size_t faces = 0;
    std::size_t parts = 0; ///< leaves of the tree
    PartNode tree;         ///< names only; paths in it are those of ImportOptions::parts. Without children when unknown
};

} // namespace knead
