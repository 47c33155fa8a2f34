#pragma once

#include "core/document/moment_bytes.h"

namespace knead {

/// Zstandard at its fastest, as for blobs of projects. Any thread.
Packing zstandardPacking();

} // namespace knead
