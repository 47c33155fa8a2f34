#include "core/session/material_look.h"

#include <algorithm>

namespace knead {

namespace {

// Between the materials that handbooks tell of, in gaps between those of different kinds.
constexpr double heaviestOther = 5000;   // density that metals alone exceed [kg/m^3]
constexpr double stiffestPlastic = 3e10; // Young's modulus beyond which what yields is a metal [Pa]
constexpr double softestWood = 3e9;      // Young's modulus [Pa]
constexpr double heaviestWood = 850;     // density; wood floats [kg/m^3]
constexpr double stiffestRubber = 2e7;   // Young's modulus [Pa]
constexpr double softestRubber = 1e5;    // below it is jelly [Pa]
constexpr double heaviestFoam = 300;     // density [kg/m^3]
constexpr double lightestClay = 1200;    // density [kg/m^3]
constexpr double strongestClay = 3e5;    // yield stress; oil clay has half of it [Pa]

} // namespace

MaterialLook materialLook(const Material& material)
{
    const double stiffness = material.youngsModulus;
    if (material.density > heaviestOther || (stiffness > stiffestPlastic && material.yields()))
        return MaterialLook::metal;
    if (material.isRubberlike())
        return MaterialLook::rubber;
    if (material.yields() && material.yieldStress < strongestClay && material.density > lightestClay)
        return MaterialLook::clay;
    if (material.density < heaviestFoam)
        return MaterialLook::plain;
    if (stiffness > softestWood && material.density < heaviestWood)
        return MaterialLook::wood;
    if (stiffness > stiffestRubber)
        return MaterialLook::plastic;
    return stiffness >= softestRubber && !material.yields() ? MaterialLook::rubber : MaterialLook::plain;
}

std::optional<Color> usualColor(MaterialLook look)
{
    switch (look) {
    case MaterialLook::rubber:
        return Color{0.36F, 0.37F, 0.39F};
    case MaterialLook::clay:
        return Color{0.74F, 0.56F, 0.44F};
    case MaterialLook::wood:
        return Color{0.74F, 0.55F, 0.36F};
    case MaterialLook::metal:
        return Color{0.64F, 0.67F, 0.71F};
    case MaterialLook::plain:
    case MaterialLook::plastic:
        break;
    }
    return std::nullopt;
}

bool hasOwnColor(const Part& part)
{
    return part.color || std::any_of(part.faces.begin(), part.faces.end(),
                                     [](const PartFace& face) { return face.color.has_value(); });
}

} // namespace knead
