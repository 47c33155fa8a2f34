#include "io/brep/moved_parts.h"

#include "core/message/message.h"
#include "io/brep/exact_shapes.h"
#include "io/importer.h"

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>

#include <QtTest>

using namespace knead;

/// Parts that are read as if their files had them elsewhere.
class MovedPartsTest : public QObject {
    Q_OBJECT

    static Box exactBox(const TopoDS_Shape& shape)
    {
        Bnd_Box box;
        BRepBndLib::AddOptimal(shape, box, false, false);
        Vec3 low;
        Vec3 high;
        box.Get(low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
        return {low, high};
    }

private slots:
    void allOfAPartGoesTheSameWay_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::newRow("as stated") << "";
        QTest::newRow("inch") << "inch";
    }

    void allOfAPartGoesTheSameWay()
    {
        QFETCH(QString, unit);
        const std::string file = KNEAD_RESOURCES "/examples/bracket.step";
        ImportOptions options{.unit = unit.toStdString()};
        const Part before = importFile(file, options).parts.at(0);
        options.shift = Vec3(0.125, -0.03, 0.007); // [m]
        const Part after = importFile(file, options).parts.at(0);
        QVERIFY((after.box.min() - before.box.min() - options.shift).norm() < 1e-12);
        QCOMPARE(after.mesh.vertices.size(), before.mesh.vertices.size());
        for (std::size_t i = 0; i < after.mesh.vertices.size(); i += 11)
            QVERIFY((after.mesh.vertices[i] - before.mesh.vertices[i] - options.shift).norm() < 1e-12);
        const TopoDS_Shape there = shapesFromBytes(*after.exact->bytes).at(after.exact->number);
        const TopoDS_Shape here = shapesFromBytes(*before.exact->bytes).at(before.exact->number);
        const Vec3 way = (exactBox(there).center() - exactBox(here).center()) * after.exact->unit;
        QVERIFY((way - options.shift).norm() < 1e-8);
        GProp_GProps now;
        GProp_GProps then;
        BRepGProp::VolumeProperties(there, now);
        BRepGProp::VolumeProperties(here, then);
        QVERIFY(std::abs(now.Mass() / then.Mass() - 1) < 1e-9);
    }

    void noiseIsASentence()
    {
        Model model;
        model.parts.emplace_back().exact = ExactShape{std::make_shared<const std::string>("no shapes"), 0, 1e-3};
        QVERIFY_EXCEPTION_THROWN(moveParts(model, Vec3::UnitX()), Problem);
    }
};

QTEST_GUILESS_MAIN(MovedPartsTest)
#include "moved_parts_test.moc"
