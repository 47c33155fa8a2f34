#include "core/mechanics/connection_surroundings.h"

namespace knead {

DeformationGradients::DeformationGradients(const ConnectionData& data, const VectorArray& position,
                                           LaneVector<double>& theta)
{
    for (auto& component : m_components)
        component.assign(position.size(), 0);
    const auto components = pointersTo<double*>(m_components);
    forEachSurroundings(data, position, [&](const kernels::Surroundings& at) {
        kernels::best().deformation(at, theta.data(), components.data());
    });
}

Mat3 DeformationGradients::of(std::size_t object) const
{
    Mat3 f;
    for (std::size_t n = 0; n < 9; ++n)
        f(static_cast<Eigen::Index>(n % 3), static_cast<Eigen::Index>(n / 3)) = m_components[n][object];
    return f;
}

} // namespace knead
