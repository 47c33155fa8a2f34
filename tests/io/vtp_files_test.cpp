// What VTK's own reader finds in a VTP file.
#include "io/formats/mesh_writer.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

using namespace knead;

namespace {

constexpr Color red{0.8F, 0.2F, 0.0F};
constexpr Color blue{0.0F, 0.4F, 1.0F};

/// A ring with a displacement and a stress, and a box with a displacement only and one red face.
std::vector<MeshBody> twoBodies()
{
    MeshBody ring{"歯車 \"1\"", red, shapes::torus(0.03, 0.01, 40, 24)};
    ring.mesh.faceOfTriangle.clear();
    MeshBody box{"Block & Co", blue, shapes::box(Vec3(0.01, 0.02, 0.03))};
    box.faceColors = {red, {}, {}, {}, {}, {}};
    for (MeshBody* body : {&ring, &box}) {
        MeshField displacement{"displacement [m]", 3, {}};
        for (const Vec3& vertex : body->mesh.vertices)
            for (const double coordinate : vertex)
                displacement.values.push_back(static_cast<float>(2 * coordinate));
        body->fields.push_back(displacement);
    }
    MeshField stress{"von Mises <stress> [Pa]", 1, {}};
    for (std::size_t i = 0; i < ring.mesh.vertices.size(); ++i)
        stress.values.push_back(1e6F + static_cast<float>(i));
    ring.fields.push_back(stress);
    return {ring, box};
}

} // namespace

class VtpFilesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void geometryIsAll();
    void fieldsBelongToTheirVertices();
    void partsFacesAndColorsAreOnTriangles();
    void namesAndUnitAreSaid();

private:
    std::string path() const { return m_folder.path().toStdString() + "/two.vtp"; }
    vtkPolyData& surface() { return *m_reader->GetOutput(); }

    QTemporaryDir m_folder;
    std::vector<MeshBody> m_bodies = twoBodies();
    vtkNew<vtkXMLPolyDataReader> m_reader;
};

void VtpFilesTest::initTestCase()
{
    writeMeshes(path(), m_bodies, {.unit = "cm"});
    QVERIFY(m_reader->CanReadFile(path().c_str()));
    m_reader->SetFileName(path().c_str());
    m_reader->Update();
    QCOMPARE(m_reader->GetErrorCode(), 0UL);
}

void VtpFilesTest::geometryIsAll()
{
    vtkIdType point = 0;
    vtkIdType cell = 0;
    for (const MeshBody& body : m_bodies) {
        const vtkIdType first = point;
        for (const Vec3& vertex : body.mesh.vertices) {
            const Vec3 read(surface().GetPoint(point++));
            QVERIFY((read - 100 * vertex).norm() < 1e-6 * 100 * vertex.norm());
        }
        for (const TriangleMesh::Triangle& triangle : body.mesh.triangles) {
            vtkIdList& corners = *surface().GetCell(cell++)->GetPointIds();
            QCOMPARE(corners.GetNumberOfIds(), vtkIdType(3));
            for (vtkIdType i = 0; i < 3; ++i)
                QCOMPARE(corners.GetId(i), first + triangle[static_cast<std::size_t>(i)]);
        }
    }
    QCOMPARE(surface().GetNumberOfPoints(), point);
    QCOMPARE(surface().GetNumberOfCells(), cell);
}

void VtpFilesTest::fieldsBelongToTheirVertices()
{
    vtkDataArray* displacement = surface().GetPointData()->GetArray("displacement [m]");
    vtkDataArray* stress = surface().GetPointData()->GetArray("von Mises <stress> [Pa]");
    vtkDataArray* part = surface().GetPointData()->GetArray("part");
    QVERIFY(displacement != nullptr && stress != nullptr && part != nullptr);
    QCOMPARE(displacement->GetNumberOfComponents(), 3);
    vtkIdType point = 0;
    for (std::size_t i = 0; i < m_bodies.size(); ++i)
        for (std::size_t v = 0; v < m_bodies[i].mesh.vertices.size(); ++v, ++point) {
            QCOMPARE(part->GetTuple1(point), static_cast<double>(i));
            for (int axis = 0; axis < 3; ++axis)
                QCOMPARE(static_cast<float>(displacement->GetComponent(point, axis)),
                         m_bodies[i].fields[0].values[3 * v + static_cast<std::size_t>(axis)]);
            if (i == 0)
                QCOMPARE(static_cast<float>(stress->GetTuple1(point)), m_bodies[i].fields[1].values[v]);
            else
                QVERIFY(std::isnan(stress->GetTuple1(point)));
        }
}

void VtpFilesTest::partsFacesAndColorsAreOnTriangles()
{
    vtkDataArray* part = surface().GetCellData()->GetArray("part");
    vtkDataArray* face = surface().GetCellData()->GetArray("face");
    vtkDataArray* color = surface().GetCellData()->GetArray("color");
    QVERIFY(part != nullptr && face != nullptr && color != nullptr);
    const auto ringTriangles = static_cast<vtkIdType>(m_bodies[0].mesh.triangles.size());
    for (vtkIdType cell = 0; cell < surface().GetNumberOfCells(); ++cell) {
        const bool isBox = cell >= ringTriangles;
        QCOMPARE(part->GetTuple1(cell), isBox ? 1.0 : 0.0);
        QCOMPARE(face->GetTuple1(cell), isBox ? std::floor(static_cast<double>(cell - ringTriangles) / 2) : -1.0);
        const bool isRed = cell < ringTriangles + 2; // all of the ring, and the first face of the box
        QCOMPARE(color->GetComponent(cell, 0), isRed ? 204.0 : 0.0);
        QCOMPARE(color->GetComponent(cell, 2), isRed ? 0.0 : 255.0);
    }
}

void VtpFilesTest::namesAndUnitAreSaid()
{
    const auto texts = [&](const char* name) {
        std::vector<std::string> result;
        auto* array = vtkStringArray::SafeDownCast(surface().GetFieldData()->GetAbstractArray(name));
        for (vtkIdType i = 0; array != nullptr && i < array->GetNumberOfValues(); ++i)
            result.push_back(array->GetValue(i));
        return result;
    };
    QCOMPARE(texts("part names"), (std::vector<std::string>{m_bodies[0].name, m_bodies[1].name}));
    QCOMPARE(texts("length unit"), std::vector<std::string>{"cm"});
}

QTEST_GUILESS_MAIN(VtpFilesTest)
#include "vtp_files_test.moc"
