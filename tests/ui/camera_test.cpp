#include "ui/viewport/camera.h"
#include "ui/viewport/manipulation.h"

#include <QtTest>

#include <cmath>

using namespace knead;

namespace {

constexpr WindowSize window{800, 600};

Camera sample()
{
    Camera camera;
    camera.target = Vec3(0.01, -0.02, 0.03);
    camera.distance = 0.4;
    camera.yaw = 0.7;
    camera.pitch = 0.3;
    return camera;
}

double distanceToRay(const Ray& ray, const Vec3& place)
{
    return (place - ray.origin).cross(ray.direction).norm();
}

} // namespace

class CameraTest : public QObject {
    Q_OBJECT
private slots:
    void axesAreOrthonormalAndRightHanded()
    {
        const Camera camera = sample();
        QVERIFY((camera.right().cross(camera.up()) - camera.towardsEye()).norm() < 1e-12);
        QVERIFY(std::abs(camera.right().norm() - 1) < 1e-12);
    }

    void aRayGoesThroughWhatIsSeenThere()
    {
        for (const bool perspective : {true, false}) {
            Camera camera = sample();
            camera.perspective = perspective;
            const Vec3 place(0.05, 0.01, 0.0);
            const std::optional<Pixel> pixel = camera.project(place, window);
            QVERIFY(pixel.has_value());
            QVERIFY(distanceToRay(camera.ray(*pixel, window), place) < 1e-9);
        }
    }

    void zoomKeepsWhatIsUnderTheCursor()
    {
        for (const bool perspective : {true, false}) {
            Camera camera = sample();
            camera.perspective = perspective;
            const Pixel cursor{630, 120};
            const Ray ray = camera.ray(cursor, window);
            const double along =
                (camera.target - ray.origin).dot(camera.towardsEye()) / ray.direction.dot(camera.towardsEye());
            const Vec3 place = ray.origin + along * ray.direction;
            camera.zoom(0.5, cursor, window);
            const std::optional<Pixel> after = camera.project(place, window);
            QVERIFY(std::hypot(after->x - cursor.x, after->y - cursor.y) < 1e-6);
        }
    }

    void panMovesTheTargetWithTheMouse()
    {
        Camera camera = sample();
        const Vec3 place = camera.target;
        camera.pan(30, -20, window);
        const std::optional<Pixel> pixel = camera.project(place, window);
        QVERIFY(std::abs(pixel->x - 430) < 1e-9);
        QVERIFY(std::abs(pixel->y - 280) < 1e-9);
    }

    void fitShowsEveryCorner()
    {
        const Box box(Vec3(-0.3, 0.1, 0), Vec3(0.1, 0.2, 0.05));
        for (const bool perspective : {true, false})
            for (double yaw = 0; yaw < 6; yaw += 0.5)
                for (double pitch = -1.5; pitch <= 1.5; pitch += 0.5) {
                    Camera camera;
                    camera.perspective = perspective;
                    camera.yaw = yaw;
                    camera.pitch = pitch;
                    camera.fit(box, window.aspect());
                    for (int c = 0; c < 8; ++c) {
                        const auto pixel = camera.project(box.corner(static_cast<Box::CornerType>(c)), window);
                        QVERIFY(pixel && pixel->x > 0 && pixel->x < window.width && pixel->y > 0 &&
                                pixel->y < window.height);
                    }
                }
    }

