#include "core/integration/rigid_mode_levels.h"

#include <QTest>

#include <cmath>
#include <memory>

using namespace knead;

namespace {

using Mat6 = RigidModeLevels::Mat6;
using Vec6 = RigidModeLevels::Vec6;

/// Clusters in a box, each held a little, and joined to its neighbors by springs at two points between them.
struct Chain {
    Chain(std::array<int, 3> counts, double mass, bool cut = false)
    {
        std::vector<RigidModeLevels::Cluster> clusters;
        for (int u = 0; u < counts[0]; ++u)
            for (int v = 0; v < counts[1]; ++v)
                for (int w = 0; w < counts[2]; ++w)
                    clusters.push_back({.center = Vec3(u, v, w), .size = 0.7, .block = {u, v, w}});
        levels = std::make_unique<RigidModeLevels>(clusters);
        const auto unknowns = static_cast<Eigen::Index>(6 * clusters.size());
        matrix = Eigen::MatrixXd::Zero(unknowns, unknowns);
        const auto add = [&](std::uint32_t row, std::uint32_t column, const Mat6& block) {
            matrix.block<6, 6>(6 * row, 6 * column) += block;
            if (row >= column)
                levels->block(row, column) += block;
        };
        for (std::uint32_t i = 0; i < clusters.size(); ++i) {
            add(i, i, mass * Mat6::Identity());
            for (std::uint32_t j = 0; j < i; ++j) {
                const Vec3 between = clusters[i].center - clusters[j].center;
                if (between.norm() > 1.1 || (cut && clusters[i].block[2] >= 4 && clusters[j].block[2] < 4))
                    continue;
                for (const double side : {-0.3, 0.3})
                    for (int axis = 0; axis < 3; ++axis) {
                        const Vec3 place = (clusters[i].center + clusters[j].center) / 2 +
                                           side * Vec3(between.y(), between.z(), between.x());
                        const Vec3 way = Vec3::Unit(axis);
                        Vec6 own;
                        Vec6 other;
                        own << way, ((place - clusters[i].center) / clusters[i].size).cross(way);
                        other << -way, -((place - clusters[j].center) / clusters[j].size).cross(way);
                        add(i, i, own * own.transpose());
                        add(j, j, other * other.transpose());
                        add(i, j, own * other.transpose());
                        add(j, i, other * own.transpose());
                    }
            }
        }
        levels->finish();
    }

    Eigen::VectorXd solve(const Eigen::VectorXd& load)
    {
        std::vector<float> loads(static_cast<std::size_t>(load.size() / 6 * 8), 0);
        std::vector<float> motions;
        for (Eigen::Index i = 0; i < load.size(); ++i)
            loads[static_cast<std::size_t>(8 * (i / 6) + i % 6)] = static_cast<float>(load[i]);
        levels->solve(loads, motions);
        Eigen::VectorXd motion(load.size());
        for (Eigen::Index i = 0; i < load.size(); ++i)
            motion[i] = static_cast<double>(motions[static_cast<std::size_t>(8 * (i / 6) + i % 6)]);
        return motion;
    }

    /// All of M, column by column.
    Eigen::MatrixXd inverse()
    {
        Eigen::MatrixXd all(matrix.rows(), matrix.cols());
        for (Eigen::Index i = 0; i < matrix.cols(); ++i)
            all.col(i) = solve(Eigen::VectorXd::Unit(matrix.cols(), i));
        return all;
    }

    std::unique_ptr<RigidModeLevels> levels;
    Eigen::MatrixXd matrix;
};

} // namespace

class RigidModeLevelsTest : public QObject {
    Q_OBJECT

private slots:
    void fewClustersAreSolvedExactly()
    {
        Chain chain({2, 3, 4}, 1e-3);
        QCOMPARE(chain.levels->levels(), std::size_t{1});
        const Eigen::MatrixXd product = chain.inverse() * chain.matrix;
        QVERIFY((product - Eigen::MatrixXd::Identity(product.rows(), product.cols())).norm() < 1e-3);
    }

