#include "core/model/readable_name.h"
#include "io/brep/occt_session.h"
#include "io/formats/cad_writer.h"
#include "io/importer.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <QTemporaryDir>
#include <QtTest>
#include <TopLoc_Location.hxx>
#include <gp_Trsf.hxx>

#include <fstream>

using namespace knead;

namespace {

TopoDS_Shape movedBy(const TopoDS_Shape& shape, double x)
{
    gp_Trsf aside;
    aside.SetTranslation(gp_Vec(x, 0, 0));
    return shape.Moved(TopLoc_Location(aside));
}

CadPartToWrite part(const TopoDS_Shape& shape, const std::string& name, std::optional<Color> color = {})
{
    CadPartToWrite result;
    result.shape = shape;
    result.name = name;
    result.color = color;
    return result;
}

PartNode leaf(const std::string& name, std::size_t number, const std::string& product = {},
              const std::string& partNumber = {})
{
    PartNode node{name, number, {}};
    node.product = product;
    node.partNumber = partNumber;
    return node;
}

/// Two bolts of one product and a remote of a lid and a base.
struct Machine {
    std::vector<CadPartToWrite> parts;
    PartNode tree{"machine", std::nullopt, {}};

    Machine()
    {
        const TopoDS_Shape bolt = BRepPrimAPI_MakeCylinder(2, 10).Shape();
        parts = {part(bolt, "left bolt"), part(movedBy(bolt, 40), "right bolt"),
                 part(BRepPrimAPI_MakeBox(10, 20, 3).Shape(), "lid", Color{1, 0, 0}),
                 part(movedBy(BRepPrimAPI_MakeBox(10, 20, 6).Shape(), 15), "base", Color{0, 0, 1})};
        PartNode remote{"remote:1", std::nullopt, {leaf("lid", 2), leaf("base", 3)}};
        remote.product = "remote";
        remote.partNumber = "4711-B";
        remote.holdsBodies = true;
        PartNode machine{
            "machine", std::nullopt, {leaf("left bolt", 0, "bolt", "P-100"), leaf("right bolt", 1, "bolt", "P-100")}};
        machine.children.push_back(remote);
        tree.children.push_back(machine);
    }
};

struct Written {
    std::string text;
    Model model;
};

Written written(const Machine& machine, FormatKind kind = FormatKind::Step)
{
    Written result;
    {
        const OcctSession session;
        result.text = writeCad(kind, machine.parts, machine.tree, {.unit = "mm"}, TaskControl::none());
    }
    QTemporaryDir folder;
    const std::string path = folder.filePath(kind == FormatKind::Step ? "machine.step" : "machine.igs").toStdString();
    std::ofstream(path, std::ios::binary) << result.text;
    result.model = importFile(path);
    return result;
}

int countOf(const std::string& text, const std::string& what)
{
    int count = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++count;
    return count;
}

void replaceAll(std::string& text, const std::string& from, const std::string& to)
{
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

} // namespace

class ProductNamesTest : public QObject {
    Q_OBJECT
private slots:
    void productsAndInstancesComeBack();
    void bodiesOfAProductAreOneProduct();
    void bentInstancesAreProductsOfTheirOwn();
    void stockNamesGiveWay_data();
    void stockNamesGiveWay();
    void bodiesWithoutNamesAreNumbered();
    void hiddenBodiesStayHidden();
    void oneBodyOfAProductKeepsItsName();
    void bodiesKeepTheirNamesInIges();
};

void ProductNamesTest::productsAndInstancesComeBack()
{
    const Written file = written(Machine());
    QCOMPARE(countOf(file.text, "PRODUCT('P-100','bolt'"), 1); // shared by both instances
    QCOMPARE(file.model.tree.children.size(), std::size_t{1});
    const std::vector<PartNode>& nodes = file.model.tree.children.front().children;
    QCOMPARE(nodes.size(), std::size_t{3});
    QCOMPARE(QString::fromStdString(nodes[0].name), "left bolt");
    QCOMPARE(QString::fromStdString(nodes[1].name), "right bolt");
    for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE(QString::fromStdString(nodes[i].product), "bolt");
        QCOMPARE(QString::fromStdString(nodes[i].partNumber), "P-100");
        QVERIFY(!nodes[i].holdsBodies);
    }
}

void ProductNamesTest::bodiesOfAProductAreOneProduct()
{
    const Written file = written(Machine());
    QCOMPARE(countOf(file.text, "PRODUCT('4711-B','remote'"), 1);
    QCOMPARE(countOf(file.text, "PRODUCT("), 3); // machine, bolt, remote
    QCOMPARE(countOf(file.text, "MANIFOLD_SOLID_BREP('lid'"), 1);
    const PartNode& remote = file.model.tree.children.front().children.at(2);
    QCOMPARE(QString::fromStdString(remote.name), "remote:1");
    QCOMPARE(QString::fromStdString(remote.product), "remote");
    QVERIFY(remote.holdsBodies);
    QCOMPARE(remote.children.size(), std::size_t{2});
    const Part& lid = file.model.parts.at(remote.children[0].part.value());
    const Part& base = file.model.parts.at(remote.children[1].part.value());
    QCOMPARE(QString::fromStdString(lid.name), "lid");
    QCOMPARE(QString::fromStdString(base.path), "machine/remote:1/base");
    QCOMPARE(QString::fromStdString(base.bodyOf), "remote:1 (2)");
    QVERIFY(std::abs(lid.volume - 600e-9) < 1e-14 && std::abs(base.volume - 1200e-9) < 1e-14);
    QVERIFY(std::abs(base.box.min().x() - 0.015) < 1e-6);
    QVERIFY(lid.color && std::abs(lid.color->r - 1) < 0.01 && lid.color->b < 0.01F);
    QVERIFY(base.color && std::abs(base.color->b - 1) < 0.01 && base.color->r < 0.01F);
}

