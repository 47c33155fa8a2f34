#include "core/mechanics/stress_law.h"

#include "core/mechanics/hyperelastic_law.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double leastJacobian = 1e-3; // of squashed material: logarithms and powers stay finite
constexpr double leastLength = 1e-12;  // [a^2] of squashed springs, squared

Mat3 deviator(const Mat3& tensor)
{
    return tensor - tensor.trace() / 3 * Mat3::Identity();
}

/// sum_d (1 - l / L) F d (F d)^T: of the ways along the axes and of those across faces.
Mat3 springSum(const Mat3& gradient, const Mat3& relaxed)
{
    Mat3 sum = Mat3::Zero();
    const auto add = [&](const Vec3& now, double nominalSquared) {
        const double squared = std::max(now.squaredNorm(), leastLength);
        sum += (1 - std::sqrt(std::max(nominalSquared, leastLength) / squared)) * now * now.transpose();
    };
    for (Eigen::Index i = 0; i < 3; ++i) {
        const Eigen::Index j = (i + 1) % 3;
        const double both = relaxed(i, i) + relaxed(j, j);
        add(gradient.col(i), relaxed(i, i));
        add(gradient.col(i) + gradient.col(j), both + 2 * relaxed(i, j));
        add(gradient.col(i) - gradient.col(j), both - 2 * relaxed(i, j));
    }
    return sum;
}

/// What a volumetric energy 1/2 B g^2 gives per logarithm of volume, see volumetricStrain() in lattice_kernels.h: g = theta, where
/// B < 0 and volume is lost theta / (1 - theta).
double volumetricTension(double stiffness, double theta)
{
    if (stiffness >= 0 || theta >= 0)
        return stiffness * theta;
    return stiffness * theta / std::pow(1 - theta, 3);
}

} // namespace

Mat3 cauchyStress(const Mat3& gradient, const Mat3& relaxed, const Material& material, double mostVonMises)
{
    const double mu = material.shearModulus();
    const double lambda = material.lameLambda();
    const double J =
        std::max(gradient.determinant() / std::sqrt(std::max(relaxed.determinant(), 1e-12)), leastJacobian);
    if (!material.isTensorial()) {
        const Mat3 springs = mu * springSum(gradient, relaxed);
        const double tension = volumetricTension(lambda - mu, std::log(J));
        return limitedStress((springs + tension * Mat3::Identity()) / J, mostVonMises);
    }
    const Mat3 b = gradient * relaxed.inverse() * gradient.transpose();
    const double bulk = lambda + 2 * mu / 3;
    if (material.isRubberlike()) {
        const RubberNumbers rubber = rubberNumbers(material);
        const Mat3 isochoric = b / std::cbrt(J * J);
        const double first = isochoric.trace();
        const double slope = firstSlope(rubber.firstScale, rubber.inverseChain, first);
        const Mat3 shear =
            deviator((slope + rubber.secondShare * first) * isochoric - rubber.secondShare * isochoric * isochoric);
        return (mu * shear + bulk * std::log(J) * Mat3::Identity()) / J;
    }
    return limitedStress((mu / std::cbrt(J * J) * deviator(b) + bulk * std::log(J) * Mat3::Identity()) / J,
                         mostVonMises);
}

Material bearingMaterial(const Material& material, const MaterialMap& body)
{
    Material bearing = material;
    if (material.isTensorial() || body.isUniform() ||
        !(body.largest([](const Material& other) { return other.isTensorial() ? 1 : 0; }) > 0))
        return bearing;
    bearing.rubberlike = 1;
    bearing.secondInvariantShare = 0;
    bearing.lockingElongation = 0;
    return bearing;
}

Mat3 limitedStress(const Mat3& stress, double mostVonMises)
{
    if (mostVonMises == std::numeric_limits<double>::infinity())
        return stress;
    const double borne = vonMisesStress(stress);
    if (!(borne > mostVonMises))
        return stress;
    const Mat3 pressure = stress.trace() / 3 * Mat3::Identity();
    return pressure + mostVonMises / borne * (stress - pressure);
}

double equivalentStrain(const Mat3& strain)
{
    return std::sqrt(2.0 / 3) * deviator(strain).norm();
}

double vonMisesStress(const Mat3& stress)
{
    return std::sqrt(1.5) * deviator(stress).norm();
}

double flowStress(const Material& material, double plasticStrain)
{
    return material.yields() ? material.yieldStress + material.hardening * plasticStrain
                             : std::numeric_limits<double>::infinity();
}

} // namespace knead
