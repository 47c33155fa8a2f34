#include "core/integration/conjugate_gradients.h"

#include "core/kernels/kernels.h"
#include "core/task/block_sums.h"

#include <array>
#include <numeric>

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;
constexpr std::size_t slotsAtATime = 2048;

} // namespace

double dotProduct(const VectorArray& a, const VectorArray& b)
{
    return sumOverBlocks(a.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        std::array<double, kernels::sumLanes> lanes{};
        for (std::size_t c = 0; c < 3; ++c)
            kernels::best().dot(end - begin, a.component(c) + begin, b.component(c) + begin, lanes.data());
        return std::accumulate(lanes.begin(), lanes.end(), 0.0);
    });
}

ConjugateGradients::Report ConjugateGradients::solve(ImplicitSystem& system, RigidModePreconditioner& preconditioner,
                                                     const VectorArray& residual, VectorArray& solution, double goal,
                                                     int most, const std::function<bool()>& isStopped)
{
    for (FloatArray* vectors : {&m_solution, &m_direction, &m_preconditioned, &m_product})
        vectors->resize(system.slotCount());
    const double scale = scaleOf(residual);
    system.gather(residual, scale, m_residual);
    goal *= scale * scale;
    Report report;
    report.start = report.end = preconditioner.apply(m_residual, m_preconditioned);
    m_direction = m_preconditioned;
    while (report.end > goal && report.iterations < most && !(isStopped && isStopped())) {
        const double curvature = system.multiply(m_direction, m_product);
        if (!(curvature > 0)) // rounding is all that is left
            break;
        const auto length = static_cast<float>(report.end / curvature);
        forEachBlock(system.slotCount(), slotsAtATime, [&](std::size_t begin, std::size_t end) {
            for (std::size_t c = 0; c < 3; ++c)
                kernels::best().descend(end - begin, length, m_direction.component(c) + begin,
                                        m_product.component(c) + begin, m_solution.component(c) + begin,
                                        m_residual.component(c) + begin);
            preconditioner.begin(m_residual, m_preconditioned, begin, end);
        });
        const double next = preconditioner.finish(m_residual, m_preconditioned);
        const auto share = static_cast<float>(next / report.end);
        forEachBlock(system.slotCount(), slotsAtATime, [&](std::size_t begin, std::size_t end) {
            for (std::size_t c = 0; c < 3; ++c)
                kernels::best().turn(end - begin, share, m_preconditioned.component(c) + begin,
                                     m_direction.component(c) + begin);
        });
        report.end = next;
        ++report.iterations;
    }
    system.addTo(solution, 1 / scale, m_solution);
    report.start /= scale * scale;
    report.end /= scale * scale;
    return report;
}

} // namespace knead
