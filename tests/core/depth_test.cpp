// What tells the eye of depth: shades of hollows and ridges, and the shadow on the ground.
#include "core/aggregate/fill.h"
#include "core/session/ambient_shade.h"
#include "core/session/contact_shade.h"
#include "core/session/edge_sight.h"
#include "core/session/frame.h"
#include "core/session/ground_shadow.h"
#include "core/session/relief.h"
#include "support/shapes.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

ToolState toolAt(ToolKind kind, const Vec3& size, const Vec3& place)
{
    ToolState tool;
    tool.kind = kind;
    tool.size = size;
    tool.pose.position = place;
    return tool;
}

/// Of one vertex with a tool beside it.
double shadeAt(const Vec3& place, const Vec3& normal, const ToolState& tool)
{
    const Eigen::Vector3f p = place.cast<float>();
    const Eigen::Vector3f n = normal.cast<float>();
    const std::vector<float> shades = contactShades({p.data(), 3}, {n.data(), 3}, {&tool, 1});
    return shades.empty() ? 1 : shades[0];
}

constexpr double spacing = 1e-3; // [m]

/// A body that lies as it was filled, moved by so much.
Snapshot::BodyState bodyOf(const TriangleMesh& mesh, const Vec3& way = Vec3::Zero())
{
    Snapshot::BodyState state;
    state.aggregate = std::make_shared<const Aggregate>(fill(mesh, {.spacing = spacing}));
    for (std::size_t i = 0; i < state.aggregate->size(); ++i)
        state.positions.push_back(state.aggregate->lattice.position(i) + way);
    return state;
}

