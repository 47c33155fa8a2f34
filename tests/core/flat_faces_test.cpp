#include "core/geometry/flat_faces.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>
#include <map>
#include <set>

using namespace knead;

namespace {

/// A picture frame: a square ring of square section, with many triangles in each plane.
TriangleMesh frame()
{
    TriangleMesh mesh = shapes::closedGrid(4, 4, [](double a, double b) {
        const double r = 4 + std::sqrt(2.0) * std::cos(b + std::numbers::pi / 4);
        return Vec3(r * std::cos(a), r * std::sin(a), std::sqrt(2.0) * std::sin(b + std::numbers::pi / 4));
    });
    mesh.faceOfTriangle.clear();
    return refine(mesh, 0.7);
}

/// Twice the area inside of the loops of a face.
double doubleAreaOf(const FlatFace& face, const TriangleMesh& mesh)
{
    Vec3 sum = Vec3::Zero();
    for (const auto& loop : face.loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
            sum += (mesh.vertices[loop[i]] - face.point).cross(mesh.vertices[loop[(i + 1) % loop.size()]] - face.point);
    return sum.dot(face.normal);
}

double volumeOf(const std::vector<FlatFace>& faces, const TriangleMesh& mesh)
{
    double volume = 0;
    for (const FlatFace& face : faces)
        volume += doubleAreaOf(face, mesh) * face.normal.dot(face.point) / 6;
    return volume;
}

/// What flat faces owe, whatever they are made of. Empty when it is all there.
std::string complaint(const std::vector<FlatFace>& faces, const TriangleMesh& mesh, double tolerance)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const FlatFace& face : faces) {
        std::set<std::uint32_t> seen;
        for (const auto& loop : face.loops) {
            if (loop.size() < 3)
                return "a loop has less than three corners";
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const std::uint32_t to = loop[(i + 1) % loop.size()];
                if (!seen.insert(loop[i]).second)
                    return "a border meets itself";
                if (std::abs(face.normal.dot(mesh.vertices[loop[i]] - face.point)) > 2 * tolerance + 1e-12)
                    return "a corner is off its plane";
                edges[std::minmax(loop[i], to)] += loop[i] < to ? 1 : -1;
            }
        }
    }
    for (const auto& [edge, sum] : edges)
        if (sum != 0)
            return "faces do not fit together";
    const double whole = massProperties(mesh).volume;
    return std::abs(volumeOf(faces, mesh) / whole - 1) > 1e-6 ? "the volume is another one" : "";
}

std::size_t edgeCount(const std::vector<FlatFace>& faces)
{
    std::size_t sides = 0;
    for (const FlatFace& face : faces)
        for (const auto& loop : face.loops)
            sides += loop.size();
    return sides / 2;
}

} // namespace

class FlatFacesTest : public QObject {
    Q_OBJECT

private slots:
    void refinedBoxIsABoxAgain();
    void holesAreLoops();
    void curvedSurfacesKeepTheirTriangles();
    void noToleranceKeepsTriangles();
    void cadFacesStayApart();
    void bordersThatWouldMeetThemselvesComeApart();
    void roughnessBelowTheToleranceIsFlat();
};

void FlatFacesTest::refinedBoxIsABoxAgain()
{
    const TriangleMesh box = refine(shapes::moved(shapes::box({5, 3, 2}), shapes::tilt(0.6)), 0.3);
    const std::vector<FlatFace> faces = flatFaces(box, 1e-9);
    QCOMPARE(faces.size(), std::size_t{6});
    QCOMPARE(edgeCount(faces), std::size_t{12});
    QCOMPARE(complaint(faces, box, 1e-9), std::string());
}

void FlatFacesTest::holesAreLoops()
{
    const TriangleMesh mesh = frame();
    const std::vector<FlatFace> faces = flatFaces(mesh, 1e-9);
    QCOMPARE(faces.size(), std::size_t{10});
    QCOMPARE(edgeCount(faces), std::size_t{24});
    QCOMPARE(std::count_if(faces.begin(), faces.end(), [](const FlatFace& f) { return f.loops.size() == 2; }), 2);
    QCOMPARE(complaint(faces, mesh, 1e-9), std::string());
}

