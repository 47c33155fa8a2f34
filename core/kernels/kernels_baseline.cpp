#define KNEAD_KERNEL_SET baseline
#define KNEAD_KERNEL_NAME "x86-64"
#include "core/kernels/kernels_impl.h"
