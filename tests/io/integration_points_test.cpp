#include "io/fields/integration_points.h"

#include <QtTest>

using namespace knead;

namespace {

/// One cell of a box of 2 x 3 x 5 m, or of its corner: its first nodes, in the order of VTK.
NodalMesh oneCell(std::uint8_t type, std::uint8_t points)
{
    const std::vector<Vec3> brick = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0},
                                     {0, 0, 5}, {2, 0, 5}, {2, 3, 5}, {0, 3, 5}};
    const std::vector<Vec3> corner = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 5}};
    NodalMesh mesh;
    mesh.nodes = type == 12 ? brick : corner;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        mesh.cells.connectivity.push_back(static_cast<std::int64_t>(n));
    mesh.cells.endCell(type);
    mesh.cells.points = {points};
    return mesh;
}

struct Told {
    std::size_t point = 0; ///< counted from 1
    Vec3 place;
};

} // namespace

/// Where CalculiX 2.20 says that its integration points are (*EL PRINT, COORD), to the digits that it prints.
class IntegrationPointsTest : public QObject {
    Q_OBJECT

private slots:
    void pointsLieWhereCalculixHasThem_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<int>("points");
        QTest::addColumn<QList<Told>>("told");
        QTest::newRow("27 of a brick") << 12 << 27 << QList<Told>{{1, {0.2254033, 0.3381050, 0.5635083}},
                                                                  {2, {1.0, 0.3381050, 0.5635083}},
                                                                  {4, {0.2254033, 1.5, 0.5635083}},
                                                                  {10, {0.2254033, 0.3381050, 2.5}},
                                                                  {18, {1.774597, 2.661895, 2.5}},
                                                                  {27, {1.774597, 2.661895, 4.436492}}};
        QTest::newRow("8 of a brick") << 12 << 8
                                      << QList<Told>{{1, {0.4226497, 0.6339746, 1.056624}},
                                                     {2, {1.577350, 0.6339746, 1.056624}},
                                                     {3, {0.4226497, 2.366025, 1.056624}},
                                                     {5, {0.4226497, 0.6339746, 3.943376}},
                                                     {8, {1.577350, 2.366025, 3.943376}}};
        QTest::newRow("1 of a brick") << 12 << 1 << QList<Told>{{1, {1, 1.5, 2.5}}};
        QTest::newRow("4 of a tetrahedron") << 10 << 4
                                            << QList<Told>{{1, {0.2763932, 0.4145898, 0.6909830}},
                                                           {2, {1.170820, 0.4145898, 0.6909830}},
                                                           {3, {0.2763932, 1.756231, 0.6909830}},
                                                           {4, {0.2763932, 0.4145898, 2.927051}}};
    }

    void pointsLieWhereCalculixHasThem()
    {
        QFETCH(int, type);
        QFETCH(int, points);
        QFETCH(QList<Told>, told);
        const NodalMesh mesh = oneCell(static_cast<std::uint8_t>(type), static_cast<std::uint8_t>(points));
        QVERIFY(isSolidCell(mesh, 0));
        const std::vector<Vec3> places = integrationPlaces(mesh, 0);
        QCOMPARE(places.size(), static_cast<std::size_t>(points));
        for (const Told& one : told)
            QVERIFY2((places[one.point - 1] - one.place).norm() < 2e-6, qPrintable(QString::number(one.point)));
    }

    void whatIsNoSolidHasNone()
    {
        NodalMesh mesh = oneCell(10, 0);
        mesh.cells.types = {5}; // a triangle
        QVERIFY(!isSolidCell(mesh, 0));
        QVERIFY(integrationPlaces(mesh, 0).empty());
    }
};

QTEST_APPLESS_MAIN(IntegrationPointsTest)
#include "integration_points_test.moc"
