#include "core/deformation/field_fit.h"
#include "core/deformation/field_map.h"
#include "support/shapes.h"

#include <QtTest>

#include <functional>

using namespace knead;

namespace {

const Vec3 partSize(0.1, 0.04, 0.02);

/// Nodes of a box of this size about the origin, which move by u.
FieldDeformation fieldOf(const Vec3& size, const std::function<Vec3(const Vec3&)>& u, double spacing = 0.005)
{
    DisplacementField field;
    const Eigen::Vector3i count = (size / spacing).array().round().cast<int>();
    for (int i = 0; i <= count.x(); ++i)
        for (int j = 0; j <= count.y(); ++j)
            for (int k = 0; k <= count.z(); ++k) {
                const Vec3 node = spacing * Vec3(i, j, k) - size / 2;
                field.nodes.push_back(node);
                field.displacements.push_back(u(node));
            }
    return {.field = std::make_shared<const DisplacementField>(std::move(field))};
}

Vec3 sag(const Vec3& p)
{
    return {0, 0, p.x() * p.x()};
}

FieldDeformation moved(const FieldDeformation& from, const std::function<Vec3(const Vec3&)>& place)
{
    DisplacementField field = *from.field;
    for (Vec3& node : field.nodes)
        node = place(node);
    return {.field = std::make_shared<const DisplacementField>(std::move(field))};
}

FieldFit fitTo(const FieldDeformation& deformation, const std::vector<TriangleMesh>& parts,
               const std::string& unit = {})
{
    return fitOfField(deformation, *fieldMap(deformation), parts, unit);
}

bool says(const std::vector<Message>& remarks, const char* words)
{
    return std::ranges::any_of(remarks,
                               [&](const Message& one) { return one.english().find(words) != std::string::npos; });
}

bool refuses(const FieldFit& fit, const char* words)
{
    return fit.mismatch && fit.mismatch->english().find(words) != std::string::npos;
}

} // namespace

class FieldFitTest : public QObject {
    Q_OBJECT

private slots:
    void fieldOfThePartFits()
    {
        const FieldFit fit = fitTo(fieldOf(partSize, sag), {shapes::box(partSize)});
        QVERIFY(!fit.mismatch);
        QVERIFY(fit.remarks.empty());
        QCOMPARE(fit.uncovered, 0.0);
        QVERIFY(std::abs(fit.spacing - 0.005) < 1e-12);
        QVERIFY(fit.farthest.value < 0.005);
        QVERIFY(std::abs(fit.displacement.value - 0.0025) < 2e-5);
        QVERIFY(fit.displacement.face && *fit.displacement.face < 6);
        QVERIFY(std::abs(fit.determinant.value - 1) < 1e-6);
        QVERIFY((fit.nodes.sizes() - fit.parts.sizes()).norm() < 1e-12);
    }

    void unitThatWasMeantIsSuggested()
    {
        const FieldDeformation field = fieldOf(partSize, sag);
        const std::vector<TriangleMesh> part{shapes::box(partSize)};
        const auto times = [&](double factor) { return moved(field, [=](const Vec3& p) { return Vec3(factor * p); }); };
        QVERIFY(refuses(fitTo(times(1e-3), part, "mm"), "\"m\""));
        QVERIFY(refuses(fitTo(times(1e3), part, "m"), "\"mm\""));
        QVERIFY(refuses(fitTo(times(1 / 25.4), part, "mm"), "\"inch\""));
        QVERIFY(refuses(fitTo(times(25.4), part, "inch"), "\"mm\""));
        QVERIFY(refuses(fitTo(times(0.1), part), "\"cm\""));
    }

