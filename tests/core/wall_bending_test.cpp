// Walls bend and twist as beam theory says at any number of cells across, whether the lattice divides them or not, along the
// lattice and across it. `./dev check deep` measures every twentieth of a cell instead of a few numbers of cells.
#include "support/bars.h"
#include "support/deep.h"
#include "support/thread_limit.h"
#include "support/turns.h"

#include "core/aggregate/cell_corners.h"
#include "core/aggregate/cut_cells.h"
#include "core/aggregate/moment_weights.h"
#include "core/geometry/mass_properties.h"
#include "core/simulation/simulation.h"

#include <QTest>

#include <algorithm>
#include <limits>

using namespace knead;

namespace {

using bars::about;
using bars::Bar;

constexpr double a = bars::spacing;

/// A few numbers of cells; where all is tried, all in steps of a twentieth from the first to `last`.
std::vector<double> numbersOfCells(const std::vector<double>& few, double last)
{
    if (!isDeep())
        return few;
    std::vector<double> all;
    for (auto i = static_cast<int>(std::lround(20 * few.front())); i <= static_cast<int>(std::lround(20 * last)); ++i)
        all.push_back(i / 20.0);
    return all;
}

/// A square bar at least sixteen cells long.
Bar squareBar(double cells, const Quaternion& turn)
{
    const double length = 8 * std::max(cells, 2.0) * a;
    const bars::SectionValues values = bars::valuesOf(bars::Section::Square, cells);
    return {bars::meshOf(bars::Section::Square, values.width, length), values, length, turn};
}

/// A closed square tube, eight walls wide, with walls of so many cells; Bredt's formula.
Bar boxBar(double cells, const Quaternion& turn)
{
    const double wall = cells * a;
    const double width = 8 * wall;
    const double inner = width - 2 * wall;
    const double length = 4 * width;
    const bars::SectionValues values{width, width * width - inner * inner,
                                     (std::pow(width, 4) - std::pow(inner, 4)) / 12, std::pow(width - wall, 3) * wall};
    return {shapes::hollowBox({length, width, width}, {length - 2 * wall, inner, inner}), values, length, turn};
}

struct Extremes {
    double least = std::numeric_limits<double>::max();
    double most = 0;

    void add(double value)
    {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    bool within(double low, double high) const { return least >= low && most <= high; }
};

/// Of a measure over numbers of cells.
template <typename Measure>
Extremes extremes(const char* what, const std::vector<double>& numbers, Measure measure)
{
    Extremes found;
    for (const double cells : numbers) {
        const double value = measure(cells);
        if (isDeep())
            qInfo("%s, %.2f cells: %.3f", what, cells, value);
        found.add(value);
    }
    qInfo("%s: %.3f .. %.3f", what, found.least, found.most);
    return found;
}

/// Second moments of the material of a box of given sides turned in space, about its middle, by its volume.
Mat3 squareOf(const Vec3& sides, const Quaternion& turn)
{
    const Mat3 axes = turn.toRotationMatrix();
    return axes * Vec3(sides.cwiseProduct(sides) / 12).asDiagonal() * axes.transpose();
}

Material rubberlike(double share, double poisson)
{
    return {.density = 1, .youngsModulus = 1e6, .poissonRatio = poisson, .dampingRatio = 0.1, .rubberlike = share};
}

Material yielding()
{
    Material material = rubberlike(0, 0.3);
    material.yieldStress = 1e5;
    return material;
}

/// Along x, of what is pulled there by grips at both ends and comes to balance.
double forceOf(const Aggregate& aggregate, const Material& material)
{
    Scene scene;
    scene.bodies.push_back(
        {.name = "strip", .aggregate = std::make_shared<const Aggregate>(aggregate), .material = material});
    scene.integrator = Integrator::implicitEuler;
    for (const double side : {-1.0, 1.0}) {
        std::vector<ObjectIndex> objects;
        for (ObjectIndex i = 0; i < aggregate.size(); ++i)
            if (side * aggregate.lattice.position(i).x() > 5)
                objects.push_back(i);
        scene.fixtures.push_back({"grip", 0, objects, Vec3(side * 0.05, 0, 0)});
    }
    Simulation simulation(scene);
    while (simulation.time() < 0.5)
        simulation.step();
    const auto shot = simulation.snapshot();
    return 0.5 * std::abs(shot->fixtureForces[1].x() - shot->fixtureForces[0].x());
}

} // namespace

class WallBendingTest : public QObject {
    Q_OBJECT

private slots:
    void cellsHaveTheMomentsOfTheirMaterial_data() { turns::addRows(); }
    void cellsHaveTheMomentsOfTheirMaterial()
    {
        // Over all cells, cut ones by their moments and full ones by their places, they are those of the box.
        QFETCH(Quaternion, turn);
        const Vec3 sides(5.3, 4.2, 9.7);
        const TriangleMesh mesh = shapes::moved(shapes::box(sides), {Vec3(0.3, -0.2, 0.7), turn});
        const CellGrid grid = gridAround(massProperties(mesh).box, 1);
        const CutCells cells = cutCells(mesh, grid, 1, 0.25, TaskControl::none());
        double volume = 0;
        Vec3 first = Vec3::Zero();
        Mat3 second = Mat3::Zero();
        const auto add = [&](const CellMoments& moments, std::size_t u, std::int32_t v, std::int32_t w) {
            const auto& m = moments.value;
            const Vec3 at(static_cast<double>(u) + 0.5, v + 0.5, w + 0.5);
            const Vec3 own(m[1], m[2], m[3]);
            Mat3 square;
            square << m[4], m[7], m[8], m[7], m[5], m[9], m[8], m[9], m[6];
            volume += m[0];
            first += m[0] * at + own;
            second += square + at * own.transpose() + own * at.transpose() + m[0] * at * at.transpose();
        };
        for (std::size_t u = 0; u < cells.slabs.size(); ++u) {
            const CutCells::Slab& slab = cells.slabs[u];
            for (const CutCells::Cut& cut : slab.cut)
                add(cut.moments, u, cut.v, cut.w);
            for (std::int32_t v = slab.firstRow; v < slab.rowsEnd(); ++v)
                for (std::size_t i = 0; i < slab.row(v).w.size(); ++i)
                    if (slab.row(v).fraction[i] >= 1 - 1e-9)
                        add(CellMoments::even(1), u, v, slab.row(v).w[i]);
        }
        QVERIFY(std::abs(volume / sides.prod() - 1) < 1e-12);
        const Vec3 middle = first / volume;
        QVERIFY((grid.frame.origin + grid.frame.axes * middle - Vec3(0.3, -0.2, 0.7)).norm() < 1e-11);
        const Mat3 expected = grid.frame.axes.transpose() * squareOf(sides, turn) * grid.frame.axes;
        QVERIFY((second / volume - middle * middle.transpose() - expected).norm() < 1e-10);
    }

