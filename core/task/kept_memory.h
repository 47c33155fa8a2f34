#pragma once

namespace knead {

/// The C library keeps what is given back to it, up to some hundred megabytes, instead of handing it to the system with each frame:
/// a page that comes back costs more than what is written on it. For a program to call as it begins; does nothing where the C
/// library is not GNU's.
void keepFreedMemory();

} // namespace knead
