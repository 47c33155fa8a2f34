#pragma once

#include "verify/record.h"

#include <string>
#include <vector>

namespace knead::book {

/// The book as one page that needs nothing beside it: pictures are within.
std::string htmlOf(const std::vector<Record>& records);
std::string jsonOf(const std::vector<Record>& records);

} // namespace knead::book
