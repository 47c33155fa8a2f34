#define KNEAD_KERNEL_SET avx2
#define KNEAD_KERNEL_NAME "AVX2"
#include "core/kernels/kernels_impl.h"
