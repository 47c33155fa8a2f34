// What cells tell of the material around them: how much of it is a wall, how thick, and which way a bar goes.
#include "support/shapes.h"
#include "support/turns.h"

#include "core/aggregate/cell_finder.h"
#include "core/aggregate/cut_cells.h"
#include "core/aggregate/fill.h"
#include "core/aggregate/local_shape.h"
#include "core/aggregate/wall_measure.h"
#include "core/geometry/mass_properties.h"

#include <QTest>

#include <algorithm>
#include <numeric>
#include <tuple>

using namespace knead;

class WallShapeTest : public QObject {
    Q_OBJECT

private slots:
    void shapesOfBarsAndPlatesAreFound_data() { turns::addRows(); }
    void shapesOfBarsAndPlatesAreFound()
    {
        // Wherever the lattice lies in them: how thick they are, and which way a bar goes.
        QFETCH(Quaternion, turn);
        const auto shapeIn = [&](const Vec3& sides) {
            const TriangleMesh mesh = shapes::moved(shapes::box(sides), {Vec3(0.3, -0.2, 0.7), turn});
            const CellGrid grid = gridAround(massProperties(mesh).box, 1);
            const CutCells cells = cutCells(mesh, grid, 1, 0.25, TaskControl::none());
            const CellFinder finder(cells);
            const LocalShape shape = localShapeAt(finder, grid.frame.coordinates(Vec3(0.3, -0.2, 0.7)));
            const auto along = [&, frame = grid.frame](const Vec3& direction) {
                return shape.along(frame.axes.transpose() * (turn * direction));
            };
            return std::tuple(shape.thickness(), along(Vec3::UnitX()), along(Vec3::UnitY()), along(Vec3::UnitZ()));
        };
        for (const double cells : {0.7, 1.0, 1.3, 1.75, 2.05, 2.6}) {
            const auto [bar, ahead, sideways, upwards] = shapeIn({20, cells, cells});
            QVERIFY2(std::abs(bar / cells - 1) < 0.05, qPrintable(QString("%1: %2").arg(cells).arg(bar)));
            QVERIFY(ahead > 0.75 && std::max(sideways, upwards) < 0.13);
            const auto [plate, length, width, height] = shapeIn({20, 20, cells});
            QVERIFY2(std::abs(plate / cells - 1) < 0.05, qPrintable(QString("%1: %2").arg(cells).arg(plate)));
            QVERIFY(std::abs(length - 0.5) < 0.06 && std::abs(width - 0.5) < 0.06 && height < 0.12);
        }
        const auto [lump, u, v, w] = shapeIn({20, 20, 20});
        QVERIFY(lump > 4 && std::max({u, v, w}) < 0.36);
    }

    void cellsAreFoundByTheirPlace()
    {
        // A box with a hollow: rows have gaps.
        const TriangleMesh mesh = shapes::moved(shapes::hollowBox({9, 9, 9}, {4.2, 4.2, 4.2}), shapes::tilt(0.6));
        const CellGrid grid = gridAround(massProperties(mesh).box, 1);
        const CutCells cells = cutCells(mesh, grid, 1, 0.25, TaskControl::none());
        const CellFinder finder(cells);
        double kept = 0;
        std::size_t cut = 0;
        for (std::int32_t u = -1; u <= grid.count[0]; ++u)
            for (std::int32_t v = -1; v <= grid.count[1]; ++v)
                for (std::int32_t w = -1; w <= grid.count[2]; ++w) {
                    const Lattice::Node cell{u, v, w};
                    QCOMPARE(finder.isFull(cell), finder.fraction(cell) >= CellFinder::full);
                    kept += finder.fraction(cell);
                    cut += finder.isCut(cell) ? 1 : 0;
                }
        QVERIFY(std::abs(kept / cells.keptVolume() - 1) < 1e-12);
        const auto cutIn = [](std::size_t sum, const CutCells::Slab& slab) { return sum + slab.cut.size(); };
        QCOMPARE(cut, std::accumulate(cells.slabs.begin(), cells.slabs.end(), std::size_t{0}, cutIn));
        const Vec3 middle = grid.frame.axes.transpose() * (Vec3::Zero() - grid.frame.origin);
        const Lattice::Node hollow{static_cast<std::int32_t>(middle[0]), static_cast<std::int32_t>(middle[1]),
                                   static_cast<std::int32_t>(middle[2])};
        QCOMPARE(finder.fraction(hollow), 0.0);
        QVERIFY(!finder.isCut(hollow));
    }

    /// Bars that get longer, from a cube on: their sides pass over to those of walls by and by, at any angle.
    void lumpsPassOverToWallsByAndBy_data() { turns::addRows(); }
    void lumpsPassOverToWallsByAndBy()
    {
        QFETCH(Quaternion, turn);
        double before = 0;
        for (double length = 4.6; length < 16; length += 0.4) {
            const TriangleMesh mesh = shapes::moved(shapes::box({4.6, 4.6, length}), {Vec3::Zero(), turn});
            const CellGrid grid = gridAround(massProperties(mesh).box, 1);
            const CutCells cells = cutCells(mesh, grid, 1, 0.25, TaskControl::none());
            const CellFinder finder(cells);
            const WallMeasure measure(finder);
            double share = 0; // of those in its middle
            double count = 0;
            for (std::size_t u = 0; u < cells.slabs.size(); ++u)
                for (const CutCells::Cut& cut : cells.slabs[u].cut) {
                    const Lattice::Node cell{static_cast<std::int32_t>(u), cut.v, cut.w};
                    const Vec3 middle =
                        grid.frame.axes * Vec3(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5) + grid.frame.origin;
                    if (std::abs((turn.inverse() * middle).z()) > 1.5)
                        continue;
                    const double one = measure.share(cell);
                    QVERIFY(one >= 0 && one <= 1);
                    share += one;
                    ++count;
                }
            share /= count;
            if (length < 5.5)
                QVERIFY2(share < 0.05, qPrintable(QString("%1: %2").arg(length).arg(share)));
            QVERIFY2(length < 5 || share - before < 0.5,
                     qPrintable(QString("%1: %2, %3").arg(length).arg(before).arg(share)));
            before = share;
        }
        QVERIFY2(before > 0.95, qPrintable(QString::number(before)));
    }
};

QTEST_GUILESS_MAIN(WallShapeTest)
#include "wall_shape_test.moc"
