#define KNEAD_KERNEL_SET avx2
#define KNEAD_KERNEL_NAME "AVX2"
#include "core/vicinity/sphere_kernels_impl.h"
