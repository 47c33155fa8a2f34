#include "core/model/number_words.h"

#include <cmath>
#include <sstream>

namespace knead {

namespace {

std::string rounded(double value, int digits)
{
    std::ostringstream text;
    text.precision(digits);
    text << value;
    return text.str();
}

} // namespace

std::string lengthWords(double length)
{
    const double size = std::abs(length);
    if (size >= 10)
        return rounded(length, 3) + " m";
    if (size >= 1e-5 || size == 0)
        return (size >= 1 ? rounded(std::round(1e3 * length), 4) : rounded(1e3 * length, 3)) + " mm";
    return rounded(1e6 * length, 3) + " um";
}

std::string percentWords(double share)
{
    return rounded(100 * share, 2) + " %";
}

} // namespace knead
