#include "support/hard_shapes.h"

#include "core/geometry/mass_properties.h"
#include "io/importer.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Writer.hxx>
#include <QTemporaryDir>
#include <QtTest>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>

#include <algorithm>

using namespace knead;

// Every solid that is closed and valid is imported so that it can be filled, and measured within a thousandth, whatever its
// faces are.

namespace {

double volumeOf(const TopoDS_Shape& shape)
{
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties, 1e-6);
    return std::abs(properties.Mass());
}

std::string wordsOf(const Model& model)
{
    std::string words;
    for (const Part& part : model.parts)
        for (const auto& warning : part.warnings)
            words += warning.english() + " ";
    for (const auto& missing : model.missing)
        words += missing.english() + " ";
    return words;
}

} // namespace

class HardShapesTest : public QObject {
    Q_OBJECT

private slots:
    void solidsAreImportedWhole_data();
    void solidsAreImportedWhole();

private:
    QTemporaryDir m_folder;
};

void HardShapesTest::solidsAreImportedWhole_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<bool>("asIges");
    const auto shapes = hard_shapes::all();
    for (std::size_t i = 0; i < shapes.size(); ++i)
        for (const bool asIges : {false, true})
            if (!asIges || i % 4 == 0)
                QTest::addRow("%s, %s", shapes[i].name.c_str(), asIges ? "IGES" : "STEP")
                    << static_cast<int>(i) << asIges;
}

void HardShapesTest::solidsAreImportedWhole()
{
    QFETCH(int, number);
    QFETCH(bool, asIges);
    const hard_shapes::HardShape wanted = hard_shapes::all()[static_cast<std::size_t>(number)];
    TopoDS_Shape shape;
    try {
        shape = wanted.make();
    } catch (const Standard_Failure& failure) {
        QFAIL(failure.DynamicType()->Name());
    }
    QVERIFY(BRepCheck_Analyzer(shape).IsValid());
    const double volume = wanted.volume > 0 ? wanted.volume : volumeOf(shape);
    const std::string path = m_folder.filePath(asIges ? "shape.igs" : "shape.step").toStdString();
    if (asIges) {
        IGESControl_Writer writer("MM", 1);
        QVERIFY(writer.AddShape(shape));
        writer.ComputeModel();
        QVERIFY(writer.Write(path.c_str()));
    } else {
        STEPControl_Writer writer;
        QCOMPARE(writer.Transfer(shape, STEPControl_AsIs), IFSelect_RetDone);
        QCOMPARE(writer.Write(path.c_str()), IFSelect_RetDone);
    }

    Model model;
    try {
        model = importFile(path);
    } catch (const std::runtime_error& error) {
        QFAIL(error.what());
    }
    QVERIFY2(model.parts.size() == 1, wordsOf(model).c_str());
    const Part& part = model.parts.front();
    QVERIFY2(part.canBeFilled(), wordsOf(model).c_str());
    QVERIFY(isWatertight(part.mesh));
    const double error = part.volume * 1e9 / volume - 1;
    QVERIFY2(std::abs(error) < 1e-3,
             (std::to_string(error) + " of " + std::to_string(volume) + " " + wordsOf(model)).c_str());
    const double ofMesh = massProperties(part.mesh).volume * 1e9 / volume - 1;
    QVERIFY2(std::abs(ofMesh) < 1e-3, (std::to_string(ofMesh) + " of the triangles " + wordsOf(model)).c_str());
}

QTEST_GUILESS_MAIN(HardShapesTest)
#include "hard_shapes_test.moc"
