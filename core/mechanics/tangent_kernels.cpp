#include "core/mechanics/tangent_kernels.h"

namespace knead::kernels {

namespace baseline {
extern const TangentKernels tangentSet;
}
#ifdef __x86_64__
namespace avx2 {
extern const TangentKernels tangentSet;
}
namespace avx512 {
extern const TangentKernels tangentSet;
}
#endif

const std::vector<TangentKernels>& availableTangents()
{
    static const std::vector<TangentKernels> sets = [] {
        std::vector<TangentKernels> found{baseline::tangentSet};
#ifdef __x86_64__
        if (__builtin_cpu_supports("avx2"))
            found.push_back(avx2::tangentSet);
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
            found.push_back(avx512::tangentSet);
#endif
        return found;
    }();
    return sets;
}

const TangentKernels& bestTangents()
{
    static const TangentKernels& set = availableTangents().back();
    return set;
}

} // namespace knead::kernels
