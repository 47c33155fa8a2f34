#include "core/aggregate/cell_mesh.h"
#include "core/aggregate/fill.h"
#include "support/shapes.h"

#include <QtTest>

#include <set>

using namespace knead;

namespace {

/// Volume of a hexahedron with flat faces.
double volumeOf(const CellMesh& mesh, const CellMesh::Cell& cell)
{
    const Vec3& first = mesh.nodes[cell[0]];
    return (mesh.nodes[cell[1]] - first).cross(mesh.nodes[cell[3]] - first).dot(mesh.nodes[cell[4]] - first);
}

const CellMesh::NodeSet& setNamed(const CellMesh& mesh, const std::string& name)
{
    return *std::ranges::find(mesh.sets, name, &CellMesh::NodeSet::name);
}

} // namespace

/// Fillings as meshes for finite elements.
class CellMeshTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const TriangleMesh box = shapes::moved(shapes::box(Vec3(8, 4, 2)), {Vec3(4, 2, 1), Quaternion::Identity()});
        m_filling = fill(box, {.spacing = 1});
        const FillingToMesh named{&m_filling, "PART"};
        m_mesh = cellMesh({&named, 1});
    }

    void cellsFillTheBox()
    {
        QCOMPARE(m_mesh.nodes.size(), std::size_t{9 * 5 * 3});
        QCOMPARE(m_mesh.cells.size(), std::size_t{8 * 4 * 2});
        for (const CellMesh::Cell& cell : m_mesh.cells) {
            QVERIFY(std::abs(volumeOf(m_mesh, cell) - 1) < 1e-12); // and none is inside out
            QCOMPARE((std::set<std::uint32_t>(cell.begin(), cell.end()).size()), std::size_t{8});
            for (std::size_t i = 0; i < 4; ++i) { // around the lower face, and above it
                QVERIFY(std::abs((m_mesh.nodes[cell[i]] - m_mesh.nodes[cell[(i + 1) % 4]]).norm() - 1) < 1e-12);
                QVERIFY(std::abs((m_mesh.nodes[cell[i]] - m_mesh.nodes[cell[i + 4]]).norm() - 1) < 1e-12);
            }
        }
        QCOMPARE(setNamed(m_mesh, "PART").nodes.size(), m_mesh.nodes.size());
    }

    void nodesOfAFaceLieOnIt()
    {
        Box low;
        for (const std::uint32_t node : setNamed(m_mesh, "PART_FACE_4").nodes) // z = 0
            low.extend(m_mesh.nodes[node]);
        QVERIFY(std::abs(low.max().z()) < 1e-12);
        QVERIFY(low.sizes().x() > 5 && low.sizes().y() > 1);
    }

    /// The six motions are told apart by what is held.
    void restHoldsEveryRigidMotion()
    {
        Eigen::Matrix<double, 6, 6> held = Eigen::Matrix<double, 6, 6>::Zero();
        Eigen::Index row = 0;
        for (const auto& [name, first] : {std::pair("REST_1", 0), std::pair("REST_2", 1), std::pair("REST_3", 2)}) {
            const Vec3& place = m_mesh.nodes[setNamed(m_mesh, name).nodes.at(0)];
            for (Eigen::Index axis = first; axis < 3; ++axis, ++row) {
                held(row, axis) = 1;
                for (Eigen::Index turn = 0; turn < 3; ++turn)
                    held(row, 3 + turn) = Vec3::Unit(turn).cross(place)[axis];
            }
        }
        QCOMPARE(row, Eigen::Index{6});
        QVERIFY(std::abs(held.determinant()) > 10);
    }

    void severalFillingsAreOneMesh()
    {
        const std::array two{FillingToMesh{&m_filling, "PART_1"}, FillingToMesh{&m_filling, "PART_2"}};
        const CellMesh mesh = cellMesh(two);
        QCOMPARE(mesh.cells.size(), 2 * m_mesh.cells.size());
        QCOMPARE(setNamed(mesh, "PART_2").nodes.front(), static_cast<std::uint32_t>(m_mesh.nodes.size()));
        QCOMPARE(cellMesh({}).nodes.size(), std::size_t{0});
    }

private:
    Aggregate m_filling;
    CellMesh m_mesh;
};

QTEST_APPLESS_MAIN(CellMeshTest)
#include "cell_mesh_test.moc"
