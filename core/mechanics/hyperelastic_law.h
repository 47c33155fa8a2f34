#pragma once

namespace knead {

struct Material;

/// The law of rubberlike material: its energy by the invariants of the elastic deformation.
///
/// With the elastic b = J^(-2/3) F C^-1 F^T, I1 = tr b, I2 = (I1^2 - tr b^2) / 2 and theta = ln J:
///     W = K theta^2 / 2 + mu / 2 [(1 - beta) A(I1) + beta (I2 - 3)]
///     A(I1) = sum_n 2 c_n (I1^n - 3^n) / N^(n-1) / A0,  c = 1/2, 1/20, 11/1050, 19/7000, 519/673750
/// A0 makes A'(3) = 1, so that mu and K are those of Young's modulus and Poisson's ratio at small strains. beta is Mooney's
/// share C01 / (C10 + C01), N the square of the stretch at which the chains of Arruda and Boyce are straight, here found
/// from the tension that a person pulls with: N = (s^2 + 2 / s) / 3, s = 1 + locking elongation. beta = 0 and
/// N infinite make neo-Hooke.
///
/// Why these: makers of rubber give hardness or modulus, strength and elongation at break; the first is mu, the last is near
/// s, and Mooney's share is what text books tabulate beside (0 .. 0.3 for unfilled vulcanizates). The five terms of
/// Arruda and Boyce have no pole as Gent's law has, so no blow makes them infinite, and A', A'' > 0 keeps the material
/// stable at any stretch, which Ogden's exponents fitted by others need not.
///
/// Where less than leastRubberRatio of the volume is left, the volumetric energy goes on as its parabola and J^(-2/3) as its
/// tangent: squashed and inverted material is pushed back with a stiffness that stays finite.
///
/// Sources: Mooney (1940); Rivlin (1948); Arruda and Boyce (1993), with the normalization by their initial modulus.
struct RubberNumbers {
    double secondShare = 0;  ///< beta
    double inverseChain = 0; ///< 1 / N
    double firstScale = 1;   ///< (1 - beta) / A0
};

RubberNumbers rubberNumbers(const Material& material);

/// J below which it does not soften further.
inline constexpr double leastRubberRatio = 0.5;

/// A stiffness that no plane wave in material stretched by `stretches` exceeds, by the undeformed volume and per square of
/// the undeformed wave number [Pa]. A bound of the acoustic tensor of W, not its largest value.
double stiffestWave(const Material& material, const double (&stretches)[3]);

/// (1 - beta) A'(I1), for numbers and for vectors of them.
template <typename Real>
[[gnu::always_inline]] inline Real firstSlope(const Real& scale, const Real& inverseChain, const Real& first)
{
    const Real x = inverseChain * first;
    return scale * ((((519.0 / 67375 * x + 19.0 / 875) * x + 11.0 / 175) * x + 1.0 / 5) * x + 1.0);
}

/// (1 - beta) A(I1).
template <typename Real>
[[gnu::always_inline]] inline Real firstEnergy(const Real& scale, const Real& inverseChain, const Real& first)
{
    const Real x = inverseChain * first;
    const Real y = inverseChain * 3.0;
    const Real here = (((519.0 / 336875 * x + 19.0 / 3500) * x + 11.0 / 525) * x + 1.0 / 10) * x + 1.0;
    const Real rest = (((519.0 / 336875 * y + 19.0 / 3500) * y + 11.0 / 525) * y + 1.0 / 10) * y + 1.0;
    return scale * (first * here - 3.0 * rest);
}

/// (1 - beta) A''(I1).
template <typename Real>
[[gnu::always_inline]] inline Real firstCurvature(const Real& scale, const Real& inverseChain, const Real& first)
{
    const Real x = inverseChain * first;
    return scale * inverseChain * (((2076.0 / 67375 * x + 57.0 / 875) * x + 22.0 / 175) * x + 1.0 / 5);
}

} // namespace knead
