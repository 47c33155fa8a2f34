// Rubberlike objects and the springs of their connections: part of StructuralConnections.
#include "core/mechanics/hyperelastic_law.h"
#include "core/mechanics/lattice_stretches.h"
#include "core/mechanics/structural_connections.h"
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

void StructuralConnections::findRubber()
{
    if (!(m_materials->largest([](const Material& material) { return material.isRubberlike() ? 1 : 0; }) > 0))
        return;
    const std::size_t count = m_aggregate->size();
    m_tensors->rubber = std::make_unique<RubberBody>();
    RubberBody& body = *m_tensors->rubber;
    body.isRubber.assign(count, 0);
    if (!m_materials->isUniform())
        for (auto* numbers : {&body.secondShare, &body.inverseChain, &body.firstScale})
            numbers->assign(count, 0);
    body.isWhole = m_materials->isUniform();
    for (ObjectIndex i = 0; i < count; ++i) {
        const bool isFlat = m_inverseShape[0][i] == 0;
        body.isRubber[i] = m_materials->of(i).isRubberlike() && !isFlat ? 1 : 0;
        body.isWhole = body.isWhole && !isFlat;
        if (m_materials->isUniform())
            continue;
        const RubberNumbers numbers = rubberNumbers(m_materials->of(i));
        body.secondShare[i] = numbers.secondShare;
        body.inverseChain[i] = numbers.inverseChain;
        body.firstScale[i] = numbers.firstScale;
    }
}

/// The springs of connections: with h the share of the ends that are not rubberlike and c = rubberSpringShare (1 - h),
///     k h / 2 (L - l)^2 + k c / 2 L^2 = k (h + c) / 2 (L - h l / (h + c))^2 + const
void StructuralConnections::findSprings()
{
    RubberBody& body = *rubber();
    body.springsAreKnown = true;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const std::size_t size = body.isWhole ? 0 : m_stiffness[d].size();
        body.springShare[d].resize(size);
        body.springLength[d].resize(size);
    }
    if (body.isWhole)
        return;
    forEachBlock(m_aggregate->size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
            const LaneVector<double>& own = plasticState().nominalLength[d];
            const double uniform = m_aggregate->lattice.direction(static_cast<int>(d)).norm();
            forEachForward(m_aggregate->lattice, d, begin, end,
                           [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                               for (std::size_t s = 0; s < n; ++s) {
                                   const double spring = 1 - 0.5 * (body.isRubber[i + s] + body.isRubber[j + s]);
                                   const double share = spring + kernels::rubberSpringShare * (1 - spring);
                                   body.springShare[d][lower + s] = share;
                                   body.springLength[d][lower + s] =
                                       spring / share * (own.empty() ? uniform : own[lower + s]);
                               }
                           });
        }
    });
}

void StructuralConnections::applyHyperelasticLaw(const VectorArray& position, bool withEnergy)
{
    const RubberBody& body = *rubber();
    const RubberNumbers own = rubberNumbers(m_materials->materials().front());
    const auto number = [](const LaneVector<double>& each, double all) {
        return kernels::ObjectNumber{each.empty() ? nullptr : each.data(), all};
    };
    const kernels::TensorLawNumbers numbers = tensorNumbers();
    const PlasticState& state = plasticState();
    const std::array<double*, 9> stress = stressColumns(position.size());
    const auto metric = pointersTo<const double*>(state.metric);
    forEachSurroundings(position, [&](const kernels::Surroundings& at) {
        kernels::best().hyperelasticLaw(
            {.at = at,
             .numbers = numbers,
             .isRubber = body.isWhole ? kernels::ObjectNumber{nullptr, 1} : number(body.isRubber, 0),
             .secondShare = number(body.secondShare, own.secondShare),
             .inverseChain = number(body.inverseChain, own.inverseChain),
             .firstScale = number(body.firstScale, own.firstScale),
             .metric = state.metric[0].empty() ? nullptr : metric.data(),
             .stress = stress.data(),
             .theta = withEnergy ? m_theta.data() : nullptr,
             .energy = withEnergy ? m_tensors->energy.data() : nullptr});
    });
}

/// Rubberlike objects by the stretches about them, where those make waves faster than they are at rest.
void StructuralConnections::stiffenByStretch(const ObjectState& state, std::vector<double>& bounds) const
{
    std::array<LaneVector<double>, 9> gradients;
    for (auto& component : gradients)
        component.assign(state.size(), 0);
    LaneVector<double> theta(state.size(), 0);
    const auto gradient = pointersTo<double*>(gradients);
    forEachSurroundings(state.position, [&](const kernels::Surroundings& at) {
        kernels::best().deformation(at, theta.data(), gradient.data());
    });
    forEachBlock(state.size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
        Eigen::SelfAdjointEigenSolver<Mat3> solver;
        for (std::size_t i = begin; i < end; ++i) {
            if (!isRubber(i))
                continue;
            Mat3 f;
            for (std::size_t n = 0; n < 9; ++n)
                f(static_cast<Eigen::Index>(n % 3), static_cast<Eigen::Index>(n / 3)) = gradients[n][i];
            solver.computeDirect(f.transpose() * f, Eigen::EigenvaluesOnly);
            const Vec3 stretches = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
            const Material& material = m_materials->of(static_cast<ObjectIndex>(i));
            const double rest = material.lameLambda() + 2 * material.shearModulus();
            bounds[i] *=
                std::max(1.0, boundSlack * stiffestWave(material, {stretches[0], stretches[1], stretches[2]}) / rest);
        }
    });
}

} // namespace knead
