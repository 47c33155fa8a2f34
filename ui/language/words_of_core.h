#pragma once

#include <QString>

namespace knead {

/// What core calls a number of a material, or what its 0 means, in the language spoken now: "Density", "never breaks".
QString materialWord(const char* word);

} // namespace knead
