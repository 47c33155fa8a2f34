#include "ui/project/project_view.h"

#include <QtTest>

#include <limits>
#include <numbers>

using namespace knead;

class ProjectViewTest : public QObject {
    Q_OBJECT
private slots:
    void aCameraComesBack_data()
    {
        QTest::addColumn<double>("yaw");
        QTest::addColumn<double>("pitch");
        constexpr double pi = std::numbers::pi;
        QTest::newRow("isometric") << -pi / 4 << 0.615480;
        QTest::newRow("from above") << -pi / 2 << pi / 2;
        QTest::newRow("from below") << 1.3 << -pi / 2;
        QTest::newRow("from behind") << pi * 0.999 << 0.0;
    }
    void aCameraComesBack()
    {
        QFETCH(double, yaw);
        QFETCH(double, pitch);
        for (const bool perspective : {false, true}) {
            const Camera camera{.target = Vec3(0.1, -0.2, 0.03),
                                .distance = 0.7,
                                .yaw = yaw,
                                .pitch = pitch,
                                .perspective = perspective};
            const Camera back = restored(kept(camera));
            QVERIFY((back.target - camera.target).norm() < 1e-15);
            QVERIFY((back.eye() - camera.eye()).norm() < 1e-12);
            QVERIFY((back.up() - camera.up()).norm() < 1e-12);
            QVERIFY(std::abs(back.viewHeight() - camera.viewHeight()) < 1e-12);
            QCOMPARE(back.perspective, perspective);
        }
    }

    void aCameraOfNoSenseLooksLikeANewOne()
    {
        ProjectCamera senseless = kept(Camera{});
        senseless.position = senseless.focalPoint;
        QCOMPARE(restored(senseless).distance, Camera{}.distance);
        senseless = kept(Camera{});
        senseless.position.x() = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(restored(senseless).distance, Camera{}.distance);
    }

    void aThumbnailIsSmall()
    {
        QImage view(1000, 900, QImage::Format_ARGB32);
        view.fill(Qt::red);
        const std::vector<std::byte> png = thumbnailOf(view);
        const QImage back =
            QImage::fromData(reinterpret_cast<const uchar*>(png.data()), static_cast<int>(png.size()), "PNG");
        QVERIFY(back.width() >= 320 && back.width() < 400 && back.height() < 300);
        QCOMPARE(back.pixelColor(5, 5), QColor(Qt::red));
    }
};

QTEST_MAIN(ProjectViewTest)
#include "project_view_test.moc"
