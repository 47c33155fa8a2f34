#include "core/computing_versions.h"

#include <Eigen/Core>
#include <tbb/version.h>

namespace knead {

std::string eigenVersion()
{
    return std::to_string(EIGEN_WORLD_VERSION) + '.' + std::to_string(EIGEN_MAJOR_VERSION) + '.' +
           std::to_string(EIGEN_MINOR_VERSION);
}

std::string tbbVersion()
{
    return TBB_runtime_version();
}

} // namespace knead
