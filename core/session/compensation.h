#pragma once

#include "core/deformation/field_deformation.h"
#include "core/geometry/smooth_map.h"
#include "core/session/compensation_study.h"
#include "core/session/target_points.h"
#include "core/task/task_control.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace knead {

/// One round of a compensation: a shape, and how far what comes of it is from the target.
struct CompensationRound {
    int number = 1;
    double factor = 1; ///< w with which its shape was found
    std::vector<Vec3>
        compensation;             ///< c_k: what takes the target to the shape of the round, at the target's points [m]
    std::vector<Vec3> deviations; ///< d_k: from the target to what came out, at these points [m]

    // Of points that count.
    std::size_t worst = 0; ///< the point with the largest deviation
    double largest = 0;    ///< [m]
    double mean = 0;       ///< square mean [m]
};

/// Why a compensation goes on no longer.
enum class CompensationEnd {
    within,   ///< the largest deviation is within the tolerance
    rounds,   ///< as many rounds as were asked for
    diverged, ///< deviations grew with half the factor, too
};

/// Where a compensation is after some rounds.
struct CompensationState {
    std::size_t best = 0;               ///< the round with the least largest deviation, index
    double factor = 1;                  ///< of the study, or half of that of a round that failed
    bool isHalved = false;              ///< the last round was worse than the best one, hence half its factor
    std::optional<CompensationEnd> end; ///< none: another round
};

/// @pre at least one round
CompensationState stateAfter(const std::vector<CompensationRound>& rounds, const CompensationMethod& method);

/// The shape of the next round: displacement adjustment from the best round,
///     c_{k+1} = c_k - w_k S d_k,
/// where S smooths. The first step takes w = factor; while deviations fall, the later ones take what the step before them would
/// have had to (Aitken's relaxation, w_{k-1} <d_{k-1}, d_{k-1} - d_k> / |d_{k-1} - d_k|^2), from half the factor to twice. The target is always deformed as a whole by c, never a shape that was deformed before, so that nothing that the
/// map of a field leaves out adds up. The first round is the target itself.
/// Its deviations are empty.
CompensationRound nextRound(const TargetPoints& points, const std::vector<CompensationRound>& rounds,
                            const CompensationMethod& method);

/// How the target is deformed for a round; none for a round that is the target itself.
std::optional<FieldDeformation> shapeOf(const TargetPoints& points, const CompensationRound& round);

/// Fills in how far what came out is from the target, with C and U the maps to the shape and from there to what came out:
///     d(X) = U(C(X)) - X.
/// @param result U, in coordinates of the round's shape
/// @throws as fieldMap()
void measureRound(const TargetPoints& points, const SmoothMap& result, bool fitsBest, CompensationRound& round,
                  TaskControl& control = TaskControl::none());

/// Values at places, smoothed: at each place that of the linear function which fits the values within `radius` best, with weights
/// (1 - r^2 / radius^2)^2. Linear fields stay what they are.
std::vector<Vec3> smoothed(const std::vector<Vec3>& places, const std::vector<Vec3>& values, double radius);

} // namespace knead
