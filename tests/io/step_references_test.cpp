#include "io/importer.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <QTemporaryDir>
#include <QtTest>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <fstream>

using namespace knead;

namespace {

/// Writes machine.stp, of a plate and two pins that are in files beside it, part_plate.stp and part_pin.stp.
void writeMachine(const QString& folder)
{
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const TDF_Label machine = shapes->NewShape();
    const TDF_Label plate = shapes->AddShape(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), false);
    const TDF_Label pin = shapes->AddShape(BRepPrimAPI_MakeCylinder(5, 40).Shape(), false);
    TDataStd_Name::Set(machine, "machine");
    TDataStd_Name::Set(plate, "plate");
    TDataStd_Name::Set(pin, "pin");
    gp_Trsf up;
    up.SetTranslation(gp_Vec(0, 0, 50));
    gp_Trsf aside;
    aside.SetTranslation(gp_Vec(40, 0, 0));
    shapes->AddComponent(machine, plate, TopLoc_Location());
    shapes->AddComponent(machine, pin, TopLoc_Location(up));
    shapes->AddComponent(machine, pin, TopLoc_Location(aside));
    shapes->UpdateAssemblies();
    STEPCAFControl_Writer writer;
    writer.SetNameMode(true);
    const QString before = QDir::currentPath();
    QVERIFY(QDir::setCurrent(folder)); // the other files go to where one is
    const bool isWritten =
        writer.Transfer(document, STEPControl_AsIs, "part_") && writer.Write("machine.stp") == IFSelect_RetDone;
    QVERIFY(QDir::setCurrent(before));
    QVERIFY(isWritten);
}

std::string refusalOf(const std::string& path)
{
    try {
        importFile(path);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

} // namespace

class StepReferencesTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void filesBesideAnAssemblyAreReadWithIt();
    void missingFilesAreNamed();
    void damagedFilesAreNamed();
    void filesOfCurvesOrTrianglesSaySo_data();
    void filesOfCurvesOrTrianglesSaySo();

private:
    std::string path(const char* name) const { return m_folder->filePath(name).toStdString(); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void StepReferencesTest::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    writeMachine(m_folder->path());
}

void StepReferencesTest::filesBesideAnAssemblyAreReadWithIt()
{
    const Model model = importFile(path("machine.stp"));
    QCOMPARE(model.parts.size(), 3U);
    QVERIFY(model.missing.empty());
    double volume = 0;
    for (const Part& part : model.parts)
        volume += part.volume;
    QVERIFY(std::abs(volume * 1e9 - 6000 - 2 * 3.14159265 * 1000) < 1);
    QCOMPARE(model.parts[0].path, std::string("machine/plate"));
}

void StepReferencesTest::missingFilesAreNamed()
{
    QVERIFY(QFile::remove(m_folder->filePath("part_plate.stp")));
    const Model model = importFile(path("machine.stp"));
    QCOMPARE(model.parts.size(), 2U);
    QCOMPARE(model.missing.size(), 1U);
    QVERIFY(model.missing.front().english().find("the file part_plate.stp, which is not there") != std::string::npos);

    QVERIFY(QFile::remove(m_folder->filePath("part_pin.stp")));
    const std::string refusal = refusalOf(path("machine.stp"));
    QVERIFY2(refusal.find("2 files that are not there: part_pin.stp, part_plate.stp") != std::string::npos,
             refusal.c_str());
}

void StepReferencesTest::damagedFilesAreNamed()
{
    QFile file(m_folder->filePath("part_pin.stp"));
    QVERIFY(file.resize(file.size() / 2));
    const std::string refusal = refusalOf(path("machine.stp"));
    QVERIFY2(refusal.starts_with("part_pin.stp: ") && refusal.find("cut off") != std::string::npos, refusal.c_str());
}

void StepReferencesTest::filesOfCurvesOrTrianglesSaySo_data()
{
    QTest::addColumn<QByteArray>("entities");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("curves") << QByteArray("#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=GEOMETRIC_CURVE_SET('',(#1));\n")
                            << QByteArray("curves and points only");
    QTest::newRow("triangles") << QByteArray("#1=COORDINATES_LIST('',3,((0.,0.,0.),(1.,0.,0.),(0.,1.,0.)));\n"
                                             "#2=TRIANGULATED_FACE('',#1,3,((0.,0.,1.)),$,(),((1,2,3)));\n")
                               << QByteArray("triangles only");
}

void StepReferencesTest::filesOfCurvesOrTrianglesSaySo()
{
    QFETCH(QByteArray, entities);
    QFETCH(QByteArray, words);
    std::ofstream(path("other.stp")) << "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
                                        "FILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\n"
                                        "ENDSEC;\nDATA;\n"
                                     << entities.toStdString() << "ENDSEC;\nEND-ISO-10303-21;\n";
    const std::string refusal = refusalOf(path("other.stp"));
    QVERIFY2(refusal.find(words.toStdString()) != std::string::npos, refusal.c_str());
}

QTEST_GUILESS_MAIN(StepReferencesTest)
#include "step_references_test.moc"
