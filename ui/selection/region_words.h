#pragma once

#include "core/session/region_contents.h"

#include <QString>

namespace knead {

/// "3 faces, 12.4 cm²", "Face "seat", 4.1 cm²"
QString wordsFor(const Region& region, const RegionSize& size);

} // namespace knead