void FlatFacesTest::curvedSurfacesKeepTheirTriangles()
{
    TriangleMesh mesh = shapes::torus(3, 1, 40, 24);
    mesh.faceOfTriangle.clear();
    const std::vector<FlatFace> faces = flatFaces(mesh, 1e-9);
    QVERIFY(faces.size() >= mesh.triangles.size() / 2); // the two of a quad may be flat
    QCOMPARE(complaint(faces, mesh, 1e-9), std::string());
}

void FlatFacesTest::noToleranceKeepsTriangles()
{
    const TriangleMesh mesh = frame();
    const std::vector<FlatFace> faces = flatFaces(mesh, 0);
    QCOMPARE(faces.size(), mesh.triangles.size());
    QCOMPARE(complaint(faces, mesh, 0), std::string());
}

void FlatFacesTest::cadFacesStayApart()
{
    TriangleMesh box = refine(shapes::box({4, 4, 4}), 1.1);
    for (std::size_t t = 0; t < box.triangles.size(); ++t)
        box.faceOfTriangle[t] =
            2 * box.faceOfTriangle[t] + (std::all_of(box.triangles[t].begin(), box.triangles[t].end(),
                                                     [&](std::uint32_t v) { return box.vertices[v].x() < 1e-9; })
                                             ? 1U
                                             : 0U);
    const std::vector<FlatFace> faces = flatFaces(box, 1e-9);
    QVERIFY2(faces.size() >= 10, qPrintable(QString::number(faces.size()))); // those across are divided
    for (const FlatFace& face : faces)
        QVERIFY(face.triangle < box.triangles.size());
    QCOMPARE(complaint(faces, box, 1e-9), std::string());
}

/// Of a square of three by three fields, the middle and a corner are other faces: hole and outside touch in a vertex.
void FlatFacesTest::bordersThatWouldMeetThemselvesComeApart()
{
    TriangleMesh slab;
    const auto vertex = [](int x, int y, int z) { return static_cast<std::uint32_t>((z * 4 + y) * 4 + x); };
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x)
                slab.vertices.emplace_back(x, y, z);
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t face) {
        slab.triangles.push_back({a, b, c});
        slab.triangles.push_back({a, c, d});
        slab.faceOfTriangle.insert(slab.faceOfTriangle.end(), {face, face});
    };
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const std::uint32_t top = (i == 1 && j == 1) || (i == 2 && j == 2) ? 1 : 0;
            add(vertex(i, j, 1), vertex(i + 1, j, 1), vertex(i + 1, j + 1, 1), vertex(i, j + 1, 1), top);
            add(vertex(i, j, 0), vertex(i, j + 1, 0), vertex(i + 1, j + 1, 0), vertex(i + 1, j, 0), 2);
        }
    for (int i = 0; i < 3; ++i) {
        add(vertex(i, 0, 0), vertex(i + 1, 0, 0), vertex(i + 1, 0, 1), vertex(i, 0, 1), 3);
        add(vertex(i + 1, 3, 0), vertex(i, 3, 0), vertex(i, 3, 1), vertex(i + 1, 3, 1), 4);
        add(vertex(0, i + 1, 0), vertex(0, i, 0), vertex(0, i, 1), vertex(0, i + 1, 1), 5);
        add(vertex(3, i, 0), vertex(3, i + 1, 0), vertex(3, i + 1, 1), vertex(3, i, 1), 6);
    }
    QVERIFY(isWatertight(slab));
    const std::vector<FlatFace> faces = flatFaces(slab, 1e-9);
    QCOMPARE(complaint(faces, slab, 1e-9), std::string());
    QVERIFY(faces.size() < slab.triangles.size());
    QVERIFY(faces.size() > 8);
}

void FlatFacesTest::roughnessBelowTheToleranceIsFlat()
{
    TriangleMesh box = refine(shapes::box({5, 3, 2}), 0.3);
    for (std::size_t v = 0; v < box.vertices.size(); ++v)
        box.vertices[v] *= 1 + 1e-7 * std::sin(static_cast<double>(13 * v));
    QCOMPARE(flatFaces(box, 1e-5).size(), std::size_t{6});
    QCOMPARE(complaint(flatFaces(box, 1e-5), box, 1e-5), std::string());
    QVERIFY(flatFaces(box, 1e-10).size() > 100);
}

QTEST_APPLESS_MAIN(FlatFacesTest)
#include "flat_faces_test.moc"