    void connectionsOfEachFamilyHaveTheMomentsOfTheMaterial_data() { turns::addRows(); }
    void connectionsOfEachFamilyHaveTheMomentsOfTheMaterial()
    {
        // At their middles, but for what makes up for the lattice's own bending and warping: .032 a^2 less along each axis for
        // connections along axes, .04 a^2 more along their own axes for diagonal ones, as thick as this is. The rule for thick bodies
        // alone is .17 a^2 and more above the material's. So long that what its ends have, which are a lump's, counts little.
        QFETCH(Quaternion, turn);
        const Vec3 sides(28.6, 3.6, 5.45);
        const TriangleMesh mesh = shapes::moved(shapes::box(sides), {Vec3::Zero(), turn});
        const CellGrid grid = gridAround(massProperties(mesh).box, 1);
        const CutCells cut = cutCells(mesh, grid, 1, 0.25, TaskControl::none());
        const Aggregate aggregate =
            withFittedMoments(cut, joinCells(cut, grid, TaskControl::none()).aggregate, TaskControl::none());
        for (std::size_t d = 0; d < Lattice::isotropicCount; ++d) {
            const Lattice::Node& ahead = Lattice::directions[d];
            const Vec3 alongIt = Vec3(ahead[0], ahead[1], ahead[2]).cwiseAbs();
            const Vec3 beside = d < 3 ? Vec3::Constant(-0.032) : Vec3(0.04 * alongIt);
            const Mat3& axes = aggregate.lattice.axes;
            const Mat3 expected = squareOf(sides, turn) + axes * beside.asDiagonal() * axes.transpose();
            double sum = 0;
            Vec3 first = Vec3::Zero();
            Mat3 second = Mat3::Zero();
            for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
                const Vec3 x = aggregate.lattice.position(i) + 0.5 * aggregate.lattice.direction(static_cast<int>(d));
                sum += aggregate.weight[d][i];
                first += aggregate.weight[d][i] * x;
                second += aggregate.weight[d][i] * x * x.transpose();
            }
            const double error =
                (turn.inverse() * (second / sum - expected) * turn).diagonal().tail(2).cwiseAbs().maxCoeff();
            QVERIFY(std::abs(sum / sides.prod() - 1) < 1e-12);
            QVERIFY2((first / sum).norm() < 0.02, qPrintable(QString::number((first / sum).norm())));
            QVERIFY2(error < (d < 3 ? 0.04 : 0.02), qPrintable(QString::number(error)));
        }
    }

