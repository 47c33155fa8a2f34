#define KNEAD_KERNEL_SET baseline
#define KNEAD_KERNEL_NAME "x86-64"
#include "core/mechanics/tangent_kernels_impl.h"
