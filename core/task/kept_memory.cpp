#include "core/task/kept_memory.h"

#include <cstdlib> // which says whose library it is

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace knead {

void keepFreedMemory()
{
#ifdef __GLIBC__
    constexpr int largestFromHeap = 32 << 20; // the most that the library takes for this [bytes]
    constexpr int mostKept = 256 << 20;       // at the end of the heap [bytes]
    mallopt(M_MMAP_THRESHOLD, largestFromHeap);
    mallopt(M_TRIM_THRESHOLD, mostKept);
#endif
}

} // namespace knead
