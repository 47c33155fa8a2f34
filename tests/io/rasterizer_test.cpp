#include "io/picture/rasterizer.h"

#include <QtTest>

#include <array>
#include <random>

using namespace knead;

namespace {

constexpr int width = 90;
constexpr int height = 60;

double cross(const Vec3& a, const Vec3& b, const Vec3& c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

ScreenMesh meshOf(const std::array<Vec3, 3>& corners)
{
    ScreenMesh mesh;
    mesh.places.assign(corners.begin(), corners.end());
    mesh.triangles = {{0, 1, 2}};
    mesh.normals.resize(1, {Vec3::UnitZ(), Vec3::UnitZ(), Vec3::UnitZ()});
    mesh.surfaceOfTriangle = {7};
    return mesh;
}

class RasterizerTest : public QObject {
    Q_OBJECT

    /// Whether each sample is seen as the triangle says: within is drawn, without is not; on an edge, it may be either.
    static bool isDrawnAsItIs(const std::array<Vec3, 3>& corners)
    {
        const auto& [a, b, c] = corners;
        const double area = cross(a, b, c);
        if (area == 0)
            return true;
        const Projection projection{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
        const SampleBand band = rasterize(meshOf(corners), projection, width, 0, height);
        for (int row = 0; row < height; ++row)
            for (int x = 0; x < width; ++x) {
                const Vec3 place(x + 0.5, row + 0.5, 0);
                const double least = std::min({cross(place, b, c), cross(a, place, c), cross(a, b, place)},
                                              [&](double p, double q) { return p / area < q / area; }) /
                                     area;
                const bool isSeen = band.at(x, row).surface == 7;
                if (std::abs(least) > 1e-9 && isSeen != (least > 0))
                    return false;
            }
        return true;
    }

private slots:
    void trianglesOfAnyShapeAreFilled()
    {
        std::mt19937 random(5); // the same ones each time
        std::uniform_real_distribution<double> anywhere(-40, 130);
        std::uniform_real_distribution<double> little(-0.4, 0.4);
        for (int i = 0; i < 300; ++i) {
            const Vec3 a(anywhere(random), anywhere(random), 1);
            const Vec3 b(anywhere(random), anywhere(random), 2);
            const Vec3 c(anywhere(random), anywhere(random), 3);
            QVERIFY(isDrawnAsItIs({a, b, c}));
            QVERIFY(isDrawnAsItIs({a, c, b}));
            const Vec3 beside = 0.4 * a + 0.6 * b + Vec3(little(random), little(random), 0);
            QVERIFY(isDrawnAsItIs({a, b, beside})); // long and thin
        }
    }

    void levelSidesAndCornersOnRowsAreNoTrouble()
    {
        const std::array<Vec3, 3> some[] = {{Vec3(10, 10.5, 0), Vec3(50, 10.5, 0), Vec3(30, 40.5, 0)},
                                            {Vec3(10, 40.5, 0), Vec3(50, 40.5, 0), Vec3(30, 10, 0)},
                                            {Vec3(5, 20, 0), Vec3(80, 20.5, 0), Vec3(5, 21, 0)},
                                            {Vec3(-20, 5.5, 0), Vec3(200, 5.5, 0), Vec3(45, 59.5, 0)},
                                            {Vec3(20.5, 1.5, 0), Vec3(20.5, 55.5, 0), Vec3(21.5, 30.5, 0)}};
        for (const std::array<Vec3, 3>& corners : some)
            QVERIFY(isDrawnAsItIs(corners));
    }
};

} // namespace

QTEST_APPLESS_MAIN(RasterizerTest)
#include "rasterizer_test.moc"
