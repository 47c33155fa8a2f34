#include "core/geometry/mass_properties.h"
#include "io/formats/mesh_writer.h"
#include "io/importer.h"
#include "support/shapes.h"

#include <QtTest>

#include <filesystem>

using namespace knead;

namespace {

constexpr Color red{0.8F, 0.2F, 0.0F};
constexpr Color blue{0.0F, 0.4F, 1.0F};

/// A tilted torus away from the origin: no coordinate is a round number.
TriangleMesh torus()
{
    return shapes::moved(shapes::torus(0.03, 0.01, 40, 24), shapes::tilt(0.7, Vec3(0.2, -0.1, 0.05)));
}

std::vector<MeshBody> twoBodies()
{
    return {{"Left ring", red, torus()}, {"Block", blue, shapes::box(Vec3(0.01, 0.02, 0.03))}};
}

} // namespace

class MeshFilesTest : public QObject {
    Q_OBJECT

private slots:
    void everyFormatComesBackTheSame_data();
    void everyFormatComesBackTheSame();
    void objKeepsBodiesNamesAndColors();
    void objBodiesOfOneNameStayApart();
    void plyKeepsTheColorOfOneBody();
    void stlIsBinaryWithOutwardNormals();
    void insideOutMeshIsTurned();
    void openMeshCannotBeFilled();
    void unknownEndingIsRefused();
    void nothingToWriteIsRefused();
    void unwritableTargetLeavesNothingBehind();
    void existingFileIsReplaced();

private:
    std::string path(const std::string& name) const { return m_folder.path().toStdString() + "/" + name; }
    int filesInFolder() const
    {
        return static_cast<int>(QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden).size());
    }

    QTemporaryDir m_folder;
};

void MeshFilesTest::everyFormatComesBackTheSame_data()
{
    QTest::addColumn<QString>("ending");
    QTest::addColumn<bool>("isText");
    QTest::addColumn<QString>("unit"); // that the file states
    QTest::newRow("STL") << "stl" << false << "";
    QTest::newRow("STL as text") << "stl" << true << "";
    QTest::newRow("OBJ") << "obj" << false << "";
    QTest::newRow("PLY") << "ply" << false << "";
    QTest::newRow("PLY as text") << "ply" << true << "";
    QTest::newRow("glTF") << "gltf" << false << "m";
    QTest::newRow("GLB") << "glb" << false << "m";
    QTest::newRow("3MF") << "3mf" << false << "mm";
}

void MeshFilesTest::everyFormatComesBackTheSame()
{
    QFETCH(QString, ending);
    QFETCH(bool, isText);
    QFETCH(QString, unit);
    const std::string file = path("ring." + ending.toStdString());
    const TriangleMesh written = torus();
    writeMeshes(file, {{"ring", red, written}}, {.isText = isText});

    const Model model = importFile(file);
    QCOMPARE(model.parts.size(), std::size_t(1));
    QCOMPARE(model.unit, unit.toStdString());
    QCOMPARE(model.warnings.empty(), !unit.isEmpty()); // it says when the file states none
    const Part& part = model.parts.front();
    QVERIFY(part.watertight && part.valid && part.canBeFilled());
    QCOMPARE(part.mesh.vertices.size(), written.vertices.size());
    QCOMPARE(part.mesh.triangles.size(), written.triangles.size());
    const MassProperties before = massProperties(written);
    const MassProperties after = massProperties(part.mesh);
    QVERIFY(std::abs(after.volume / before.volume - 1) < 1e-5);
    QVERIFY((after.box.min() - before.box.min()).norm() < 1e-7);
    QVERIFY((after.box.max() - before.box.max()).norm() < 1e-7);
    QVERIFY(std::abs(part.volume / before.volume - 1) < 1e-5);
}

void MeshFilesTest::objKeepsBodiesNamesAndColors()
{
    writeMeshes(path("two.obj"), twoBodies());
    QVERIFY(std::filesystem::exists(path("two.mtl")));
    const Model model = importFile(path("two.obj"));
    QCOMPARE(model.parts.size(), std::size_t(2));
    QCOMPARE(model.parts[0].name, std::string("Left_ring"));
    QCOMPARE(model.parts[1].name, std::string("Block"));
    QVERIFY(model.parts[0].color == red);
    QVERIFY(model.parts[1].color == blue);
    QVERIFY(model.parts[0].watertight && model.parts[1].watertight);
}