TriangleMesh boxAt(const Vec3& size, const Vec3& center)
{
    return shapes::moved(shapes::box(size), {center, Quaternion::Identity()});
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
        QVERIFY(bendOfShade(hollow) > 0.4F && bendOfShade(ridge) < -0.25F && bendOfShade(1) == 0);
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

    /// What a section plane cuts off is not seen, and neither is its shadow.
    void whatIsCutOffCastsNone()
    {
        Sheet sheet(0);
        const ShadowCaster caster{sheet.mesh.triangles, sheet.points};
        const GroundShadow shadow = groundShadow({{caster}}, {}, 0, CutPlane{Vec3::UnitX(), 0.1});
        QVERIFY(darknessAt(shadow, -0.3, 0) > 0.95F);
        QVERIFY(darknessAt(shadow, 0.3, 0) < 0.05F);
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

    /// A ball of radius R whose middle is H above a plane keeps H R^2 / d^3 of the light off a place at distance d of
    /// its middle.
    void aBallAboveAPlaneDarkensItAsItsSolidAngleSays()
    {
        const double radius = 0.25;
        const double size = 2 * radius;
        for (const double gap : {0.01, 0.1, 0.3, 0.45})
            for (const double beside : {0.0, 0.1, 0.25, 0.4}) {
                const double height = radius + gap;
                const ToolState ball = toolAt(ToolKind::ball, Vec3::Constant(size), Vec3(0, 0, height));
                const double far = std::hypot(height, beside);
                const double share = (far - radius) / size;
                const double fade = share < 1 ? std::pow(1 - share * share, 2) : 0;
                const double wanted = 1 - contactDarkest * height * radius * radius / (far * far * far) * fade;
                const double shade = shadeAt(Vec3(beside, 0, 0), Vec3::UnitZ(), ball);
                QVERIFY2(
                    std::abs(shade - wanted) < 1e-5,
                    qPrintable(QString("%1 above, %2 beside: %3, not %4").arg(gap).arg(beside).arg(shade).arg(wanted)));
            }
        const ToolState touching = toolAt(ToolKind::ball, Vec3::Constant(size), Vec3(0, 0, radius));
        QVERIFY(std::abs(shadeAt(Vec3::Zero(), Vec3::UnitZ(), touching) - (1 - contactDarkest)) < 1e-4);
        QCOMPARE(shadeAt(Vec3::Zero(), -Vec3::UnitZ(), touching), 1.0); // it is behind the sheet
    }

    /// At the foot of a high wall half of the sky is gone; a ball in the horizon hides (atan(1 / q) - q / h^2) / pi,
    /// q^2 = h^2 - 1.
    void theHorizonCutsWhatStandsBeside()
    {
        const ToolState wall = toolAt(ToolKind::box, Vec3::Ones(), Vec3(0.5 + 1e-7, 0, 0));
        QVERIFY(std::abs(shadeAt(Vec3::Zero(), Vec3::UnitZ(), wall) - (1 - contactDarkest / 2)) < 1e-3);
        const ToolState ball = toolAt(ToolKind::ball, Vec3::Ones(), Vec3(0.75, 0, 0));
        const double h = 1.5;
        const double q = std::sqrt(h * h - 1);
        const double kept = (std::atan(1 / q) - q / (h * h)) / std::numbers::pi;
        const double fade = std::pow(1 - 0.25 * 0.25, 2);
        QVERIFY(std::abs(shadeAt(Vec3::Zero(), Vec3::UnitZ(), ball) - (1 - contactDarkest * kept * fade)) < 1e-5);
    }

    /// Under every kind of tool it gets lighter, the higher the tool is, up to one size of it.
    void theFartherAToolTheLighterItIsUnderneath()
    {
        for (const ToolKind kind :
             {ToolKind::box, ToolKind::ball, ToolKind::cylinder, ToolKind::wedge, ToolKind::plate}) {
            const Vec3 size = fittingSize(kind, kind == ToolKind::plate ? Vec3(0.2, 0.2, 0.02) : Vec3(0.2, 0.2, 0.2));
            double before = 0;
            for (const double gap : {1e-6, 0.02, 0.05, 0.1, 0.15, 0.21}) {
                const double shade =
                    shadeAt(Vec3::Zero(), Vec3::UnitZ(), toolAt(kind, size, Vec3(0, 0, size.z() / 2 + gap)));
                QVERIFY2(shade > before, qPrintable(QString("%1 at %2: %3").arg(int(kind)).arg(gap).arg(shade)));
                before = shade;
            }
            QCOMPARE(before, 1.0);
        }
    }

    /// Of a cube one sees 9 edges at a corner, and from right before a face only its own 4, unless one is far away.
    void edgesBehindTheMaterialAreNotSeen()
    {
        const RenderMesh cube = renderMesh(meshOf({ToolKind::box, Vec3::Ones(), nullptr}));
        const EdgeSight sight(cube);
        std::vector<Vec3> places = meshOf({ToolKind::box, Vec3::Ones(), nullptr}).vertices;
        const std::vector<float> points = renderPoints(cube, places);
        const auto seen = [&](const std::optional<Vec3>& eye, const Vec3& towards) {
            const std::vector<bool> edges = sight.seenFrom(points, eye, towards);
            return std::count(edges.begin(), edges.end(), true);
        };
        QCOMPARE(cube.edges.size(), std::size_t{12});
        QCOMPARE(seen(Vec3(5, 4, 3), Vec3::UnitX()), 9);
        QCOMPARE(seen(std::nullopt, Vec3(3, 2, 1).normalized()), 9);
        QCOMPARE(seen(Vec3(0.1, 0.1, 3), Vec3::UnitZ()), 4);
        QCOMPARE(seen(Vec3(5, 4, 0.2), Vec3::UnitX()), 7);
    }

    void toolsShadeWhatIsInTheirReach()
    {
        const Sheet sheet(0);
        const std::vector<float> normals = renderNormals(sheet.mesh, sheet.points);
        const auto shades = [&](const ToolState& tool) { return contactShades(sheet.points, normals, {{tool}}); };
        QVERIFY(shades(toolAt(ToolKind::ball, Vec3::Ones(), Vec3(0, 0, 9))).empty());
        ToolState part = toolAt(ToolKind::part, Vec3::Ones(), Vec3(0, 0, 0.13));
        part.part = std::make_shared<ToolPart>(meshOf({ToolKind::ball, Vec3::Constant(0.25), nullptr}));
        QVERIFY(!shades(part).empty());
        part.pose.position.z() = 9;
        QVERIFY(shades(part).empty());
    }

    /// Time stands still then, and the surface with it.
    void aToolThatIsPlacedWhileNothingMovesShadesAnew()
    {
        const Sheet sheet(0);
        auto surface = std::make_shared<BodyFrame>();
        surface->points = sheet.points;
        surface->normals = renderNormals(sheet.mesh, sheet.points);
        auto before = std::make_shared<Frame>();
        before->bodies = {surface};
        before->snapshot = std::make_shared<Snapshot>();
        auto later = std::make_shared<Snapshot>();
        later->tools = {toolAt(ToolKind::ball, Vec3::Constant(0.2), Vec3(0, 0, 0.15))};
        const FramePointer hovering = prepareFrame({}, later, before);
        QCOMPARE(hovering->bodies, before->bodies);
        QCOMPARE(hovering->contactShades.size(), std::size_t{1});
        QVERIFY(hovering->contactShades[0]);
        QCOMPARE(prepareFrame({}, std::make_shared<Snapshot>(*later), hovering)->contactShades,
                 hovering->contactShades);
        auto lower = std::make_shared<Snapshot>(*later);
        lower->tools[0].pose.position.z() = 0.12;
        const FramePointer near = prepareFrame({}, lower, hovering);
        QVERIFY(near->contactShades[0]->at(side * side / 2) < hovering->contactShades[0]->at(side * side / 2));
        lower = std::make_shared<Snapshot>(*lower);
        lower->tools[0].pose.position.z() = 2;
        QVERIFY(!prepareFrame({}, lower, near)->contactShades[0]);
    }

    /// However its faces lie on the lattice and on the grid.
    void aBoxAloneIsFullyLit()
    {
        for (const double shift : {0.0, 0.31e-3, 0.5e-3, 0.83e-3}) {
            const Vec3 way(shift, 0.7 * shift, 1.3 * shift);
            const Vec3 size(20.4e-3, 20.9e-3, 12.2e-3);
            const Snapshot::BodyState body = bodyOf(shapes::box(size), way);
            const MaterialAround material({&body, 1});
            for (double x = -0.5; x <= 0.5; x += 0.05)
                for (const double sign : {-1.0, 1.0}) {
                    QVERIFY(material.shade(way + Vec3(x * size.x(), 0, sign * size.z() / 2), sign * Vec3::UnitZ()) >
                            0.97);
                    QVERIFY(material.shade(way + Vec3(sign * size.x() / 2, x * size.y(), 0), sign * Vec3::UnitX()) >
                            0.97);
                }
        }
    }

    /// In a right-angled corner half of the light is kept off, nearly nothing far from it.
    void cornersAndHollowsAreDarker()
    {
        const std::array bodies{bodyOf(boxAt({40e-3, 40e-3, 8e-3}, {0, 0, -4e-3})),
                                bodyOf(boxAt({8e-3, 40e-3, 30e-3}, {-16e-3, 0, 15e-3}))};
        const MaterialAround material(bodies);
        const auto shadeAt = [&](double x) { return material.shade({x, 0, 0}, Vec3::UnitZ()); };
        QVERIFY2(shadeAt(-12e-3) > 0.25 && shadeAt(-12e-3) < 0.6, qPrintable(QString::number(shadeAt(-12e-3))));
        for (double x = -11e-3; x < 15e-3; x += 1e-3)
            QVERIFY2(shadeAt(x) > shadeAt(x - 1e-3) - 0.02, qPrintable(QString::number(x)));
        QVERIFY2(shadeAt(15e-3) > 0.97, qPrintable(QString::number(shadeAt(15e-3))));
        // A pit, five cells wide and deep.
        const std::array walls{bodyOf(boxAt({25e-3, 10e-3, 5e-3}, {0, 7.5e-3, -2.5e-3})),
                               bodyOf(boxAt({25e-3, 10e-3, 5e-3}, {0, -7.5e-3, -2.5e-3})),
                               bodyOf(boxAt({10e-3, 5e-3, 5e-3}, {7.5e-3, 0, -2.5e-3})),
                               bodyOf(boxAt({10e-3, 5e-3, 5e-3}, {-7.5e-3, 0, -2.5e-3})),
                               bodyOf(boxAt({25e-3, 25e-3, 4e-3}, {0, 0, -7e-3}))};
        const MaterialAround pit(walls);
        const double bottom = pit.shade({0, 0, -5e-3}, Vec3::UnitZ());
        QVERIFY2(bottom < 0.75, qPrintable(QString::number(bottom)));
        QVERIFY(bottom < pit.shade({0, 8e-3, 0}, Vec3::UnitZ()) - 0.2);
    }

    void whatComesNearDarkens()
    {
        const TriangleMesh plate = boxAt({30e-3, 30e-3, 6e-3}, {0, 0, -3e-3});
        const TriangleMesh ball = shapes::sphere(8e-3, 32);
        double before = 0;
        for (const double gap : {1e-3, 4e-3, 8e-3, 60e-3}) {
            const std::array bodies{bodyOf(plate), bodyOf(ball, {0, 0, 8e-3 + gap})};
            const double shade = MaterialAround(bodies).shade(Vec3::Zero(), Vec3::UnitZ());
            QVERIFY2(shade > before, qPrintable(QString::number(shade)));
            before = shade;
        }
        QVERIFY(before > 0.99);
    }

    void nothingThrowsNoShade()
    {
        QCOMPARE(MaterialAround({}).shade(Vec3::Zero(), Vec3::UnitX()), 1.0);
        const std::array<float, 6> two{0, 0, 0, 1, 1, 1};
        QVERIFY(ambientShades(two, two, MaterialAround({})).empty());
    }
};

QTEST_APPLESS_MAIN(DepthTest)
#include "depth_test.moc"
