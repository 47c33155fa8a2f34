#include "core/aggregate/fill.h"
#include "core/aggregate/pieces.h"
#include "core/skin/skin_gradients.h"
#include "support/shapes.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <functional>

using namespace knead;

namespace {

constexpr double spacing = 2e-3;

using Map = std::function<Vec3(const Vec3&)>;

/// A ball cut by its cells everywhere, and a bar; the skin's points and their gradients.
struct Skinned {
    TriangleMesh mesh;
    Aggregate aggregate;
    SkinGradients gradients;

    explicit Skinned(TriangleMesh surface)
        : mesh(std::move(surface))
        , aggregate(fill(mesh, {.spacing = spacing}))
        , gradients(aggregate, mesh.vertices)
    {
    }

    std::vector<Vec3> displacements(const Map& map) const
    {
        std::vector<Vec3> displacements;
        for (const ObjectIndex carrier : gradients.carriers()) {
            const Vec3 place = aggregate.lattice.position(carrier);
            displacements.push_back(map(place) - place);
        }
        return displacements;
    }
};

Skinned ball()
{
    return Skinned(shapes::sphere(7.3e-3, 24));
}

Skinned bar()
{
    return Skinned(shapes::box({0.03, 0.011, 0.009}));
}

} // namespace

class SkinGradientsTest : public QObject {
    Q_OBJECT

private slots:
    void influencesSumToOne()
    {
        for (const Skinned& body : {ball(), bar()})
            for (std::size_t point = 0; point < body.gradients.size(); ++point) {
                double sum = 0;
                Eigen::Vector3f slope = Eigen::Vector3f::Zero();
                float largest = 0;
                for (const auto& influence : body.gradients.influences(point)) {
                    sum += static_cast<double>(influence.value);
                    slope += influence.slope;
                    largest = std::max(largest, influence.slope.norm());
                }
                QVERIFY(std::abs(sum - 1) < 1e-5);
                QVERIFY(slope.norm() < 1e-5F * largest);
            }
    }

    void shearAndStretchAreExact()
    {
        Mat3 F;
        F << 1.2, 0.3, 0, -0.1, 0.8, 0.05, 0.02, 0, 1.1;
        for (const Skinned& body : {ball(), bar()}) {
            const auto displacements = body.displacements([&](const Vec3& X) { return Vec3(F * X + Vec3(1, 2, 3)); });
            for (std::size_t point = 0; point < body.gradients.size(); ++point) {
                const Mat3 found = Mat3::Identity() + body.gradients.sumOfProducts(point, displacements);
                QVERIFY2((found - F).norm() < 1e-4, qPrintable(QString::number((found - F).norm())));
            }
        }
    }

    /// As in bending: on the very skin, not a spacing below it.
    void quadraticMapsAreExactAtTheSkin()
    {
        constexpr double curvature = 4; // [1/m]
        const Map bent = [](const Vec3& X) {
            return Vec3(X.x() - curvature * X.x() * X.z(), X.y() + curvature * X.y() * X.z() / 3,
                        X.z() + curvature * X.x() * X.x() / 2);
        };
        for (const Skinned& body : {ball(), bar()}) {
            const auto displacements = body.displacements(bent);
            for (std::size_t point = 0; point < body.gradients.size(); ++point) {
                const Vec3 X = body.mesh.vertices[point];
                Mat3 wanted = Mat3::Zero();
                wanted(0, 0) = -curvature * X.z();
                wanted(0, 2) = -curvature * X.x();
                wanted(1, 1) = curvature * X.z() / 3;
                wanted(1, 2) = curvature * X.y() / 3;
                wanted(2, 0) = curvature * X.x();
                if (body.gradients.trust(point) < 1)
                    continue; // said to be worth less
                const Mat3 found = body.gradients.sumOfProducts(point, displacements);
                QVERIFY2((found - wanted).norm() < 2e-5, qPrintable(QString::number((found - wanted).norm())));
            }
        }
    }

    /// Two layers say a gradient, one does not.
    void whatLiesInAPlaneIsTrustedLess()
    {
        const Skinned plate(shapes::box({0.02, 0.02, 0.4 * spacing}));
        std::vector<ObjectIndex> lower;
        for (ObjectIndex i = 0; i < plate.aggregate.size(); ++i)
            if (plate.aggregate.lattice.position(i).z() < 0)
                lower.push_back(i);
        QVERIFY(2 * lower.size() == plate.aggregate.size());
        const std::vector<std::uint16_t> unbroken(plate.aggregate.size(), 0);
        const SkinGradients layer(extract(plate.aggregate, lower, unbroken), plate.mesh.vertices);
        for (std::size_t point = 0; point < layer.size(); ++point) {
            QCOMPARE(plate.gradients.trust(point), 1.0);
            QVERIFY2(layer.trust(point) < 0.5, qPrintable(QString::number(layer.trust(point))));
        }
    }

    void pointsOfAPieceHaveTheNumbersOfTheBody()
    {
        const Skinned whole = bar();
        std::vector<ObjectIndex> objects;
        std::vector<Vec3> points;
        for (ObjectIndex i = 0; i < whole.aggregate.size(); ++i)
            if (whole.aggregate.lattice.position(i).x() > 0)
                objects.push_back(i);
        for (const Vec3& vertex : whole.mesh.vertices)
            if (vertex.x() > 0)
                points.push_back(vertex);
        const std::vector<std::uint16_t> unbroken(whole.aggregate.size(), 0);
        const Aggregate piece = extract(whole.aggregate, objects, unbroken);
        const SkinGradients own(piece, points);
        const SkinGradients numbered(piece, points, objects);
        QCOMPARE(own.carriers().size(), numbered.carriers().size());
        for (std::size_t i = 0; i < own.carriers().size(); ++i)
            QCOMPARE(numbered.carriers()[i], objects[own.carriers()[i]]);
    }

    void anEmptyAggregateIsRefused()
    {
        const std::array point{Vec3(0, 0, 0)};
        QVERIFY_EXCEPTION_THROWN(SkinGradients(Aggregate(), point), std::invalid_argument);
    }
};

QTEST_APPLESS_MAIN(SkinGradientsTest)
#include "skin_gradients_test.moc"
