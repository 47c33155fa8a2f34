#include "core/geometry/rigid_fit.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace knead {

namespace {

Vec3 meanOf(std::span<const Vec3> points)
{
    return std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero())) / static_cast<double>(points.size());
}

} // namespace

/// The best turn is that of Kabsch (1976): U V^T of the singular value decomposition of sum y x^T, a mirror image avoided.
RigidFit fitRigidMotion(std::span<const Vec3> before, std::span<const Vec3> after)
{
    assert(before.size() == after.size());
    if (before.empty())
        return {};
    const Vec3 from = meanOf(before);
    const Vec3 to = meanOf(after);
    Mat3 covariance = Mat3::Zero();
    for (std::size_t i = 0; i < before.size(); ++i)
        covariance += (after[i] - to) * (before[i] - from).transpose();
    const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 u = svd.matrixU();
    if ((u * svd.matrixV().transpose()).determinant() < 0)
        u.col(2) = -u.col(2);
    const Mat3 turn = u * svd.matrixV().transpose();
    double most = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
        most = std::max(most, (after[i] - to - turn * (before[i] - from)).squaredNorm());
    return {turn, from, to, std::sqrt(most)};
}

} // namespace knead
