#include "core/mechanics/rubber_connections.h"

#include "core/mechanics/connection_stress.h"
#include "core/mechanics/hyperelastic_law.h"
#include "core/task/parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

// The bound of waves at rest takes the least-squares gradient of a lattice for that of two neighbors, whose largest square is four
// times as large: half of that is left for other than plane waves.
constexpr double boundSlack = 0.5;

} // namespace

void findRubber(ConnectionData& data)
{
    if (!(data.materials->largest([](const Material& material) { return material.isRubberlike() ? 1 : 0; }) > 0))
        return;
    const std::size_t count = data.aggregate->size();
    data.tensors->rubber = std::make_unique<RubberBody>();
    RubberBody& body = *data.tensors->rubber;
    body.isRubber.assign(count, 0);
    if (!data.materials->isUniform())
        for (auto* numbers : {&body.secondShare, &body.inverseChain, &body.firstScale})
            numbers->assign(count, 0);
    body.isWhole = data.materials->isUniform();
    for (ObjectIndex i = 0; i < count; ++i) {
        const bool isFlat = data.inverseShape[0][i] == 0;
        body.isRubber[i] = data.materials->of(i).isRubberlike() && !isFlat ? 1 : 0;
        body.isWhole = body.isWhole && !isFlat;
        if (data.materials->isUniform())
            continue;
        const RubberNumbers numbers = rubberNumbers(data.materials->of(i));
        body.secondShare[i] = numbers.secondShare;
        body.inverseChain[i] = numbers.inverseChain;
        body.firstScale[i] = numbers.firstScale;
    }
}

/// The springs of connections: with h the share of the ends that are not rubberlike and c = rubberSpringShare (1 - h),
///     k h / 2 (L - l)^2 + k c / 2 L^2 = k (h + c) / 2 (L - h l / (h + c))^2 + const
void findSprings(ConnectionData& data)
{
    RubberBody& body = *data.rubber();
    body.springsAreKnown = true;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const std::size_t size = body.isWhole ? 0 : data.stiffness[d].size();
        body.springShare[d].resize(size);
        body.springLength[d].resize(size);
    }
    if (body.isWhole)
        return;
    forEachBlock(data.aggregate->size(), data.blockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
            const kernels::ObjectNumber lengths = data.nominalLengths(d);
            forEachPair(data.aggregate->lattice, d, begin, end, [&](ObjectIndex i, ObjectIndex j) {
                const double spring = 1 - 0.5 * (body.isRubber[i] + body.isRubber[j]);
                const double share = spring + kernels::rubberSpringShare * (1 - spring);
                body.springShare[d][i] = share;
                body.springLength[d][i] = spring / share * valueAt(lengths, i);
            });
        }
    });
}

/// Rubberlike objects by the stretches about them, where those make waves faster than they are at rest.
void stiffenByStretch(const ConnectionData& data, const ObjectState& state, std::vector<double>& bounds)
{
    LaneVector<double> theta(state.size(), 0);
    const DeformationGradients gradients(data, state.position, theta);
    forEachBlock(state.size(), data.blockSize, [&](std::size_t begin, std::size_t end) {
        Eigen::SelfAdjointEigenSolver<Mat3> solver;
        for (std::size_t i = begin; i < end; ++i) {
            if (!data.isRubber(i))
                continue;
            const Mat3 f = gradients.of(i);
            solver.computeDirect(f.transpose() * f, Eigen::EigenvaluesOnly);
            const Vec3 stretches = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
            const Material& material = data.materials->of(static_cast<ObjectIndex>(i));
            const double rest = material.lameLambda() + 2 * material.shearModulus();
            bounds[i] *=
                std::max(1.0, boundSlack * stiffestWave(material, {stretches[0], stretches[1], stretches[2]}) / rest);
        }
    });
}

} // namespace knead
