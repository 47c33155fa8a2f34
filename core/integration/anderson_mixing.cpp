#include "core/integration/anderson_mixing.h"

#include "core/integration/conjugate_gradients.h"
#include "core/integration/solver_settings.h"

#include <Eigen/Cholesky>

namespace knead {

namespace {

VectorArray difference(const VectorArray& a, const VectorArray& b)
{
    VectorArray result = a;
    for (std::size_t n = 0; n < 3 * result.stride(); ++n)
        *(result.data() + n) -= *(b.data() + n);
    return result;
}

void addScaled(VectorArray& to, double factor, const VectorArray& from)
{
    for (std::size_t n = 0; n < 3 * to.stride(); ++n)
        *(to.data() + n) += factor * *(from.data() + n);
}

} // namespace

void AndersonMixing::restart()
{
    m_differences.clear();
    m_hasLast = false;
}

void AndersonMixing::accelerate(const VectorArray& start, VectorArray& next)
{
    VectorArray way = difference(next, start);
    if (m_hasLast) {
        m_differences.push_back({difference(start, m_start), difference(way, m_way)});
        if (m_differences.size() > solverSettings.mixing.mostDifferences)
            m_differences.pop_front();
    }
    const auto count = static_cast<Eigen::Index>(m_differences.size());
    if (count > 0) {
        Eigen::MatrixXd products(count, count);
        Eigen::VectorXd right(count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const VectorArray& own = m_differences[static_cast<std::size_t>(i)].way;
            right[i] = dotProduct(own, way);
            for (Eigen::Index j = 0; j <= i; ++j)
                products(i, j) = products(j, i) = dotProduct(own, m_differences[static_cast<std::size_t>(j)].way);
        }
        products.diagonal().array() += solverSettings.mixing.regularization * products.diagonal().maxCoeff();
        const Eigen::VectorXd shares = products.ldlt().solve(right);
        if (shares.allFinite())
            for (Eigen::Index j = 0; j < count; ++j) {
                const Difference& one = m_differences[static_cast<std::size_t>(j)];
                addScaled(next, -shares[j], one.start);
                addScaled(next, -shares[j], one.way);
            }
    }
    m_start = start;
    m_way = std::move(way);
    m_hasLast = true;
}

} // namespace knead
