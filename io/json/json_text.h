#pragma once

#include "core/geometry/vec3.h"

#include <cstdint>
#include <string>
#include <vector>

namespace knead {

/// A text as JSON; what is no UTF-8 becomes what can be read.
std::string quoted(const std::string& text);

/// Ascending numbers with stretches as pairs of their first and last: "[3, [7, 420]]".
std::string stretchesText(const std::vector<std::uint32_t>& numbers);

/// A JSON object on one line, piece by piece. Numbers keep their bits.
class ObjectText {
public:
    ObjectText& put(const std::string& key, const std::string& json);
    ObjectText& text(const std::string& key, const std::string& value) { return put(key, quoted(value)); }
    ObjectText& number(const std::string& key, double value);
    ObjectText& numbers(const std::string& key, const Vec3& value);
    ObjectText& numbers(const std::string& key, const Quaternion& value); ///< w, x, y, z
    ObjectText& millimeters(const std::string& key, double meters);
    ObjectText& millimeters(const std::string& key, const Vec3& meters);
    ObjectText& millimeters(const std::string& key, const Box& meters);

    bool isEmpty() const { return m_text.empty(); }
    std::string take() const { return "{" + m_text + "}"; }

private:
    std::string m_text;
};

} // namespace knead
