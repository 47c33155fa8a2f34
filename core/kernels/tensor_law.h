#pragma once

#include <cstddef>
#include <cstdint>

/// The law of material that yields or stretches far: a tensor per object beside the springs of its connections.
///
/// F is the least-squares deformation gradient of an object's connections, C its plastic metric (symmetric, det C = 1, the
/// identity at rest), theta = ln det F - theta_rest. With G = C^-1 and the elastic b = J^(-2/3) F G F^T, t = tr b / 3:
///     energy of the object   V [K theta^2 / 2 + mu (3 t - 3) / 2]        (neo-Hooke; K = lambda + 2 mu / 3)
///     Kirchhoff stress       tau = s + K theta I,  s = mu (b - t I)
/// The springs k (L - l) would bear part of that; what they bear when all follow F is taken off, so that they only
/// stabilize what F does not see:
///     B = [V tau F^-T - sum_b k / 2 (1 - l_b / |F D|) F D D^T] K^-1,  l_b = sqrt(D^T C D),  K = sum k D D^T
///     force of i towards j = k (L - l) n + k (B_i + B_j) D,  l = sqrt(l_i l_j) e^q
///
/// Flow is J2 (von Mises) with isotropic linear hardening, returned radially within the step. The norm counts what the
/// connections are strained beyond F:
///     e_b = ln(L / l) - (ln J_i + ln J_j) / 6,  e_d = ln(|F D| / l_b) - ln J / 3
///     N^2 = |s|^2 + max(0, 7.5 (2 mu)^2 sum_b k |D|^2 (e_b^2 - e_d^2) / sum_b k |D|^2)
///     Y = sqrt(2/3) (sigma_y + H alpha)
///     N > Y:  dg = dt / (dt + tau) (N - Y) / (2 mu t (1 + H / (3 mu t))),  S = 1 - 2 mu t dg / N (else 1)
///             s <- S s,  alpha += sqrt(2/3) dg,  b <- s / mu + t I, det b = 1,  C <- J^(-2/3) F^T b^-1 F
/// and what a connection is strained beyond its two F relaxes by the same factor: r = ln(L / l) - (e_i + e_j) / 2 with
/// e = ln(|F D| / l_b), q <- q + r (1 - (S_i + S_j) / 2).
///
/// Backward Euler of Perzyna's law, dg/dt = (N - Y) / (2 mu t tau): what flows steadily bears the same beyond its yield stress in steps of
/// any length, sigma_eq = sigma_y + 3 mu tau times the rate of strain.
///
/// Sources: Simo (1988) for the multiplicative return; Perzyna (1966) for the rate; Tupek and Radovitzky (2014) and Silling (2017) for
/// what stabilizes a deformation gradient that is fitted to connections.
namespace knead::kernels {

/// Component pointers to the first object of a stretch.
struct ConstVectors {
    const double* x;
    const double* y;
    const double* z;
};

/// Objects of a run, what surrounds them, and where they are. Arrays begin at object 0 and have a vector's slack around.
struct Surroundings {
    std::size_t begin;
    std::size_t end;
    const double* position; ///< component c of object i at [c * stride + i]
    std::ptrdiff_t stride;
    std::uint32_t forward;             ///< bit d: direction d is there ahead of the objects
    std::uint32_t backward;            ///< bit d: behind them
    const std::int32_t* ahead;         ///< per direction
    const std::int32_t* behind;        ///< per direction
    const std::uint32_t* hasBehind;    ///< per object: bit d where the connection from behind is its own
    const double* const* stiffness;    ///< per direction: k at the lower object
    const double* const* inverseShape; ///< 6: uu vv ww uv uw vw of (sum k o o^T)^-1; all 0 where surroundings are flat
    const double* restDilatation;      ///< theta at which there is no pressure
    double spacing;                    ///< a [m]
};

/// A number of all objects, or of each of them from object 0 on: arrays that are not read leave room in the cache.
struct ObjectNumber {
    const double* each; ///< null: all have the same
    double all;
};

/// What objects are made of.
struct TensorLawNumbers {
    const double* volume;      ///< V, less what connections that broke take of it [m^3]
    ObjectNumber shear;        ///< mu [Pa]
    ObjectNumber bulk;         ///< K [Pa]
    ObjectNumber tensionShare; ///< of K while theta > 0: 1, or where broken what springs have
    ObjectNumber yieldStress;  ///< sigma_y [Pa]; infinite: does not yield
    ObjectNumber hardening;    ///< H [Pa]
    ObjectNumber flowTime;     ///< tau [s]
    ObjectNumber shearDamage;  ///< p, see PlasticState::damage
};

/// The plastic state of the objects. Null where nothing has flowed yet: C = I, alpha = 0.
struct PlasticState {
    const double* const* metric;    ///< 6: uu vv ww uv uw vw of C, in lattice axes; det C = 1
    const double* equivalentStrain; ///< alpha
    const double*
        damage; ///< D >= 0, alpha that counts towards breaking: d alpha clamp(p + 3 (1 - p) triaxiality, 2 p - 1, 1).
                ///< With p = 1/2 that is d alpha in tension, half of it in shear, nothing in compression; with p = 0,
                ///< of material that heals, what it has been drawn out net: nothing in shear, and compression undoes it
};

/// What a flow finds. Arrays begin at object 0. `affine` is written for all objects of the run; the others at least for vectors in
/// which something flows now or has at the time before, S < 1. Elsewhere they have to hold already what no flow leaves: the
/// plastic state as it was, S = 1, nothing dissipated, no lengthening.
struct FlowResult {
    double duration;                       ///< dt [s]
    const double* const* connectionStrain; ///< per direction: ln(L / l) at the lower object
    const double* dilatation;              ///< ln J of all objects
    double* const* metric;                 ///< 6: C afterwards
    double* equivalentStrain;
    double* damage;
    double* share;              ///< S, that of the time before at first
    double* const* affine;      ///< per direction: e = ln(|F D| / l_b), with C as it was
    double* const* lengthening; ///< per direction: D^T C' D / D^T C D
    double* dissipated;         ///< energy of the object that went with it [J]
};

struct TensorLawArguments {
    Surroundings at;
    TensorLawNumbers numbers;
    PlasticState plastic;
    const FlowResult* flow; ///< null: none
    double* const* stress;  ///< 9, written: a B of the formula above, column-wise
    double* theta;          ///< written; null: not asked for
    double* energy;         ///< written: of the object, less what its springs have of it [J]; null: not asked for
};

/// Rubberlike objects, which have the law of hyperelastic_law.h; others are left alone. Their connections are springs without
/// a nominal length, k rubberSpringShare |d|^2 / 4 for each end that is rubberlike, of which what they bear when all follow F
/// is taken off: k share |d - F D|^2 / 4 is left, which holds what F does not see, at any strain, and is the gentler for
/// having no direction of its own.
struct HyperelasticArguments {
    Surroundings at;
    TensorLawNumbers numbers;
    ObjectNumber isRubber;    ///< 1 or 0
    ObjectNumber secondShare; ///< see RubberNumbers
    ObjectNumber inverseChain;
    ObjectNumber firstScale;
    const double* const* metric; ///< 6: C; null: the identity
    double* const* stress;       ///< as in TensorLawArguments, of the rubberlike objects
    double* theta;               ///< null: not asked for
    double* energy;              ///< null: not asked for
};

/// What it must be for stability is more than 0. It is what makes thin walls bend as they should: a bar of 3, 4 and 6 cells across bends
/// by 0.97, 0.99 and 0.99 of Timoshenko's deflection at Poisson's ratio 0.49 (by 0.72, 0.82, 0.90 with 1/3, and by 0.84, 0.90, 0.94
/// with the springs of small strains).
inline constexpr double rubberSpringShare = 1.0 / 8;

/// Connections from lower + i to upper + i whose nominal lengths follow a flow; see the namespace. Arrays begin at the first.
struct LengthArguments {
    ConstVectors lower; ///< places of the objects
    ConstVectors upper;
    const double* strain; ///< ln(L / l)
    const double* lowerShare;
    const double* upperShare;
    const double* lowerAffine;
    const double* upperAffine;
    const double* lowerLengthening;
    const double* upperLengthening;
    const double* stiffness;
    const double* before; ///< l
    double* after;        ///< l; may be the same place
    double* dissipated;   ///< sumLanes partial sums [J]
    double* work;         ///< the same, of the force afterwards on what they get longer [J]
};

/// Material that has lost half of its volume fades out of this law, by the share of det F between these two, and does not flow:
/// what F says there is not reliable, and a logarithm that went on would be stiffer than steps that were chosen before can take (by
/// 330 times at a tenth of the volume). Springs go on alone, which bear any squashing.
inline constexpr double wholeVolumeRatio = 0.5;
inline constexpr double leastVolumeRatio = 0.3;

} // namespace knead::kernels