    void fieldThatLiesElsewhereOrIsTurnedIsTold()
    {
        const FieldDeformation field = fieldOf(partSize, sag);
        const std::vector<TriangleMesh> part{shapes::box(partSize)};
        QVERIFY(refuses(fitTo(moved(field, [](const Vec3& p) { return Vec3(p + Vec3(0.2, 0, 0)); }), part),
                        "its middle is at (200, 0, 0) mm, theirs at"));
        QVERIFY(
            refuses(fitTo(moved(field, [](const Vec3& p) { return Vec3(p.z(), p.x(), p.y()); }), part), "is turned"));
        QVERIFY(refuses(fitTo(fieldOf(Vec3(0.02, 0.005, 0.005), sag, 0.0025), part), "not of these parts"));
    }

    void whatItDoesNotCoverIsToldWithItsFace()
    {
        const FieldFit fit = fitTo(fieldOf(partSize, sag),
                                   {shapes::box(partSize), shapes::moved(shapes::box(Vec3(0.02, 0.02, 0.02)),
                                                                         {Vec3(0.08, 0, 0), Quaternion::Identity()})});
        QVERIFY(!fit.mismatch);
        QVERIFY(fit.uncovered > 0.05 && fit.uncovered < 0.3);
        QCOMPARE(fit.farthest.part, std::size_t{1});
        QVERIFY(fit.farthest.face && *fit.farthest.face == 1);
        QVERIFY(std::abs(fit.farthest.value - 0.04) < 1e-3);
        QVERIFY(says(fit.remarks, "on face 1, at (90, "));
    }

    /// As the swept meshes of simulations have them.
    void elementsLongerThanThickCoverThePart()
    {
        const auto longer = [](const Vec3& p) { return Vec3(8 * p.x(), p.y(), p.z()); };
        const FieldDeformation field =
            moved(fieldOf(
                      Vec3(0.0125, 0.04, 0.02), [&](const Vec3& p) { return sag(longer(p)); }, 0.00125),
                  longer);
        const FieldFit fit = fitTo(field, {shapes::box(partSize)});
        QCOMPARE(fit.uncovered, 0.0);
        QVERIFY(fit.remarks.empty());
        const FieldFit further = fitTo(field, {shapes::box(Vec3(0.14, 0.04, 0.02))});
        QVERIFY(further.uncovered > 0.2 && further.uncovered < 0.4);
        QVERIFY(says(further.remarks, "there the field is continued"));
    }

    void foldIsTold()
    {
        FieldDeformation field =
            fieldOf(partSize, [](const Vec3& p) { return Vec3(0.4 * p.x() * std::abs(p.x()) / 0.05, 0, 0); });
        QVERIFY(!fitTo(field, {shapes::box(partSize)}).folds());
        field.factor = -2;
        const FieldFit fit = fitTo(field, {shapes::box(partSize)});
        QVERIFY(fit.folds());
        QVERIFY(std::abs(fit.determinant.place.x()) > 0.03);
        QVERIFY(says(fit.remarks, "folds the material"));
    }

    void slitIsTold()
    {
        // Two halves that come apart: their nodes at y = 0 are a hundredth of a spacing from each other.
        const FieldDeformation halves =
            fieldOf(partSize, [](const Vec3& p) { return Vec3(0, 0, p.x() > 0 ? 1e-3 * p.x() : 0); });
        DisplacementField slit = *halves.field;
        for (std::size_t i = 0; i < halves.field->nodes.size(); ++i) {
            const Vec3& node = halves.field->nodes[i];
            const bool isLower = node.y() < 1e-9;
            slit.displacements[i] = Vec3(0, 0, (isLower ? -1 : 1) * std::max(node.x(), 0.0) * 0.05);
            if (std::abs(node.y()) < 1e-9) {
                slit.nodes.push_back(node + Vec3(0, 5e-5, 0));
                slit.displacements.push_back(-slit.displacements[i]);
            }
        }
        const FieldFit fit = fitTo({.field = std::make_shared<const DisplacementField>(slit)}, {shapes::box(partSize)});
        QVERIFY(fit.roughness > 0.01);
        QVERIFY(std::abs(fit.roughest.place.y()) < 1e-3);
        QVERIFY(says(fit.remarks, "two sides of a slit"));
    }
};

QTEST_GUILESS_MAIN(FieldFitTest)
#include "field_fit_test.moc"
