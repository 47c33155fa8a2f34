#include "io/importer.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <IGESBasic_Group.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <QTemporaryDir>
#include <QtTest>
#include <TopoDS_Shape.hxx>

using namespace knead;

namespace {

/// Writes solids (186) so that each one, or all together, are in a group with all that they are made of.
void writeWithGroups(const std::string& path, const std::vector<TopoDS_Shape>& solids, bool asOneGroup)
{
    IGESControl_Writer writer("MM", 1); // 1: solids with shells and faces
    const Handle(IGESData_IGESModel) model = writer.Model();
    std::vector<Handle(IGESBasic_Group)> groups;
    int first = 0;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        writer.AddShape(solids[i]);
        if (asOneGroup && i + 1 < solids.size())
            continue;
        const Handle(IGESBasic_Group) group = new IGESBasic_Group(model->NbEntities() - first);
        for (int e = first + 1; e <= model->NbEntities(); ++e)
            group->SetValue(e - first, model->Entity(e));
        groups.push_back(group);
        first = model->NbEntities();
    }
    // A last one of entities that all are in others, too.
    const Handle(IGESBasic_Group) again = new IGESBasic_Group(model->NbEntities());
    for (int e = 1; e <= model->NbEntities(); ++e)
        again->SetValue(e, model->Entity(e));
    groups.push_back(again);
    for (const Handle(IGESBasic_Group) & group : groups)
        writer.AddEntity(group);
    writer.ComputeModel();
    QVERIFY(writer.Write(path.c_str()));
}

} // namespace

class IgesGroupsTest : public QObject {
    Q_OBJECT

private slots:
    void aGroupOfEverythingGivesEachBodyOnce_data();
    void aGroupOfEverythingGivesEachBodyOnce();
};

void IgesGroupsTest::aGroupOfEverythingGivesEachBodyOnce_data()
{
    QTest::addColumn<bool>("asOneGroup");
    QTest::newRow("a group for each body") << false;
    QTest::newRow("one group for all") << true;
}

void IgesGroupsTest::aGroupOfEverythingGivesEachBodyOnce()
{
    QFETCH(bool, asOneGroup);
    const QTemporaryDir folder;
    const std::string path = folder.filePath("groups.igs").toStdString();
    writeWithGroups(path,
                    {BRepPrimAPI_MakeBox(10, 20, 30).Shape(),
                     BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(50, 0, 0), gp_Dir(0, 0, 1)), 5, 12).Shape()},
                    asOneGroup);
    const Model model = importFile(path);
    QCOMPARE(model.parts.size(), 2U);
    double volume = 0;
    for (const Part& part : model.parts) {
        QVERIFY(part.canBeFilled());
        volume += part.volume;
    }
    const double expected = 6e-6 + 3.14159265 * 25 * 12e-9;
    QVERIFY2(std::abs(volume / expected - 1) < 1e-3, std::to_string(volume * 1e9).c_str());
}

QTEST_APPLESS_MAIN(IgesGroupsTest)
#include "iges_groups_test.moc"
