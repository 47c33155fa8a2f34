#pragma once

#include <string>

namespace knead {

/// The text of a STEP file whose colors and layers come in an order of their own. OpenCASCADE writes them as its tables of
/// addresses lie, another way in every run; the same parts are to give the same bytes. Everything else stays as it is.
std::string withStylesInOrder(const std::string& step);

} // namespace knead
