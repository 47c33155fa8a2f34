#define KNEAD_KERNEL_SET avx512
#define KNEAD_KERNEL_NAME "AVX-512"
#include "core/kernels/kernels_impl.h"
