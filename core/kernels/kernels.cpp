#include "core/kernels/kernels.h"

namespace knead::kernels {

namespace baseline {
extern const Kernels set;
}
#ifdef __x86_64__
namespace avx2 {
extern const Kernels set;
}
namespace avx512 {
extern const Kernels set;
}
#endif

const std::vector<Kernels>& available()
{
    static const std::vector<Kernels> sets = [] {
        std::vector<Kernels> found{baseline::set};
#ifdef __x86_64__
        if (__builtin_cpu_supports("avx2"))
            found.push_back(avx2::set);
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
            found.push_back(avx512::set);
#endif
        return found;
    }();
    return sets;
}

const Kernels& best()
{
    static const Kernels& set = available().back();
    return set;
}

} // namespace knead::kernels
