#include "core/aggregate/fill.h"
#include "core/session/stretch_warning.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>

using namespace knead;

namespace {

Material rubberThatTears()
{
    Material material;
    material.youngsModulus = 2e6;
    material.tensileStrength = 2e5; // tears when it is a tenth longer
    return material;
}

/// A bar along x of one material, stretched evenly by a share of its length.
Snapshot::BodyState stretched(const Material& material, double share)
{
    Snapshot::BodyState body;
    body.aggregate = std::make_shared<const Aggregate>(fill(shapes::box({0.03, 0.01, 0.01}), {.spacing = 0.002}));
    body.relaxed =
        std::make_shared<const RelaxedState>(RelaxedState{.materials = MaterialMap(material, body.aggregate->size())});
    for (ObjectIndex o = 0; o < body.aggregate->size(); ++o)
        body.positions.push_back(Vec3(1 + share, 1, 1).cwiseProduct(body.aggregate->lattice.position(o)));
    return body;
}

} // namespace

class StretchWarningTest : public QObject {
    Q_OBJECT

private slots:
    void brittleMaterialIsNearBreakingWhereItsStretchIs()
    {
        QVERIFY(!mostOverstretched(stretched(rubberThatTears(), 0)));
        QVERIFY(!mostOverstretched(stretched(rubberThatTears(), 0.07)));
        const auto found = mostOverstretched(stretched(rubberThatTears(), 0.09));
        QVERIFY(found);
        QVERIFY2(std::abs(found->share - 0.9) < 0.02, qPrintable(QString::number(found->share)));
    }

    void theWorstPlaceIsFound()
    {
        Snapshot::BodyState body = stretched(rubberThatTears(), 0);
        for (Vec3& place : body.positions)
            if (place.x() > 0)
                place.x() += 0.09 * place.x() + 0.4 * place.x() * place.x();
        const auto found = mostOverstretched(body);
        QVERIFY(found);
        QCOMPARE(found->place, body.positions[found->object]);
        QVERIFY2(found->place.x() > 0.01, qPrintable(QString::number(found->place.x())));
    }

    void whatIsPressedOrNeverBreaksIsNot()
    {
        QVERIFY(!mostOverstretched(stretched(rubberThatTears(), -0.09)));
        Material strong = rubberThatTears();
        strong.tensileStrength = 0;
        QVERIFY(!mostOverstretched(stretched(strong, 0.5)));
        Snapshot::BodyState rigid = stretched(rubberThatTears(), 0.09);
        rigid.kind = BodyKind::rigid;
        QVERIFY(!mostOverstretched(rigid));
    }

    /// That breaks by what it has flowed.
    void ductileMaterialIsNearBreakingWhenItHasFlowedSoFar()
    {
        Material clay = rubberThatTears();
        clay.tensileStrength = 0;
        clay.yieldStress = 1e4;
        clay.elongationAtBreak = 0.5;
        const auto flowed = [&](double stretch) {
            Snapshot::BodyState body = stretched(clay, stretch);
            RelaxedState relaxed = *body.relaxed;
            for (std::size_t n = 0; n < 6; ++n)
                relaxed.metric[n].assign(body.aggregate->size(), n < 3 ? 1.0F : 0.0F);
            relaxed.equivalentStrain.assign(body.aggregate->size(), static_cast<float>(std::log1p(stretch)));
            body.relaxed = std::make_shared<const RelaxedState>(std::move(relaxed));
            return body;
        };
        QVERIFY(!mostOverstretched(flowed(0.2)));
        const auto found = mostOverstretched(flowed(0.45));
        QVERIFY(found);
        QVERIFY(std::abs(found->share - std::log(1.45) / std::log(1.5)) < 0.03);
        QVERIFY(!mostOverstretched(stretched(clay, 0.45))); // it came back before it flowed
    }
};

QTEST_GUILESS_MAIN(StretchWarningTest)
#include "stretch_warning_test.moc"
