#define KNEAD_KERNEL_SET avx512
#define KNEAD_KERNEL_NAME "AVX-512"
#include "core/vicinity/sphere_kernels_impl.h"
