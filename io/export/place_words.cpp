#include "io/export/place_words.h"

#include <cstdio>

namespace knead {

std::string placeWords(const Vec3& place)
{
    char text[96];
    std::snprintf(text, sizeof text, "(%.3g, %.3g, %.3g) mm", 1e3 * place.x(), 1e3 * place.y(), 1e3 * place.z());
    return text;
}

} // namespace knead
