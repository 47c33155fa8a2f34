#pragma once

#include "core/aggregate/material.h"
#include "core/geometry/vec3.h"
#include "core/simulation/scene.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace knead::python_text {

// Values as Python reads them. Numbers come back with the same bits.

/// The shortest one; float("inf") and the like for what is none.
std::string number(double value);

/// "(0.1, 2, 3)"
std::string tuple(const Vec3& value);
/// "(1, 0, 0, 0)": w, x, y, z
std::string tuple(const Quaternion& value);

/// In quotes; what is no UTF-8 becomes what can be read.
std::string text(const std::string& value);

/// In quotes; bytes where it is no UTF-8.
std::string path(const std::string& value);

/// On one line.
std::string comment(const std::string& value);

inline constexpr const char* zeros = "(0, 0, 0)";

/// Ascending numbers, with stretches as ranges: "[3, *range(7, 421)]".
std::string list(const std::vector<std::uint32_t>& numbers);

/// JSON on one line as a Python literal.
std::string literal(const std::string& json);

/// "knead.Material("silicone-rubber")", or with its numbers that differ from a material as it comes.
std::string material(const Material& material, const std::vector<MaterialPreset>& presets);

/// Variables, each used once.
class Names {
public:
    /// "block_1" of "Block 1". @param other for what has no letters
    std::string add(const std::string& name, const std::string& other);

private:
    std::set<std::string> m_taken;
};

/// "sim.fix(...)": what stands in the brackets, piece by piece.
class Arguments {
public:
    Arguments& add(const std::string& value);
    Arguments& add(const char* key, const std::string& value) { return add(std::string(key) + '=' + value); }
    /// Left out where it is what it is without, to the bit.
    Arguments& addUnless(const std::string& usual, const char* key, const std::string& value);
    Arguments& addUnless(double usual, const char* key, double value);

    const std::string& all() const { return m_text; }

private:
    std::string m_text;
};

} // namespace knead::python_text
