#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>

using namespace knead;

namespace {

double longestEdge(const TriangleMesh& mesh)
{
    double longest = 0;
    for (const auto& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            longest = std::max(longest, (mesh.vertices[t[i]] - mesh.vertices[t[(i + 1) % 3]]).norm());
    return longest;
}

} // namespace

class RefineTest : public QObject {
    Q_OBJECT
private slots:
    void edgesAreShortAndTheSolidIsUnchanged()
    {
        const TriangleMesh coarse = shapes::box({0.1, 0.03, 0.013});
        const TriangleMesh fine = refine(coarse, 0.004);
        QVERIFY(longestEdge(fine) <= 0.004);
        QVERIFY(isWatertight(fine));
        QVERIFY(std::abs(massProperties(fine).volume - 0.1 * 0.03 * 0.013) < 1e-15);
    }

    void trianglesStayOnTheirFace()
    {
        const TriangleMesh coarse = shapes::box({1, 1, 1});
        const TriangleMesh fine = refine(coarse, 0.2);
        QCOMPARE(fine.faceOfTriangle.size(), fine.triangles.size());
        for (std::size_t t = 0; t < fine.triangles.size(); ++t) {
            const std::uint32_t face = fine.faceOfTriangle[t]; // -x, +x, -y, +y, -z, +z
            for (const std::uint32_t v : fine.triangles[t])
                QCOMPARE(fine.vertices[v][face / 2], face % 2 == 0 ? -0.5 : 0.5);
        }
    }

    void aFineMeshIsLeftAlone()
    {
        const TriangleMesh mesh = shapes::box({1, 1, 1});
        QCOMPARE(refine(mesh, 2).triangles, mesh.triangles);
    }

    /// As many small triangles as there may be must not keep the long ones from being split.
    void longEdgesAreSplitBesideManySmallTriangles()
    {
        TriangleMesh mesh = refine(shapes::box({0.01, 0.01, 0.01}), 0.001);
        const std::size_t small = mesh.triangles.size();
        const TriangleMesh box = shapes::box({1, 0.5, 0.2});
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), box.vertices.begin(), box.vertices.end());
        for (std::size_t t = 0; t < box.triangles.size(); ++t) {
            const auto& [a, b, c] = box.triangles[t];
            mesh.triangles.push_back({a + first, b + first, c + first});
            mesh.faceOfTriangle.push_back(box.faceOfTriangle[t]);
        }
        const TriangleMesh fine = refine(mesh, 0.1, small);
        QVERIFY(longestEdge(fine) <= 0.2);
    }

    void theNumberOfTrianglesIsBounded()
    {
        const TriangleMesh fine = refine(shapes::box({1, 1, 1}), 1e-4, 5000);
        QVERIFY(fine.triangles.size() > 1000);
        QVERIFY(fine.triangles.size() < 20'000);
        QVERIFY(isWatertight(fine));
    }

    void halvesOfAllEdgesMakeFourTrianglesOfEach()
    {
        const TriangleMesh coarse = shapes::box({0.1, 0.03, 0.013});
        const TriangleMesh fine = halveEdges(coarse);
        QCOMPARE(fine.triangles.size(), 4 * coarse.triangles.size());
        QCOMPARE(longestEdge(fine), 0.5 * longestEdge(coarse));
        QVERIFY(isWatertight(fine));
        QVERIFY(std::abs(massProperties(fine).volume - 0.1 * 0.03 * 0.013) < 1e-15);
    }
};

QTEST_GUILESS_MAIN(RefineTest)
#include "refine_test.moc"
