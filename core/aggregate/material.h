#pragma once

#include "core/message/message.h"

#include <string>
#include <vector>

namespace knead {

/// What a body is made of, in the numbers an engineer knows. Lattice parameters follow from these and the spacing.
struct Material {
    double density = 1100;      ///< [kg/m^3], 1 .. 30000
    double youngsModulus = 1e6; ///< [Pa], 100 .. 1e12
    double poissonRatio = 0.25; ///< 0 .. 0.49
    double dampingRatio = 0.05; ///< of a single connection, b / (2 sqrt(k m_red)), 0 .. 0.3
    double shapeDamping = 0;    ///< rate at which deviations from rigid motion decay [1/s], 0 .. 1000
    double friction = 0.4;      ///< Coulomb coefficient of contacts, 0 .. 2

    double adhesion = 0;          ///< tension that skins bear after they touched [Pa], 0 .. 1e9; 0: they do not stick
    double tensileStrength = 0;   ///< [Pa], 0 .. 1e11; 0: never breaks
    double yieldStress = 0;       ///< in uniaxial tension [Pa], 0 .. 1e11; 0: never yields
    double hardening = 0;         ///< rise of the yield stress per plastic strain [Pa], 0 .. 1e11
    double elongationAtBreak = 0; ///< of a bar, by its length, when it breaks, 0 .. 100; 0: without limit
    double relaxationTime = 0;    ///< in which stress beyond yield flows off [s], 0 .. 1000; 0: at once
    double toughness = 0;         ///< work of a knife per area that it cuts [J/m^2], 0 .. 1e6; 0: knives do not cut it
    double healingTime = 0;       ///< pressed together for so long, skins become one [s], 0 .. 1e4; 0: never

    /// The law of hyperelastic_law.h at any strain, 0 .. 1; 0: the springs of connections alone, which is for small strains.
    /// Material that yields is neo-Hooke before it does, and these three change nothing of it.
    double rubberlike = 0;
    double secondInvariantShare = 0; ///< Mooney's C01 / (C10 + C01), 0 .. 1
    double lockingElongation = 0;    ///< of a bar whose chains are straight, stretch less 1, 0 .. 100; 0: never

    friend bool operator==(const Material&, const Material&) = default;

    double shearModulus() const { return youngsModulus / (2 * (1 + poissonRatio)); } ///< mu [Pa]
    double lameLambda() const                                                        ///< lambda [Pa]
    {
        return youngsModulus * poissonRatio / ((1 + poissonRatio) * (1 - 2 * poissonRatio));
    }
    double soundSpeed() const; ///< of a thin bar, sqrt(E / rho) [m/s]

    bool yields() const { return yieldStress > 0; }
    bool breaks() const { return tensileStrength > 0 || (yields() && elongationAtBreak > 0); }
    bool isCut() const { return toughness > 0; } ///< by knives
    bool heals() const { return healingTime > 0; }
    bool isRubberlike() const { return rubberlike > 0 && !yields(); }
    bool isTensorial() const { return yields() || isRubberlike(); } ///< a tensor per object bears the stress
};

/// Describes one number of Material: for panels, recipes and messages.
struct MaterialField {
    const char* key;  ///< as in recipes: "youngs_modulus_pa"
    const char* name; ///< as a person reads it: "Young's modulus"
    const char* unit; ///< "Pa"; empty for pure numbers
    double minimum;
    double maximum;
    double Material::*value;
    const char* zero = ""; ///< what 0 means when it is no number like others: "never breaks"
};

/// All numbers of Material in the order a panel shows them.
const std::vector<MaterialField>& materialFields();

/// One sentence per number that is not finite or out of range; empty when the material can be simulated.
std::vector<Message> materialProblems(const Material& material);

/// A named material with where its numbers come from.
struct MaterialPreset {
    std::string id;   ///< "natural-rubber"
    std::string name; ///< "Natural rubber"
    std::string source;
    Material material;
};

} // namespace knead
