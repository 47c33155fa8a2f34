#include "core/vicinity/vicinity.h"

#include "core/vicinity/brute_force.h"
#include "core/vicinity/partition_tree.h"
#include "core/vicinity/uniform_grid.h"

namespace knead {

std::string_view nameOf(VicinityMethod method)
{
    switch (method) {
    case VicinityMethod::uniformGrid:
        return "uniform-grid";
    case VicinityMethod::halfPartition:
        return "half-partition";
    case VicinityMethod::medianPartition:
        return "median-partition";
    case VicinityMethod::bruteForce:
        return "brute-force";
    }
    return "";
}

std::unique_ptr<Vicinity> makeVicinity(VicinityMethod method)
{
    switch (method) {
    case VicinityMethod::uniformGrid:
        return std::make_unique<UniformGrid>();
    case VicinityMethod::halfPartition:
        return std::make_unique<PartitionTree>(PartitionTree::Plane::half);
    case VicinityMethod::medianPartition:
        return std::make_unique<PartitionTree>(PartitionTree::Plane::median);
    case VicinityMethod::bruteForce:
        return std::make_unique<BruteForce>();
    }
    return nullptr;
}

} // namespace knead
