#include "verify/cases.h"

namespace knead::book {

void addMeasuredCases(std::vector<Case>&) {}

} // namespace knead::book
