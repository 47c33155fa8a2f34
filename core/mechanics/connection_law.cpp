#include "core/mechanics/connection_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Next to a broken connection the stress is concentrated, more than the lattice resolves: connections of brittle material that
// cross the same plane break at this share of their strain. It makes a body break where it begins to, at the force at which
// it begins to.
constexpr double strengthBesideCrack = 0.3;

// Of the flow stress in tension: the most that surroundings that do not yield can make of it.
constexpr double mostConstraint = 3;

/// Plastic strain at which ductile material breaks.
double ductilityOf(const Material& m)
{
    double strain = m.elongationAtBreak > 0 ? std::log1p(m.elongationAtBreak) : infinite;
    if (m.tensileStrength > 0 && m.hardening > 0)
        strain = std::min(strain, (m.tensileStrength - m.yieldStress) / m.hardening);
    return strain;
}

ConnectionLaw lawOf(const Material& m, double spacing)
{
    ConnectionLaw law;
    law.stiffness = m.shearModulus();
    // b = 2 zeta sqrt(k m_red) with k = mu a w and m_red = rho a^3 w / 2 gives the same b / k for every weight.
    law.dampingTime = 2 * m.dampingRatio * std::sqrt(m.density * spacing * spacing / (2 * law.stiffness));
    const double strainPerStress = 2.0 / 3 * (1 + m.poissonRatio) / m.youngsModulus;
    law.yieldStrain = m.yields() ? strainPerStress * m.yieldStress : infinite;
    law.hardening = strainPerStress * m.hardening;
    law.flowTime = m.relaxationTime;
    // Uniform tension along the lattice strains the connections along it by sigma / E; the first of them to break take the
    // others across the same plane with them.
    law.breakingStrain = m.tensileStrength > 0 ? m.tensileStrength / m.youngsModulus : infinite;
    const bool isBrittle = !m.yields() || (m.tensileStrength > 0 && m.tensileStrength <= m.yieldStress);
    law.ductility = isBrittle ? infinite : ductilityOf(m);
    law.suddenStrain = isBrittle ? law.breakingStrain : mostConstraint * law.breakingStrain;
    law.suddenStrainAtCrack = isBrittle ? strengthBesideCrack * law.breakingStrain : law.suddenStrain;
    return law;
}

double harmonicMean(double a, double b)
{
    return a + b > 0 ? 2 * a * b / (a + b) : 0;
}

} // namespace

ConnectionLaw lawBetween(const Material& a, const Material& b, double spacing)
{
    const ConnectionLaw first = lawOf(a, spacing);
    if (a == b)
        return first;
    const ConnectionLaw second = lawOf(b, spacing);
    ConnectionLaw law;
    law.stiffness = harmonicMean(first.stiffness, second.stiffness);
    law.dampingTime =
        harmonicMean(first.stiffness * first.dampingTime, second.stiffness * second.dampingTime) / law.stiffness;
    const auto lesserForce = [&](double ConnectionLaw::*strain) {
        return std::min(first.stiffness * first.*strain, second.stiffness * second.*strain) / law.stiffness;
    };
    law.yieldStrain = lesserForce(&ConnectionLaw::yieldStrain);
    law.breakingStrain = lesserForce(&ConnectionLaw::breakingStrain);
    law.suddenStrain = lesserForce(&ConnectionLaw::suddenStrain);
    law.suddenStrainAtCrack = lesserForce(&ConnectionLaw::suddenStrainAtCrack);
    // Hardening and flow are those of the object that yields first.
    const bool firstYields = first.stiffness * first.yieldStrain <= second.stiffness * second.yieldStrain;
    law.hardening = firstYields ? first.hardening : second.hardening;
    law.flowTime = firstYields ? first.flowTime : second.flowTime;
    law.ductility = std::min(first.ductility, second.ductility);
    return law;
}

ConnectionLaws::ConnectionLaws(const MaterialMap& materials, double spacing)
    : m_materials(&materials)
    , m_count(materials.materials().size())
{
    for (const Material& a : materials.materials())
        for (const Material& b : materials.materials())
            m_laws.push_back(lawBetween(a, b, spacing));
}

void ConnectionLaws::fill(double ConnectionLaw::*number, std::size_t lower, std::size_t upper, std::size_t count,
                          double* values) const
{
    if (m_count == 1) {
        std::fill_n(values, count, m_laws.front().*number);
        return;
    }
    for (std::size_t i = 0; i < count; ++i)
        values[i] = between(static_cast<ObjectIndex>(lower + i), static_cast<ObjectIndex>(upper + i)).*number;
}

double ConnectionLaws::largestDampingTime() const
{
    double largest = 0;
    for (const ConnectionLaw& law : m_laws)
        largest = std::max(largest, law.dampingTime);
    return largest;
}

double ConnectionLaws::leastDampingTime() const
{
    double least = infinite;
    for (const ConnectionLaw& law : m_laws)
        least = std::min(least, law.dampingTime);
    return least;
}

bool ConnectionLaws::anyYields() const
{
    return std::any_of(m_laws.begin(), m_laws.end(), [](const ConnectionLaw& l) { return l.yieldStrain < infinite; });
}

bool ConnectionLaws::anyBreaks() const
{
    return leastSuddenStrain() < infinite || anyTires();
}

double ConnectionLaws::leastSuddenStrain() const
{
    double least = infinite;
    for (const ConnectionLaw& law : m_laws)
        least = std::min(least, law.suddenStrainAtCrack);
    return least;
}

bool ConnectionLaws::anyTires() const
{
    return std::any_of(m_laws.begin(), m_laws.end(), [](const ConnectionLaw& l) { return l.ductility < infinite; });
}

} // namespace knead