    /// The spectrum of M A is narrow, whatever the size and the mass: 1 to 1.5, and that for each level, for what is solved for,
    /// and not far below for what is left.
    void cycleIsNearADirectSolve_data()
    {
        QTest::addColumn<int>("length");
        QTest::addColumn<double>("mass");
        for (const int length : {6, 12, 24})
            for (const double mass : {1.0, 1e-4})
                QTest::addRow("%d, %g", length, mass) << length << mass;
    }
    void cycleIsNearADirectSolve()
    {
        QFETCH(int, length);
        QFETCH(double, mass);
        Chain chain({3, 3, length}, mass);
        QVERIFY(chain.levels->levels() >= 2);
        const Eigen::MatrixXd inverse = chain.inverse();
        QVERIFY((inverse - inverse.transpose()).norm() < 1e-4 * inverse.norm());
        const Eigen::LLT<Eigen::MatrixXd> factor(chain.matrix);
        const Eigen::MatrixXd half = factor.matrixL();
        const Eigen::MatrixXd product = half.transpose() * inverse * half;
        const Eigen::VectorXd spectrum =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (product + product.transpose())).eigenvalues();
        QVERIFY2(spectrum.minCoeff() > 0.1, qPrintable(QString::number(spectrum.minCoeff())));
        const double most = std::pow(1.5, static_cast<double>(chain.levels->levels() - 1));
        QVERIFY2(spectrum.maxCoeff() < 1.05 * most, qPrintable(QString::number(spectrum.maxCoeff())));
    }

    /// As clusters of objects in a row have them: single precision must not make what else they do negative.
    void turnsThatDoNothingLeaveTheRestPositive()
    {
        constexpr int count = 64;
        std::vector<RigidModeLevels::Cluster> clusters;
        for (int i = 0; i < count; ++i)
            clusters.push_back({.center = Vec3(i, 0, 0), .size = 0.5, .block = {i, 0, 0}});
        RigidModeLevels levels(clusters);
        const Vec3 row = Vec3(1, 2, 3).normalized();
        for (std::uint32_t i = 0; i < count; ++i) {
            levels.block(i, i).topLeftCorner<3, 3>() = 2.1 * Mat3::Identity();
            levels.block(i, i).bottomRightCorner<3, 3>() = Mat3::Identity() - row * row.transpose();
            if (i > 0)
                levels.block(i, i - 1).topLeftCorner<3, 3>() = -Mat3::Identity();
        }
        levels.finish();
        QVERIFY(levels.levels() >= 2);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> value(-1, 1);
        for (int trial = 0; trial < 100; ++trial) {
            std::vector<float> load(8 * count, 0);
            for (std::size_t i = 0; i < count; ++i) {
                const Vec3 turn = row.cross(Vec3(value(random), value(random), value(random)));
                for (std::size_t c = 0; c < 3; ++c)
                    load[8 * i + 3 + c] = static_cast<float>(turn[static_cast<Eigen::Index>(c)]);
            }
            std::vector<float> motion;
            levels.solve(load, motion);
            double work = 0;
            double size = 0;
            for (std::size_t i = 0; i < load.size(); ++i) {
                work += static_cast<double>(load[i]) * static_cast<double>(motion[i]);
                size += static_cast<double>(load[i]) * static_cast<double>(load[i]);
            }
            QVERIFY2(work > 0.9 * size, qPrintable(QString::number(work / size)));
        }
    }

    void partsThatHangApartMoveApart()
    {
        Chain chain({3, 3, 8}, 1e-4, true);
        QVERIFY(chain.levels->levels() >= 2);
        Eigen::VectorXd load = Eigen::VectorXd::Zero(chain.matrix.rows());
        for (Eigen::Index cluster = 0; cluster < load.size() / 6; ++cluster)
            if (cluster % 8 < 4)
                load[6 * cluster] = 1;
        const Eigen::VectorXd motion = chain.solve(load);
        const double expected = motion[0]; // all of it, as one
        QVERIFY(expected > 0.98 / 1e-4 && expected < 1.02 * 1.5 / 1e-4);
        for (Eigen::Index cluster = 0; cluster < load.size() / 6; ++cluster)
            QVERIFY(std::abs(motion[6 * cluster] / expected - (cluster % 8 < 4 ? 1 : 0)) < 0.02);
    }
};

QTEST_GUILESS_MAIN(RigidModeLevelsTest)
#include "rigid_mode_levels_test.moc"