void MeshFilesTest::objBodiesOfOneNameStayApart()
{
    const TriangleMesh box = shapes::box(Vec3(0.01, 0.01, 0.01));
    writeMeshes(path("nuts.obj"), {{"nut", red, box}, {"nut", red, shapes::moved(box, {Vec3(0.05, 0, 0)})}});
    QCOMPARE(importFile(path("nuts.obj")).parts.size(), std::size_t(2));
}

void MeshFilesTest::plyKeepsTheColorOfOneBody()
{
    writeMeshes(path("one.ply"), {{"one", red, torus()}});
    const Color color = importFile(path("one.ply")).parts.front().color.value();
    QVERIFY(std::abs(color.r - red.r) < 0.003F && std::abs(color.g - red.g) < 0.003F &&
            std::abs(color.b - red.b) < 0.003F);
}

void MeshFilesTest::stlIsBinaryWithOutwardNormals()
{
    writeMeshes(path("box.stl"), {{"box", red, shapes::box(Vec3(0.01, 0.02, 0.03))}});
    QFile file(QString::fromStdString(path("box.stl")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    QCOMPARE(bytes.size(), 84 + 12 * 50);
    for (int t = 0; t < 12; ++t) {
        float numbers[12];
        std::memcpy(numbers, bytes.data() + 84 + 50 * t, sizeof numbers);
        const Eigen::Vector3f normal(numbers[0], numbers[1], numbers[2]);
        const Eigen::Vector3f corner(numbers[3], numbers[4], numbers[5]);
        QVERIFY(std::abs(normal.norm() - 1) < 1e-6F);
        QVERIFY(normal.dot(corner) > 4.9F); // the box is centered, half its sides are 5, 10 and 15 mm
    }
}

void MeshFilesTest::insideOutMeshIsTurned()
{
    writeMeshes(path("inverted.stl"), {{"inverted", red, shapes::insideOut(torus())}});
    const Part part = importFile(path("inverted.stl")).parts.front();
    QVERIFY(part.watertight);
    QVERIFY(massProperties(part.mesh).volume > 0);
    QCOMPARE(part.repairs.size(), std::size_t(1));

    const Part asItIs = importFile(path("inverted.stl"), {.heal = false}).parts.front();
    QVERIFY(asItIs.watertight && asItIs.repairs.empty());
    QVERIFY(massProperties(asItIs.mesh).volume > 0);
    QCOMPARE(asItIs.warnings.size(), std::size_t(1));
}

void MeshFilesTest::openMeshCannotBeFilled()
{
    TriangleMesh open = torus();
    open.triangles.pop_back();
    writeMeshes(path("open.stl"), {{"open", red, open}});
    const Part part = importFile(path("open.stl"), {.heal = false}).parts.front();
    QVERIFY(!part.watertight && !part.valid && !part.canBeFilled());
    QCOMPARE(part.volume, 0.0);
    QVERIFY(!part.warnings.empty());
    QCOMPARE(part.openEdges.size(), std::size_t(1));
    QCOMPARE(part.openEdges.front().size(), std::size_t(4)); // three corners, and back to the first
    QVERIFY(importFile(path("open.stl")).parts.front().canBeFilled());
}

void MeshFilesTest::unknownEndingIsRefused()
{
    QVERIFY_EXCEPTION_THROWN(writeMeshes(path("ring.xyz"), {{"ring", red, torus()}}), std::runtime_error);
}

void MeshFilesTest::nothingToWriteIsRefused()
{
    QVERIFY_EXCEPTION_THROWN(writeMeshes(path("nothing.stl"), {}), std::runtime_error);
    QVERIFY(!std::filesystem::exists(path("nothing.stl")));
}

void MeshFilesTest::unwritableTargetLeavesNothingBehind()
{
    QVERIFY_EXCEPTION_THROWN(writeMeshes(path("missing/ring.stl"), {{"ring", red, torus()}}), std::runtime_error);
    std::filesystem::create_directory(path("folder.stl"));
    const int before = filesInFolder();
    QVERIFY_EXCEPTION_THROWN(writeMeshes(path("folder.stl"), {{"ring", red, torus()}}), std::runtime_error);
    QCOMPARE(filesInFolder(), before);
}

void MeshFilesTest::existingFileIsReplaced()
{
    writeMeshes(path("same.stl"), {{"ring", red, torus()}});
    writeMeshes(path("same.stl"), {{"box", red, shapes::box(Vec3(0.01, 0.01, 0.01))}});
    QCOMPARE(importFile(path("same.stl")).parts.front().mesh.triangles.size(), std::size_t(12));
}

QTEST_GUILESS_MAIN(MeshFilesTest)
#include "mesh_files_test.moc"
