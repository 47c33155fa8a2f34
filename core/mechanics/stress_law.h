#pragma once

#include "core/aggregate/material_map.h"
#include "core/geometry/vec3.h"

#include <limits>

namespace knead {

/// Cauchy stress [Pa] of a material that is deformed by F and would be at rest with the metric C: what a body of the lattice
/// bears by its section where the deformation is even. Elastic is b = F C^-1 F^T, its change of volume J = sqrt(det b), and
///   sigma = (mu sum_d (1 - l / L) F d (F d)^T + (lambda - mu) ln J I) / J,  L = |F d|, l = sqrt(d^T C d)
/// with the ways d to the neighbors ahead in units of the spacing: the sum of the connections, which are linear springs, and of
/// the volumetric term, which goes slower than ln J where lambda < mu and volume is lost. For small elastic strain e it is 2 mu e + lambda tr e I. Material that yields:
///   sigma = (mu dev(J^(-2/3) b) + K ln J I) / J,  K = lambda + 2/3 mu
/// Rubberlike material has the same pressure and the deviator of hyperelastic_law.h, with B = J^(-2/3) b:
///   sigma = (mu dev(((1 - beta) A' + beta I1) B - beta B^2) + K ln J I) / J
/// In all it turns with F. Material that is squashed flat or inside out is taken as squashed to a thousandth.
/// Pure; any thread.
/// @param relaxed C, symmetric and positive; the identity at the start
/// @param mostVonMises what the material can bear [Pa]: beyond, the deviator is scaled down to it
Mat3 cauchyStress(const Mat3& gradient, const Mat3& relaxed, const Material& material,
                  double mostVonMises = std::numeric_limits<double>::infinity());

/// What an object bears stress as: in a body where any material yields or is rubberlike, elastic one is neo-Hooke, see
/// tensor_law.h.
Material bearingMaterial(const Material& material, const MaterialMap& body);

/// The stress with its deviator scaled down so that its von Mises stress is at most so much.
Mat3 limitedStress(const Mat3& stress, double mostVonMises);

/// sqrt(2/3 e:e) of the deviator e: the strain of a bar that is stretched as much at constant volume.
double equivalentStrain(const Mat3& strain);

/// sqrt(3/2 s:s) of the deviator s [Pa]: the tension of a bar that is as near to yielding.
double vonMisesStress(const Mat3& stress);

/// The material's flow stress [Pa] after so much equivalent plastic strain, sigma_y + H alpha; infinite when it never yields.
double flowStress(const Material& material, double plasticStrain);

} // namespace knead
