#include "core/session/compensation.h"

#include "core/deformation/field_map.h"
#include "core/geometry/rigid_fit.h"
#include "core/message/message.h"
#include "core/session/place_grid.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <memory>

namespace knead {

namespace {

/// The same with what is left when it is moved rigidly so that points that count fit best.
void fitRigidly(const TargetPoints& points, std::vector<Vec3>& places)
{
    std::vector<Vec3> from;
    std::vector<Vec3> to;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (points.counts[i]) {
            from.push_back(places[i]);
            to.push_back(points.places[i]);
        }
    const RigidFit fit = fitRigidMotion(from, to);
    for (Vec3& place : places)
        place = fit.turn * (place - fit.from) + fit.to;
}

void sumUp(const TargetPoints& points, CompensationRound& round)
{
    round.largest = -1;
    double squares = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.places.size(); ++i) {
        if (!points.counts[i])
            continue;
        const double distance = round.deviations[i].norm();
        if (distance > round.largest) {
            round.largest = distance;
            round.worst = i;
        }
        squares += distance * distance;
        ++count;
    }
    round.largest = std::max(0.0, round.largest);
    round.mean = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, count)));
}

/// The value at a place of the linear function that fits those around it best.
Vec3 fittedAt(const Vec3& place, const std::vector<Vec3>& places, const std::vector<Vec3>& values, double radius,
              const std::vector<std::uint32_t>& around)
{
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Matrix<double, 4, 3> right = Eigen::Matrix<double, 4, 3>::Zero();
    for (const std::uint32_t i : around) {
        const Vec3 from = (places[i] - place) / radius;
        const double inside = 1 - from.squaredNorm();
        if (inside <= 0)
            continue;
        const Eigen::Vector4d terms(1, from.x(), from.y(), from.z());
        normal += inside * inside * terms * terms.transpose();
        right += inside * inside * terms * values[i].transpose();
    }
    // On a flat face, or alone, nothing is known across: no slope there.
    return normal.completeOrthogonalDecomposition().solve(right).row(0).transpose();
}

} // namespace

CompensationState stateAfter(const std::vector<CompensationRound>& rounds, const CompensationMethod& method)
{
    CompensationState state{.factor = method.factor};
    int growths = 0;
    for (std::size_t k = 1; k < rounds.size(); ++k) {
        state.isHalved = rounds[k].largest >= rounds[state.best].largest && ++growths == 1;
        if (state.isHalved)
            state.factor = rounds[k].factor / 2;
        if (rounds[k].largest < rounds[state.best].largest)
            state.best = k;
    }
    if (rounds[state.best].largest <= method.tolerance)
        state.end = CompensationEnd::within;
    else if (growths > 1)
        state.end = CompensationEnd::diverged;
    else if (rounds.size() >= static_cast<std::size_t>(method.rounds))
        state.end = CompensationEnd::rounds;
    return state;
}

namespace {

// Of the factor of the study, or of what a round that failed left of it: how far that of a round may be from it.
constexpr double leastOfFactor = 0.5;
constexpr double mostOfFactor = 2;

/// Of a round, S d.
std::vector<Vec3> wrongOf(const TargetPoints& points, const CompensationRound& round, const CompensationMethod& method)
{
    return method.smoothing > 0 ? smoothed(points.places, round.deviations, method.smoothing) : round.deviations;
}

/// With which the last step would have left the least (Aitken): w <d, d - d'> / |d - d'|^2, where w took the deviations from d
/// to d'.
double learnedFactor(const TargetPoints& points, const std::vector<Vec3>& before, const std::vector<Vec3>& now,
                     double factor)
{
    double along = 0;
    double squared = 0;
    for (std::size_t i = 0; i < points.places.size(); ++i) {
        if (!points.counts[i])
            continue;
        const Vec3 change = before[i] - now[i];
        along += before[i].dot(change);
        squared += change.squaredNorm();
    }
    return squared > 0 ? factor * along / squared : factor;
}

} // namespace

CompensationRound nextRound(const TargetPoints& points, const std::vector<CompensationRound>& rounds,
                            const CompensationMethod& method)
{
    CompensationRound next{.number = static_cast<int>(rounds.size()) + 1, .factor = method.factor};
    if (rounds.empty()) {
        next.compensation.assign(points.places.size(), Vec3::Zero());
        return next;
    }
    const CompensationState state = stateAfter(rounds, method);
    const CompensationRound& best = rounds[state.best];
    next.factor = state.factor;
    next.compensation = best.compensation;
    const std::vector<Vec3> wrong = wrongOf(points, best, method);
    if (const std::size_t last = rounds.size() - 1; last > 0 && state.best == last) {
        const std::vector<CompensationRound> earlier(rounds.begin(), rounds.end() - 1);
        const std::vector<Vec3> before = wrongOf(points, rounds[stateAfter(earlier, method).best], method);
        const double learned = learnedFactor(points, before, wrong, best.factor);
        next.factor = std::clamp(learned, leastOfFactor * state.factor, mostOfFactor * state.factor);
    }
    for (std::size_t i = 0; i < wrong.size(); ++i)
        next.compensation[i] -= next.factor * wrong[i];
    return next;
}

std::optional<FieldDeformation> shapeOf(const TargetPoints& points, const CompensationRound& round)
{
    if (std::ranges::all_of(round.compensation, [](const Vec3& moved) { return moved.isZero(0); }))
        return std::nullopt;
    return FieldDeformation{.field = std::make_shared<const DisplacementField>(
                                DisplacementField{.nodes = points.places, .displacements = round.compensation})};
}

void measureRound(const TargetPoints& points, const SmoothMap& result, bool fitsBest, CompensationRound& round,
                  TaskControl& control)
{
    std::vector<Vec3> shape = points.places;
    if (const std::optional<FieldDeformation> deformation = shapeOf(points, round))
        fieldMap(*deformation, control)->evaluate(points.places, shape);
    control.throwIfCancelled();
    std::vector<Vec3> places(shape.size());
    result.evaluate(shape, places);
    if (fitsBest)
        fitRigidly(points, places);
    round.deviations.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        round.deviations[i] = places[i] - points.places[i];
    if (!std::ranges::all_of(round.deviations, [](const Vec3& deviation) { return deviation.allFinite(); }))
        throw Problem(Message("Compensation",
                              "What came out of round %1 has places that are no numbers; look at what its "
                              "command wrote.")
                          .with(round.number));
    sumUp(points, round);
}

std::vector<Vec3> smoothed(const std::vector<Vec3>& places, const std::vector<Vec3>& values, double radius)
{
    PlaceGrid grid(radius);
    for (const Vec3& place : places)
        grid.add(place);
    std::vector<Vec3> result;
    result.reserve(values.size());
    for (const Vec3& place : places)
        result.push_back(fittedAt(place, places, values, radius, grid.around(place)));
    return result;
}

} // namespace knead
