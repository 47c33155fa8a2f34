#include "core/simulation/first_press.h"

#include "support/shapes.h"

#include <QtTest>

#include <cmath>

using namespace knead;

namespace {

Part boxPart(const Vec3& size)
{
    Part part;
    part.name = "box";
    part.mesh = shapes::moved(shapes::box(size), {0.5 * size, Quaternion::Identity()});
    part.box = Box(Vec3::Zero(), size);
    part.volume = size.prod();
    part.area = 2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
    part.watertight = true;
    return part;
}

Model modelOf(std::vector<Part> parts)
{
    Model model;
    model.file = "folder/box.step";
    model.parts = std::move(parts);
    return model;
}

double strokeOf(const FirstPress& press)
{
    const auto& frames = std::get<FollowKeyFrames>(press.block.motion).frames;
    return (frames.back().pose.position - frames.front().pose.position).norm();
}

} // namespace

class FirstPressTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsLongIsBent();
    void whatIsCompactIsSqueezed();
    void whatBreaksIsPressedLess();
    void openPartsAreRefused();
    void strainsAtBreak();
};

void FirstPressTest::whatIsLongIsBent()
{
    const FirstPress press = firstPress(modelOf({boxPart({0.1, 0.02, 0.01})}));
    QVERIFY(std::abs(press.held.max().x() - 0.012) < 1e-12 && press.held.min().x() < 0);
    QVERIFY(press.held.max().y() > 0.02 && press.held.max().z() > 0.01);
    const auto& frames = std::get<FollowKeyFrames>(press.block.motion).frames;
    const Vec3 way = frames.back().pose.position - frames.front().pose.position;
    QVERIFY(std::abs(way.z() + 0.008) < 1e-12 && way.x() == 0 && way.y() == 0); // 7 % and the gap of 1 %
    const double lowest = frames.front().pose.position.z() - press.block.size.z() / 2;
    QVERIFY(std::abs(lowest - 0.011) < 1e-12);
    QVERIFY(press.bends && !press.hasBodies && manipulatorProblems(press.block).empty());
}

void FirstPressTest::whatIsCompactIsSqueezed()
{
    const FirstPress press = firstPress(modelOf({boxPart({0.03, 0.03, 0.02}), boxPart({0.03, 0.03, 0.02})}));
    QVERIFY(std::abs(press.held.max().z() - 0.0024) < 1e-12 && press.held.max().x() > 0.03);
    QVERIFY(std::abs(strokeOf(press) - 0.14 * 0.02) < 1e-12);
    QVERIFY(press.hasBodies && !press.bends);
}

void FirstPressTest::whatBreaksIsPressedLess()
{
    const Model bar = modelOf({boxPart({0.1, 0.02, 0.01})});
    const Model cube = modelOf({boxPart({0.02, 0.02, 0.02})});
    const double gap = 0.001;
    // e = 3 t d / (2 l^2), half of what breaks, 70 mm from the grip.
    QVERIFY(std::abs(strokeOf(firstPress(bar, 0.01)) - gap - 0.005 * 2 * 0.07 * 0.07 / (3 * 0.01)) < 1e-9);
    QVERIFY(std::abs(strokeOf(firstPress(cube, 0.01)) - 0.02 * 0.02 - 0.005 * 0.02) < 1e-12);
    QCOMPARE(strokeOf(firstPress(bar, 10)), strokeOf(firstPress(bar)));
}

void FirstPressTest::openPartsAreRefused()
{
    Part open = boxPart({1, 1, 1});
    open.watertight = false;
    QVERIFY_EXCEPTION_THROWN(firstPress(modelOf({open})), std::runtime_error);
}

void FirstPressTest::strainsAtBreak()
{
    Material material;
    QVERIFY(std::isinf(strainAtBreak(material)));
    material.youngsModulus = 70e9;
    material.tensileStrength = 70e6;
    QCOMPARE(strainAtBreak(material), 1e-3);
    material.yieldStress = 50e6;
    material.elongationAtBreak = 0.12;
    QCOMPARE(strainAtBreak(material), 0.12);
}

QTEST_APPLESS_MAIN(FirstPressTest)
#include "first_press_test.moc"
