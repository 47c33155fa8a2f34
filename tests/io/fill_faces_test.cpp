#include "core/aggregate/fill.h"
#include "core/aggregate/spacing_choice.h"
#include "core/geometry/surface_distance.h"
#include "io/importer.h"

#include <QtTest>

#include <map>

using namespace knead;

/// Each object near the skin knows the CAD face it belongs to: on every bundled part, coarse and fine, through thin walls
/// and for every instance of an assembly.
class FillFacesTest : public QObject {
    Q_OBJECT

private slots:
    void objectsKnowTheirFace_data()
    {
        QTest::addColumn<QString>("path");
        const QDir folder(QString(KNEAD_RESOURCES) + "/examples");
        for (const QString& file : folder.entryList({"*.step", "*.stp", "*.iges", "*.brep"}, QDir::Files, QDir::Name))
            QTest::newRow(qPrintable(file)) << folder.filePath(file);
    }
    void objectsKnowTheirFace()
    {
        QFETCH(QString, path);
        const Model model = importFile(path.toStdString());
        for (const Part& part : model.parts)
            if (part.canBeFilled())
                for (const double cells : {0.8, 2.5})
                    checkFaces(part, cells);
    }

private:
    static void checkFaces(const Part& part, double cellsAcrossWall);
};

void FillFacesTest::checkFaces(const Part& part, double cellsAcrossWall)
{
    const FillingSize size = sizeWithWalls(part.mesh);
    const double wanted = spacingFor({SpacingChoice::Kind::CellsAcrossWall, cellsAcrossWall}, size);
    const double finest = spacingFor({SpacingChoice::Kind::Objects, 30'000}, size);
    const double spacing = std::max(wanted, finest);
    const Aggregate aggregate = fill(part.mesh, {.spacing = spacing});

    std::map<std::uint32_t, TriangleMesh> faces; // the triangles of one face each
    for (std::size_t t = 0; t < part.mesh.triangles.size(); ++t)
        faces[part.mesh.faceOfTriangle[t]].triangles.push_back(part.mesh.triangles[t]);
    std::map<std::uint32_t, SurfaceDistance> distances;
    for (auto& [face, mesh] : faces) {
        mesh.vertices = part.mesh.vertices;
        distances.emplace(face, mesh);
    }
    std::size_t known = 0;
    for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
        const double depth = aggregate.depth[i];
        if (depth > 1.9 * spacing)
            continue;
        const std::uint32_t face = aggregate.face[i];
        QVERIFY2(face < part.faces.size(), part.path.c_str());
        const double distance = distances.at(face).nearest(aggregate.lattice.position(i)).distance;
        QVERIFY2(std::abs(distance - std::abs(depth)) < 1e-9 * size.box.diagonal().norm(), part.path.c_str());
        ++known;
    }
    QVERIFY(known > 0);
}

QTEST_GUILESS_MAIN(FillFacesTest)
#include "fill_faces_test.moc"