    /// The side that is short of room is filled to nine tenths, and the box lies in the middle of it, beside what lies on the view.
    void fitFillsTheFreeArea()
    {
        const Box boxes[] = {{Vec3(-0.3, 0.1, 0), Vec3(0.1, 0.2, 0.05)},
                             {Vec3(-0.02, -0.02, -0.02), Vec3(0.02, 0.02, 0.02)},
                             {Vec3(0, 0, 0), Vec3(0.01, 0.01, 0.5)}};
        const Vec3 directions[] = {{0, -1, 0}, {1, 0, 0},   {0, 0, 1},      {0, 1, 0},        {0, 0, -1},
                                   {1, -1, 1}, {-1, 2, -1}, {3, 0.5, -0.5}, {-0.1, -0.2, 4.0}};
        const Insets insets[] = {{}, {.left = 120, .bottom = 90}, {.top = 40, .right = 200}};
        for (const WindowSize& size : {window, WindowSize{500, 900}})
            for (const Insets& taken : insets)
                for (const Box& box : boxes)
                    for (const Vec3& direction : directions)
                        for (const bool perspective : {true, false}) {
                            Camera camera;
                            camera.perspective = perspective;
                            camera.lookFrom(direction);
                            camera.fit(box, size, taken);
                            Eigen::AlignedBox2d seen;
                            for (int c = 0; c < 8; ++c) {
                                const auto pixel = camera.project(box.corner(static_cast<Box::CornerType>(c)), size);
                                QVERIFY(pixel.has_value());
                                seen.extend(Eigen::Vector2d(pixel->x, pixel->y));
                            }
                            const Eigen::AlignedBox2d free(
                                Eigen::Vector2d(taken.left, taken.top),
                                Eigen::Vector2d(size.width - taken.right, size.height - taken.bottom));
                            QVERIFY(free.contains(seen));
                            const Eigen::Array2d share = seen.sizes().array() / free.sizes().array();
                            QVERIFY(share.maxCoeff() > 0.85 && share.maxCoeff() < 0.95);
                            Eigen::Index tight = 0;
                            share.maxCoeff(&tight);
                            QVERIFY(std::abs(seen.center()[tight] - free.center()[tight]) < 1e-6 * size.height);
                        }
    }

    void namedViewsKeepUpwardsUp()
    {
        Camera camera;
        camera.lookFrom({0, -1, 0});
        QVERIFY((camera.up() - Vec3::UnitZ()).norm() < 1e-12);
        QVERIFY((camera.right() - Vec3::UnitX()).norm() < 1e-12);
        camera.lookFrom({0, 0, 1});
        QVERIFY((camera.up() - Vec3::UnitY()).norm() < 1e-12);
        QVERIFY((camera.right() - Vec3::UnitX()).norm() < 1e-12);
    }

    void blendingTurnsTheShortWay()
    {
        Camera from = sample();
        Camera to = sample();
        from.yaw = 3.0;
        to.yaw = -3.0;
        QVERIFY(std::abs(blend(from, to, 0.5).yaw) > 3.0);
    }

    void theNearestAxisIsFound()
    {
        QCOMPARE(nearestAxis({0.2, -0.9, 0.4}, false), Vec3(-Vec3::UnitY()));
        QCOMPARE(nearestAxis({0.2, 0.1, 0.9}, true), Vec3(Vec3::UnitX()));
    }

    void arrowKeysFollowTheViewAndNeverShareAnAxis()
    {
        Camera camera;
        camera.lookFrom({0, -1, 0});
        QCOMPARE(keyDirection(Qt::Key_Right, camera), Vec3(Vec3::UnitX()));
        QCOMPARE(keyDirection(Qt::Key_Up, camera), Vec3(Vec3::UnitY()));
        camera.lookFrom({1, 0, 0});
        QCOMPARE(keyDirection(Qt::Key_Right, camera), Vec3(Vec3::UnitY()));
        QCOMPARE(keyDirection(Qt::Key_Up, camera), Vec3(-Vec3::UnitX()));
        for (camera.yaw = -3.14159265; camera.yaw < 3.2; camera.yaw += EIGEN_PI / 16) {
            const Vec3 right = keyDirection(Qt::Key_Right, camera);
            const Vec3 up = keyDirection(Qt::Key_Up, camera);
            QCOMPARE(right.dot(up), 0.0);
            QVERIFY(right.dot(camera.right()) > 0.7);
            QVERIFY(up.dot(camera.towardsEye()) < 0);
            QCOMPARE(keyDirection(Qt::Key_Left, camera), Vec3(-right));
        }
        QCOMPARE(keyDirection(Qt::Key_PageDown, camera), Vec3(-Vec3::UnitZ()));
        QVERIFY(keyDirection(Qt::Key_A, camera).isZero());
    }
};

QTEST_GUILESS_MAIN(CameraTest)
#include "camera_test.moc"
