#include "core/model/number_words.h"

#include "core/message/number_text.h"

#include <cmath>

namespace knead {

std::string lengthWords(double length)
{
    const double size = std::abs(length);
    if (size >= 10)
        return inDigits(length, 3) + " m";
    if (size >= 1e-5 || size == 0)
        return (size >= 1 ? inDigits(std::round(1e3 * length), 4) : inDigits(1e3 * length, 3)) + " mm";
    return inDigits(1e6 * length, 3) + " um";
}

std::string percentWords(double share)
{
    return inDigits(100 * share, 2) + " %";
}

} // namespace knead
