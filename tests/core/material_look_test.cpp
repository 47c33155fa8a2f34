#include "core/session/material_look.h"

#include <QtTest>

using namespace knead;

/// What materials look like by their numbers, which are those of resources/materials.
class MaterialLookTest : public QObject {
    Q_OBJECT
private slots:
    void numbersTellTheLook_data()
    {
        QTest::addColumn<double>("density");
        QTest::addColumn<double>("youngsModulus");
        QTest::addColumn<double>("yieldStress");
        QTest::addColumn<double>("rubberlike");
        QTest::addColumn<int>("look");
        const auto row = [](const char* name, double density, double modulus, double yieldStress, double rubberlike,
                            MaterialLook look) {
            QTest::newRow(name) << density << modulus << yieldStress << rubberlike << static_cast<int>(look);
        };
        row("jelly", 1020, 3e3, 0, 0, MaterialLook::plain);
        row("soft foam", 40, 6e4, 0, 0, MaterialLook::plain);
        row("rigid foam", 60, 1.5e7, 5e5, 0, MaterialLook::plain);
        row("sponge rubber", 600, 2e5, 0, 0, MaterialLook::rubber);
        row("natural rubber", 950, 1e6, 0, 1, MaterialLook::rubber);
        row("TPU 95A", 1220, 2.6e7, 0, 1, MaterialLook::rubber);
        row("water clay", 1850, 2.5e5, 5e3, 0, MaterialLook::clay);
        row("plasticine", 1850, 2e6, 7.5e4, 0, MaterialLook::clay);
        row("oil clay", 1750, 5e6, 1.5e5, 0, MaterialLook::clay);
        row("wax", 900, 1.5e8, 2e6, 0, MaterialLook::plastic);
        row("ABS", 1050, 2.2e9, 4e7, 0, MaterialLook::plastic);
        row("PLA", 1240, 3.3e9, 5.2e7, 0, MaterialLook::plastic);
        row("wood", 450, 1.1e10, 0, 0, MaterialLook::wood);
        row("glass", 2500, 7e10, 0, 0, MaterialLook::plastic);
        row("aluminum", 2700, 6.9e10, 2.76e8, 0, MaterialLook::metal);
        row("steel", 7850, 2.1e11, 2.5e8, 0, MaterialLook::metal);
        row("steel that never yields", 7850, 2.1e11, 0, 0, MaterialLook::metal);
    }

    void numbersTellTheLook()
    {
        QFETCH(double, density);
        QFETCH(double, youngsModulus);
        QFETCH(double, yieldStress);
        QFETCH(double, rubberlike);
        QFETCH(int, look);
        Material material;
        material.density = density;
        material.youngsModulus = youngsModulus;
        material.yieldStress = yieldStress;
        material.rubberlike = rubberlike;
        QCOMPARE(static_cast<int>(materialLook(material)), look);
    }

    void colorsAreForPartsThatHaveNone()
    {
        const auto rubber = usualColor(MaterialLook::rubber);
        const auto clay = usualColor(MaterialLook::clay);
        QVERIFY(rubber && rubber->r < 0.5F && rubber->g < 0.5F && rubber->b < 0.5F); // dark
        QVERIFY(clay && clay->r > clay->g && clay->g > clay->b);                     // warm
        QVERIFY(!usualColor(MaterialLook::plain));
        Part part;
        part.faces.resize(3);
        QVERIFY(!hasOwnColor(part));
        part.faces[2].color = Color{1, 0, 0};
        QVERIFY(hasOwnColor(part)); // of a single face
        part.faces.clear();
        part.color = Color{};
        QVERIFY(hasOwnColor(part));
    }
};

QTEST_GUILESS_MAIN(MaterialLookTest)
#include "material_look_test.moc"
