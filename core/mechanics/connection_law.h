#pragma once

#include "core/aggregate/material_map.h"

#include <vector>

namespace knead {

/// What a structural connection gets from the materials of its two objects. Two objects of one material reproduce it; of two
/// materials the softer and the weaker decide, as with springs in series:
///   stiffness   k = 2 k1 k2 / (k1 + k2)      damping  b = 2 b1 b2 / (b1 + b2)
///   yield and tolerance force                the lesser of the two
/// Strains are of the connection, positive when longer; infinite where the material never yields or breaks.
struct ConnectionLaw {
    double stiffness = 0;      ///< k / (a w) [Pa]; for one material its shear modulus
    double dampingTime = 0;    ///< b / k [s]
    double yieldStrain = 0;    ///< deviatoric strain at which it begins to flow: 2/3 (1 + nu) sigma_y / E
    double hardening = 0;      ///< rise of the yield strain per plastic strain
    double flowTime = 0;       ///< [s]
    double breakingStrain = 0; ///< t / (k l), t the tolerance force

    /// Ductile material, which yields before it reaches its strength, breaks by how far it has flowed: at ln(1 + elongation), or
    /// where it has hardened up to its strength, (strength - sigma_y) / H. Infinite: it flows without end.
    double ductility = 0;
    /// Strain at which a connection breaks at once. Of brittle material the breakingStrain. What surrounds a spot that yields
    /// can keep it from yielding, at the tip of a crack or beside a grip: up to three times the flow stress (Prandtl's
    /// 1 + pi / 2 times 2 / sqrt(3)), so ductile material takes three times the breakingStrain.
    double suddenStrain = 0;
    double suddenStrainAtCrack = 0; ///< the same where connections beside it are broken
};

/// The law between two objects on a lattice of a given spacing [m].
ConnectionLaw lawBetween(const Material& a, const Material& b, double spacing);

/// The laws between all materials of a body.
class ConnectionLaws {
public:
    ConnectionLaws(const MaterialMap& materials, double spacing);

    const ConnectionLaw& between(ObjectIndex a, ObjectIndex b) const
    {
        return m_laws[m_materials->indexOf(a) * m_count + m_materials->indexOf(b)];
    }

    /// Writes one number of the laws for the connections lower + i to upper + i, i < count.
    void fill(double ConnectionLaw::*number, std::size_t lower, std::size_t upper, std::size_t count,
              double* values) const;

    double largestDampingTime() const; ///< [s]
    double leastDampingTime() const;   ///< [s]
    bool anyYields() const;
    bool anyBreaks() const;
    double leastSuddenStrain() const; ///< beside a crack; infinite where nothing breaks by load
    bool anyTires() const;            ///< breaks by plastic strain

private:
    const MaterialMap* m_materials;
    std::size_t m_count;
    std::vector<ConnectionLaw> m_laws; ///< count x count
};

} // namespace knead
