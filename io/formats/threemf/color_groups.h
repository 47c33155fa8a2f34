#pragma once

#include "io/mesh/mesh_body.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace knead {

using ColorBytes = std::array<unsigned char, 3>;

/// sRGB in 0..255.
ColorBytes toBytes(const Color& color);

/// "ff8000"
std::string hexDigits(const Color& color);

/// One material per color, named by its digits: "color_ff8000".
std::string materialName(const Color& color);

Color colorOf(const MeshBody& body, std::size_t triangle);

/// Whether any face differs from its body.
bool hasFaceColors(const MeshBody& body);

/// The triangles of a body by color: formats want them in one piece.
struct ColorGroups {
    struct Group {
        Color color;
        std::size_t begin; ///< in the order
        std::size_t end;
    };

    std::vector<Group> groups; ///< in the order of their first triangles; none is empty
    std::vector<std::uint32_t>
        order; ///< triangles, each group's in their order in the mesh; empty when that is it already

    std::size_t triangle(std::size_t i) const { return order.empty() ? i : order[i]; }
};

ColorGroups groupByColor(const MeshBody& body);

/// The colors of several bodies, each once.
struct Palette {
    std::vector<Color> colors;
    std::map<ColorBytes, std::size_t> places; ///< in `colors`

    explicit Palette(const std::vector<const MeshBody*>& bodies);
    std::size_t placeOf(const Color& color) const { return places.at(toBytes(color)); }
};

} // namespace knead
