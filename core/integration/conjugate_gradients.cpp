#include "core/integration/conjugate_gradients.h"

#include "core/mechanics/tangent_kernels.h"
#include "core/task/parallel.h"

#include <array>
#include <numeric>

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;

} // namespace

double dotProduct(const VectorArray& a, const VectorArray& b)
{
    std::vector<double> sums((a.size() + blockSize - 1) / blockSize);
    forEachBlock(a.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        std::array<double, kernels::sumLanes> lanes{};
        for (std::size_t c = 0; c < 3; ++c)
            kernels::bestTangents().dot(end - begin, a.component(c) + begin, b.component(c) + begin, lanes.data());
        sums[begin / blockSize] = std::accumulate(lanes.begin(), lanes.end(), 0.0);
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

ConjugateGradients::Report ConjugateGradients::solve(ImplicitSystem& system, RigidModePreconditioner& preconditioner,
                                                     VectorArray& residual, VectorArray& solution, double goal,
                                                     int most, const std::function<bool()>& isStopped)
{
    for (VectorArray* vectors : {&m_direction, &m_preconditioned, &m_product})
        vectors->resize(system.rows());
    preconditioner.apply(residual, m_preconditioned);
    m_direction = m_preconditioned;
    Report report;
    report.start = report.end = dotProduct(residual, m_preconditioned);
    while (report.end > goal && report.iterations < most && !(isStopped && isStopped())) {
        system.multiply(m_direction, m_product);
        const double curvature = dotProduct(m_direction, m_product);
        if (!(curvature > 0)) // rounding is all that is left
            break;
        const double length = report.end / curvature;
        forEachBlock(system.rows(), blockSize, [&](std::size_t begin, std::size_t end) {
            for (std::size_t c = 0; c < 3; ++c)
                kernels::bestTangents().descend(end - begin, length, m_direction.component(c) + begin,
                                                m_product.component(c) + begin, solution.component(c) + begin,
                                                residual.component(c) + begin);
        });
        preconditioner.apply(residual, m_preconditioned);
        const double next = dotProduct(residual, m_preconditioned);
        const double share = next / report.end;
        forEachBlock(system.rows(), blockSize, [&](std::size_t begin, std::size_t end) {
            for (std::size_t c = 0; c < 3; ++c)
                kernels::bestTangents().turn(end - begin, share, m_preconditioned.component(c) + begin,
                                             m_direction.component(c) + begin);
        });
        report.end = next;
        ++report.iterations;
    }
    return report;
}

} // namespace knead