    void massesAreAnEighteenthOfTheConnectionsAndPositive()
    {
        // So no object is light against its springs, whatever the weights: time steps stay as long as in the bulk.
        const Aggregate aggregate =
            fill(shapes::moved(shapes::box({15, 1.9, 8}), {Vec3::Zero(), turns::inThreeAxes}), {.spacing = 1});
        std::vector<double> sum(aggregate.size(), 0);
        for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
            for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
                if (aggregate.weight[d][i] == 0)
                    continue;
                QVERIFY(aggregate.weight[d][i] > 0.008);
                Lattice::Node other = aggregate.lattice.nodes[i];
                for (std::size_t axis = 0; axis < 3; ++axis)
                    other[axis] += Lattice::directions[d][axis];
                sum[i] += aggregate.weight[d][i];
                sum[aggregate.lattice.find(other)] += aggregate.weight[d][i];
            }
        for (ObjectIndex i = 0; i < aggregate.size(); ++i)
            QVERIFY(aggregate.volume[i] > 0 && std::abs(18 * aggregate.volume[i] / sum[i] - 1) < 1e-12);
        const std::vector<double> borne = aggregate.borneVolume();
        for (ObjectIndex i = 0; i < aggregate.size(); ++i)
            QVERIFY(std::abs(borne[i] / aggregate.volume[i] - 1) < 1e-12);
    }

    void wallsOfOneCellBearWithAPartOfTheirMass_data() { turns::addRows(); }
    void wallsOfOneCellBearWithAPartOfTheirMass()
    {
        QFETCH(Quaternion, turn);
        for (const auto& [thickness, expected] :
             {std::pair(0.8, 0.83), {1.0, 0.83}, {1.375, 0.915}, {1.8, 1.0}, {2.4, 1.0}}) {
            const Aggregate plate =
                fill(shapes::moved(shapes::box({16, 16, thickness}), {Vec3::Zero(), turn}), {.spacing = 1});
            const std::vector<double> borne = plate.borneVolume();
            double all = 0;
            double inner = 0;
            double borneThere = 0;
            for (ObjectIndex i = 0; i < plate.size(); ++i) {
                all += plate.volume[i];
                if ((turn.inverse() * plate.lattice.position(i)).cwiseAbs().maxCoeff() > 4)
                    continue;
                inner += plate.volume[i];
                borneThere += borne[i];
            }
            QVERIFY(std::abs(all / plate.filledVolume - 1) < 1e-12); // masses are the material's
            const double share = borneThere / inner;
            QVERIFY2(std::abs(share - expected) < 0.01, qPrintable(QString("%1: %2").arg(thickness).arg(share)));
        }
    }

    void everyLawBearsWithThatPart_data()
    {
        QTest::addColumn<Material>("material");
        QTest::newRow("springs") << rubberlike(0, 0.25);
        QTest::newRow("springs and volume") << rubberlike(0, 0.4);
        QTest::newRow("yields") << yielding();
        QTest::newRow("rubber") << rubberlike(1, 0.4);
    }
    void everyLawBearsWithThatPart()
    {
        // Strips pulled along the lattice, by the force of the same ones whose volumes are told to be what they bear with.
        QFETCH(Material, material);
        const TriangleMesh strip = shapes::box({16, 5, 1});
        Aggregate aggregate = fill(strip, {.spacing = 1});
        const double told = forceOf(aggregate, material);
        const double expected = 0.83;
        aggregate.volume = aggregate.borneVolume();
        QVERIFY(std::abs(told / forceOf(aggregate, material) - 1) < 1e-3); // masses do not matter
        for (std::vector<double>& weights : aggregate.weight)
            for (double& weight : weights)
                weight /= expected;
        aggregate.volume = aggregate.borneVolume();
        const double share = told / forceOf(aggregate, material);
        QVERIFY2(std::abs(share - expected) < 0.005, qPrintable(QString::number(share)));
    }

    void anyNumberOfThreadsGivesTheSameBits()
    {
        const TriangleMesh mesh = shapes::moved(shapes::hollowBox({14, 11, 12}, {10.7, 8.1, 9}), shapes::tilt(0.6));
        const auto fillWith = [&](int threads) {
            return onThreads(threads, [&] { return fill(mesh, {.spacing = 1}); });
        };
        const Aggregate one = fillWith(1);
        for (const int threads : {2, 4}) {
            const Aggregate other = fillWith(threads);
            QVERIFY(one.weight == other.weight);
            QVERIFY(one.volume == other.volume);
        }
    }

    void thickBodiesWithSkinsOnNodesKeepTheirWeights()
    {
        // Uniform strain is exact with the weights of joinCells(), and five cells bend right to .04 with them.
        for (const double cells : {5.0, 7.0}) {
            const TriangleMesh mesh = shapes::box({12, cells, cells});
            const CellGrid grid = gridAround(massProperties(mesh).box, 1);
            const CutCells cut = cutCells(mesh, grid, 1, 0.25, TaskControl::none());
            const Aggregate even = joinCells(cut, grid, TaskControl::none()).aggregate;
            const Aggregate aggregate = fill(mesh, {.spacing = 1});
            QVERIFY(aggregate.weight == even.weight);
            QVERIFY(aggregate.volume == even.volume);
        }
    }

    void sheetsWithSkinsOnNodesAreFittedAlongThemAlone()
    {
        // What leads inwards keeps its weights, but near the sheet's rim; what lies along the skin weighs less there, more inside.
        const Aggregate aggregate = fill(shapes::box({24, 24, 3}), {.spacing = 1});
        for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
            for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
                const Vec3 x = aggregate.lattice.position(i);
                if (aggregate.weight[d][i] == 0 || std::max(std::abs(x.x()), std::abs(x.y())) > 7.5)
                    continue;
                const double share = aggregate.weight[d][i];
                const bool isAlong = std::abs(aggregate.lattice.direction(static_cast<int>(d)).z()) < 1e-12;
                if (!isAlong)
                    QVERIFY(std::abs(share - 1) < 1e-3);
                else
                    QVERIFY(std::abs(x.z()) > 1 ? share < 0.5 : share > 1);
            }
    }

    void wallsBendAsBeamTheorySays_data() { turns::addRows(); }
    void wallsBendAsBeamTheorySays()
    {
        QFETCH(Quaternion, turn);
        const Extremes found =
            extremes("bending", numbersOfCells({1.75, 2, 2.25, 2.6, 3, 3.3, 4, 4.45}, 6), [&](double cells) {
                Bar bar = squareBar(cells, turn);
                return bars::bending(bar);
            });
        QVERIFY(found.within(0.9, 1.1));
    }

    void wallsOfOneAndAThirdCellsStayUseful_data() { turns::addRows(); }
    void wallsOfOneAndAThirdCellsStayUseful()
    {
        QFETCH(Quaternion, turn);
        const Extremes found =
            extremes("bending of thin walls", numbersOfCells({1.3, 1.45, 1.65}, 1.75), [&](double cells) {
                Bar bar = squareBar(cells, turn);
                return bars::bending(bar);
            });
        QVERIFY(found.within(0.7, 1.3));
    }

    void wallsOfOneCellStayUseful_data() { turns::addRows(); }
    void wallsOfOneCellStayUseful()
    {
        QFETCH(Quaternion, turn);
        const Extremes found =
            extremes("bending of walls of one cell", numbersOfCells({1, 1.1}, 1.3), [&](double cells) {
                Bar bar = squareBar(cells, turn);
                return bars::bending(bar);
            });
        QVERIFY(found.within(0.7, 1.3));
    }

    void solidBarsTwistAsTheorySays_data() { turns::addRows(); }
    void solidBarsTwistAsTheorySays()
    {
        // Two cells have too few objects across for the warping of a square, which takes a sixth of its stiffness.
        QFETCH(Quaternion, turn);
        const auto twist = [&](double cells) {
            Bar bar = squareBar(cells, turn);
            return bars::torsion(bar);
        };
        QVERIFY(
            extremes("torsion of two cells", numbersOfCells({2, 2.05, 2.1, 2.3, 2.5}, 3), twist).within(0.95, 1.15));
        QVERIFY(extremes("torsion", numbersOfCells({3, 3.3, 4, 5}, 6), twist).within(0.95, 1.15));
    }

    void wallsAreAsStiffInTensionAsTheyAreThick_data() { turns::addRows(); }
    void wallsAreAsStiffInTensionAsTheyAreThick()
    {
        QFETCH(Quaternion, turn);
        const Extremes found = extremes("tension", numbersOfCells({2, 2.6, 3.3}, 6), [&](double cells) {
            Bar bar = squareBar(cells, turn);
            return bars::tension(bar).youngsModulus;
        });
        QVERIFY(found.within(0.94, 1.01));
    }

    void boxesBendAndTwistAsTheorySays_data()
    {
        QTest::addColumn<double>("cells");
        QTest::newRow("2 cells") << 2.0;
        QTest::newRow("2.3 cells") << 2.3;
    }
    void boxesBendAndTwistAsTheorySays()
    {
        QFETCH(double, cells);
        Bar bent = boxBar(cells, about(29, Vec3::UnitX()));
        const double bend = bars::bending(bent);
        Bar twisted = boxBar(cells, Quaternion::Identity());
        const double twist = bars::torsion(twisted);
        qInfo("bending %.3f, torsion %.3f", bend, twist);
        QVERIFY(std::abs(bend - 1) < 0.15);
        QVERIFY(std::abs(twist - 1) < 0.15);
    }
};

QTEST_GUILESS_MAIN(WallBendingTest)
#include "wall_bending_test.moc"
