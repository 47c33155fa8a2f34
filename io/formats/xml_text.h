#pragma once

#include <string>
#include <string_view>

namespace knead {

/// UTF-8 text as the value of an attribute in XML 1.0: quotes and the like are replaced, what XML cannot say is left out.
std::string xmlText(std::string_view text);

} // namespace knead
