#pragma once

#include "core/document/moment_bytes.h"

namespace knead {

constexpr int packingLevel = 1; ///< of Zstandard; positions and velocities hardly shrink, whatever the effort

/// Zstandard at its fastest, as for blobs of projects. Any thread.
Packing zstandardPacking();

} // namespace knead
