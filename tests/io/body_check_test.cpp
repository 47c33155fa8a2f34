#include "io/brep/body_check.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <QtTest>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Trsf.hxx>

using namespace knead;

namespace {

CadBody boxBody(double size)
{
    const TopoDS_Shape shape = BRepPrimAPI_MakeBox(size, size, size).Shape();
    return {.shape = shape, .original = shape};
}

/// A corner lies off the edges and faces that meet there.
CadBody sickBody()
{
    CadBody body = boxBody(10);
    const TopoDS_Vertex corner = TopoDS::Vertex(TopExp_Explorer(body.shape, TopAbs_VERTEX).Current());
    BRep_Builder().UpdateVertex(corner, BRep_Tool::Pnt(corner).Translated({1e-3, 1e-3, 1e-3}), 1e-7);
    return body;
}

CadBody atAnotherPlace(const CadBody& body)
{
    gp_Trsf shift;
    shift.SetTranslation({50, 0, 0});
    CadBody result = body;
    result.shape.Move(shift);
    return result;
}

class CancelledControl final : public TaskControl {
public:
    void report(double, std::string_view) override {}
    bool isCancelled() const override { return true; }
};

} // namespace

class BodyCheckTest : public QObject {
    Q_OBJECT

private slots:
    void eachBodyGetsTheVerdictOfItsShape();
    void cancelStops();
};

void BodyCheckTest::eachBodyGetsTheVerdictOfItsShape()
{
    std::vector<CadBody> bodies;
    for (int i = 0; i < 20; ++i)
        bodies.push_back(boxBody(1 + i));
    bodies.push_back(sickBody());
    bodies.push_back(atAnotherPlace(bodies.front()));
    bodies.push_back(atAnotherPlace(bodies[20]));
    std::vector<CadBody*> all;
    for (CadBody& body : bodies)
        all.push_back(&body);
    checkBodies(all, TaskControl::none());
    for (std::size_t i = 0; i < 20; ++i)
        QVERIFY(bodies[i].isValid && *bodies[i].isValid && !bodies[i].failure);
    QVERIFY(bodies[20].isValid && !*bodies[20].isValid);
    QVERIFY(bodies[20].failure && !bodies[20].failure->IsValid());
    QVERIFY(bodies[21].isValid && *bodies[21].isValid);
    QVERIFY(!bodies[22].isValid || !*bodies[22].isValid);
}

void BodyCheckTest::cancelStops()
{
    CadBody body = boxBody(1);
    CancelledControl control;
    QVERIFY_THROWS_EXCEPTION(Cancelled, checkBodies({&body}, control));
}

QTEST_GUILESS_MAIN(BodyCheckTest)
#include "body_check_test.moc"
