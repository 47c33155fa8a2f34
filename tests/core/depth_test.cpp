// What tells the eye of depth: shades of hollows and ridges, and the shadow on the ground.
#include "core/session/ground_shadow.h"
#include "core/session/relief.h"

#include <QTest>

#include <cmath>

using namespace knead;

namespace {

constexpr int side = 41; // vertices along either edge of a sheet

/// A sheet of 1 m with a bell-shaped bump in its middle; below 0 a hollow. @param height [m]
struct Sheet {
    RenderMesh mesh;
    std::vector<float> points;

    explicit Sheet(double height)
    {
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double u = x / (side - 1.0) - 0.5;
                const double v = y / (side - 1.0) - 0.5;
                for (const double coordinate : {u, v, height * std::exp(-(u * u + v * v) / 0.005)})
                    points.push_back(static_cast<float>(coordinate));
                mesh.source.push_back(static_cast<std::uint32_t>(mesh.source.size()));
            }
        const auto at = [](int x, int y) { return static_cast<std::uint32_t>(y * side + x); };
        for (int y = 0; y + 1 < side; ++y)
            for (int x = 0; x + 1 < side; ++x) {
                mesh.triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
                mesh.triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
            }
    }

    /// In the middle, and far from it.
    std::pair<float, float> shades() const
    {
        const std::vector<float> all = reliefShades(mesh, points, renderNormals(mesh, points));
        return {all[side * side / 2], all[side * 5 + 5]};
    }
};

float darknessAt(const GroundShadow& shadow, double x, double y)
{
    const auto column = std::lround((x - shadow.low.x()) / shadow.step);
    const auto row = std::lround((y - shadow.low.y()) / shadow.step);
    return shadow.darkness.at(static_cast<std::size_t>(row * shadow.side + column));
}

} // namespace

class DepthTest : public QObject {
    Q_OBJECT

private slots:
    void hollowsAreDarkAndRidgesLight()
    {
        const auto [hollow, flat] = Sheet(-0.08).shades();
        QVERIFY2(hollow < 0.8F, qPrintable(QString::number(hollow)));
        QVERIFY2(std::abs(flat - 1) < 0.02F, qPrintable(QString::number(flat)));
        const auto [ridge, beside] = Sheet(0.08).shades();
        QVERIFY2(ridge > 1.03F && ridge < 1.13F, qPrintable(QString::number(ridge)));
        QVERIFY(std::abs(beside - 1) < 0.02F);
        QCOMPARE(Sheet(0).shades().first, 1.0F);
    }

    void whatTouchesTheGroundIsDarkestUnderneath()
    {
        Sheet sheet(0);
        float before = 2;
        for (const double height : {0.0, 0.1, 0.4}) {
            const GroundShadow shadow = groundShadow({{{sheet.mesh.triangles, sheet.points}}}, {}, -height);
            const float under = darknessAt(shadow, 0, 0);
            QVERIFY2(under < before, qPrintable(QString("%1 m above: %2").arg(height).arg(under)));
            QVERIFY(under > 0);
            before = under;
            QVERIFY2(shadow.darkness.front() == 0, "it ends at its rim");
            if (height == 0)
                QVERIFY(under > 0.95F && darknessAt(shadow, 0.45, 0.45) > 0.9F && darknessAt(shadow, 0.57, 0) < 0.3F);
        }
        QCOMPARE(groundShadow({}, {}, 0).side, 0);
    }

    /// A tool says itself how high it is above a place.
    void toolsCastOneToo()
    {
        const ShadowProbe probe{Box(Vec3(-1, -1, 0), Vec3(1, 1, 1)),
                                [](const Vec3& place) { return place.x() < 0 ? 0.0 : -1.0; }};
        const GroundShadow shadow = groundShadow({}, {{probe}}, 0);
        QVERIFY(darknessAt(shadow, -0.5, 0) > 0.95F);
        QVERIFY(darknessAt(shadow, 0.5, 0) < 0.05F);
    }
};

QTEST_APPLESS_MAIN(DepthTest)
#include "depth_test.moc"
