#include "core/message/number_text.h"

#include <iomanip>
#include <sstream>

namespace knead {

std::string inDigits(double number, int digits)
{
    std::ostringstream text;
    text << std::setprecision(digits) << number;
    return text.str();
}

} // namespace knead
