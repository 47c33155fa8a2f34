#pragma once

#include "core/deformation/deformation.h"
#include "io/files/byte_blocks.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace knead {

/// Deformations as bytes: each list once, however many parts it is for, and each field once.
class DeformationLists {
public:
    using List = std::shared_ptr<const std::vector<Deformation>>;

    DeformationLists() = default;

    /// Reads what write() wrote. @throws Problem, for the developer
    explicit DeformationLists(BlockReader& blocks);

    /// @return its number, for at(); 0: none
    std::size_t add(const List& list);

    /// @throws Problem, for the developer
    List at(std::size_t number) const;

    void write(BlockWriter& blocks) const;

private:
    std::vector<List> m_lists;
};

} // namespace knead