/// Programs take products of one name for one product.
void ProductNamesTest::bentInstancesAreProductsOfTheirOwn()
{
    Machine machine;
    machine.parts[1].shape = BRepPrimAPI_MakeCylinder(2, 12).Shape();
    const Written file = written(machine);
    QCOMPARE(countOf(file.text, "PRODUCT('P-100','bolt'"), 1);
    QCOMPARE(countOf(file.text, "PRODUCT('right bolt','right bolt'"), 1);
    const std::vector<PartNode>& nodes = file.model.tree.children.front().children;
    QCOMPARE(QString::fromStdString(nodes[0].product), "bolt");
    QCOMPARE(QString::fromStdString(nodes[1].name), "right bolt");
    QVERIFY(nodes[1].product.empty() && nodes[1].partNumber.empty());
}

void ProductNamesTest::stockNamesGiveWay_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("product");
    QTest::addColumn<QString>("name");
    QTest::newRow("translator") << "Open CASCADE STEP translator 7.5 1"
                                << "Open CASCADE STEP translator 7.5 1"
                                << "knob";
    QTest::newRow("Rhino, document") << "Document"
                                     << "Document"
                                     << "knob";
    QTest::newRow("Rhino, product") << "8"
                                    << "Rhino Product"
                                    << "knob";
    QTest::newRow("number") << "17"
                            << "17"
                            << "knob";
    QTest::newRow("part number") << "10-4432-01"
                                 << "10-4432-01"
                                 << "10-4432-01";
    QTest::newRow("body") << "Body1"
                          << "Body1"
                          << "knob";
    QTest::newRow("uuid") << "3f2504e0-4f89-11d3-9a0c-0305e82c3301"
                          << "3f2504e0-4f89-11d3-9a0c-0305e82c3301"
                          << "knob";
    QTest::newRow("part number instead") << "K-12"
                                         << "Untitled"
                                         << "K-12";
    QTest::newRow("meant") << "Body"
                           << "Body"
                           << "Body";
    QTest::newRow("meant, with a number") << "M3x8"
                                          << "Screw 2"
                                          << "Screw 2";
}

void ProductNamesTest::stockNamesGiveWay()
{
    QFETCH(QString, id);
    QFETCH(QString, product);
    QFETCH(QString, name);
    Machine machine;
    machine.tree.children = {leaf("thing", 0)};
    std::string text;
    {
        const OcctSession session;
        text = writeCad(FormatKind::Step, machine.parts, machine.tree, {.unit = "mm"}, TaskControl::none());
    }
    replaceAll(text, "PRODUCT('thing','thing'", "PRODUCT('" + id.toStdString() + "','" + product.toStdString() + "'");
    QTemporaryDir folder;
    const std::string path = folder.filePath("knob.step").toStdString();
    std::ofstream(path, std::ios::binary) << text;
    QCOMPARE(QString::fromStdString(importFile(path).parts.front().name), name);
}

void ProductNamesTest::bodiesWithoutNamesAreNumbered()
{
    Machine machine;
    machine.parts[2].name = "Solid1";
    machine.parts[3].name = "NONE";
    const Written file = written(machine);
    const PartNode& remote = file.model.tree.children.front().children.at(2);
    QCOMPARE(QString::fromStdString(remote.children[0].name), "remote:1");
    QCOMPARE(QString::fromStdString(remote.children[1].name), "remote:1 (2)");
}

void ProductNamesTest::hiddenBodiesStayHidden()
{
    Machine machine;
    machine.parts[2].visible = false;
    const Written file = written(machine);
    QCOMPARE(file.model.parts.size(), std::size_t{4});
    for (const Part& part : file.model.parts)
        QCOMPARE(part.visible, part.name != "lid");
}

/// The others are not exported.
void ProductNamesTest::oneBodyOfAProductKeepsItsName()
{
    Machine machine;
    PartNode& nodes = machine.tree.children.front();
    nodes.children.back().children.pop_back();
    const Written file = written(machine);
    QCOMPARE(QString::fromStdString(file.model.parts.back().name), "lid");
    QCOMPARE(QString::fromStdString(file.model.parts.back().path), "machine/remote:1/lid");
    QCOMPARE(countOf(file.text, "PRODUCT('4711-B','remote'"), 1);
}

void ProductNamesTest::bodiesKeepTheirNamesInIges()
{
    const Written file = written(Machine(), FormatKind::Iges);
    QStringList names;
    for (const Part& part : file.model.parts)
        names << QString::fromStdString(part.name);
    names.sort();
    QCOMPARE(names, QStringList({"base", "left bolt", "lid", "right bolt"}));
}

QTEST_APPLESS_MAIN(ProductNamesTest)
#include "product_names_test.moc"
