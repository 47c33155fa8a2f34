#include "io/importer.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Trsf.hxx>

#include <QtTest>

#include <fstream>
#include <numbers>

using namespace knead;

namespace {

constexpr Color red{1, 0, 0};
constexpr Color green{0, 1, 0};
constexpr Color blue{0, 0, 1};
constexpr Color odd{0.2F, 0.4F, 0.6F}; // none of the numbered colors of IGES

Quantity_Color toOcct(const Color& color)
{
    return {color.r, color.g, color.b, Quantity_TOC_sRGB};
}

bool isSame(const std::optional<Color>& color, const Color& expected)
{
    return color && std::abs(color->r - expected.r) < 0.005F && std::abs(color->g - expected.g) < 0.005F &&
           std::abs(color->b - expected.b) < 0.005F;
}

TopLoc_Location place(double x, double y, double z, double turnAboutZ = 0)
{
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), turnAboutZ);
    gp_Trsf move;
    move.SetTranslation(gp_Vec(x, y, z));
    return {move * turn};
}

/// A CAD document to fill and to write.
class Drawing {
public:
    Drawing() { XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", m_document); }
    ~Drawing() { XCAFApp_Application::GetApplication()->Close(m_document); }
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    Handle(XCAFDoc_ShapeTool) shapes() const { return XCAFDoc_DocumentTool::ShapeTool(m_document->Main()); }
    Handle(XCAFDoc_ColorTool) colors() const { return XCAFDoc_DocumentTool::ColorTool(m_document->Main()); }
    Handle(XCAFDoc_LayerTool) layers() const { return XCAFDoc_DocumentTool::LayerTool(m_document->Main()); }

    TDF_Label add(const TopoDS_Shape& shape, const char* name) const
    {
        return named(shapes()->AddShape(shape, false), name);
    }
    TDF_Label addAssembly(const char* name) const { return named(shapes()->NewShape(), name); }
    TDF_Label place(const TDF_Label& assembly, const TDF_Label& product, const TopLoc_Location& where,
                    const char* name) const
    {
        return named(shapes()->AddComponent(assembly, product, where), name);
    }
    void paint(const TDF_Label& label, const Color& color) const
    {
        colors()->SetColor(label, toOcct(color), XCAFDoc_ColorGen);
    }
    void paintFirstFace(const TDF_Label& product, const Color& color) const
    {
        const TopExp_Explorer faces(XCAFDoc_ShapeTool::GetShape(product), TopAbs_FACE);
        colors()->SetColor(shapes()->AddSubShape(product, faces.Current()), toOcct(color), XCAFDoc_ColorSurf);
    }
    void hide(const TDF_Label& label) const { colors()->SetVisibility(label, false); }
    void putOnLayer(const TDF_Label& label, const char* layer) const
    {
        layers()->SetLayer(label, TCollection_ExtendedString(layer, true));
    }

    void writeStep(const std::string& path) const
    {
        shapes()->UpdateAssemblies();
        STEPCAFControl_Writer writer;
        writer.SetColorMode(true);
        writer.SetNameMode(true);
        writer.SetLayerMode(true);
        QVERIFY(writer.Transfer(m_document));
        QCOMPARE(writer.Write(path.c_str()), IFSelect_RetDone);
    }

    void writeIges(const std::string& path) const
    {
        IGESCAFControl_Writer writer;
        writer.SetColorMode(true);
        writer.SetNameMode(true);
        writer.SetLayerMode(true);
        QVERIFY(writer.Transfer(m_document));
        QVERIFY(writer.Write(path.c_str()));
    }

private:
    static TDF_Label named(const TDF_Label& label, const char* name)
    {
        TDataStd_Name::Set(label, TCollection_ExtendedString(name, true));
        return label;
    }

    Handle(TDocStd_Document) m_document;
};

TopoDS_Shape box()
{
    return BRepPrimAPI_MakeBox(10, 20, 30).Shape();
}

TopoDS_Shape cylinder()
{
    return BRepPrimAPI_MakeCylinder(5, 40).Shape();
}

const Part& partAt(const Model& model, const std::string& path)
{
    for (const Part& part : model.parts)
        if (part.path == path)
            return part;
    std::string all = "no part " + path + ", but";
    for (const Part& part : model.parts)
        all += "\n" + part.path;
    throw std::runtime_error(all);
}

std::size_t paintedFaces(const Part& part, const Color& color)
{
    return static_cast<std::size_t>(std::count_if(part.faces.begin(), part.faces.end(),
                                                  [&](const PartFace& face) { return isSame(face.color, color); }));
}

std::string contentOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

constexpr std::size_t lineLength = 81; // of an IGES file, with its end

/// Calls for each trimmed surface (entity 144) of an IGES file with its place in the directory and its number.
template <typename Change>
void changeTrimmedSurfaces(const std::string& path, Change change)
{
    std::string text = contentOf(path);
    int surface = 0;
    for (std::size_t line = 0; line + 2 * lineLength <= text.size(); line += lineLength)
        if (text[line + 72] == 'D' && text.compare(line, 8, "     144") == 0 && (text[line + 79] - '0') % 2 == 1)
            change(text, line, surface++);
    std::ofstream(path) << text;
}

} // namespace

class NothingLostTest : public QObject {
    Q_OBJECT

private slots:
    void stepKeepsNamesOfAnyScript();
    void stepKeepsNestedPlacements();
    void stepKeepsColorsDownToFaces();
    void stepKeepsColorsOfSolidsInOneProduct();
    void stepKeepsLayers();
    void stepKeepsWhatIsHidden();
    void igesKeepsNamesColorsAndLevels();
    void igesKeepsColorNumbers();
    void igesKeepsWhatIsBlanked();
    void igesNamesMayBeUtf8();
    void onlyWantedPartsAreRead();
    void escapedNamesAreReadable_data();
    void escapedNamesAreReadable();

private:
    std::string file(const std::string& name) const { return m_folder.path().toStdString() + "/" + name; }
    Model throughStep(const Drawing& drawing) const
    {
        drawing.writeStep(file("drawing.step"));
        return importFile(file("drawing.step"));
    }

    QTemporaryDir m_folder;
};

void NothingLostTest::stepKeepsNamesOfAnyScript()
{
    const Drawing drawing;
    const TDF_Label root = drawing.addAssembly("Прибор");
    const TDF_Label bolt = drawing.add(cylinder(), "ボルト");
    drawing.place(root, bolt, place(0, 0, 0), "Schraube für Deckel");
    drawing.place(root, bolt, place(50, 0, 0), "螺栓 🔩");
    const Model model = throughStep(drawing);
    QCOMPARE(model.parts.size(), std::size_t(2));
    QCOMPARE(model.parts[0].path, std::string("Прибор/Schraube für Deckel"));
    QCOMPARE(model.parts[1].path, std::string("Прибор/螺栓 🔩"));
}

void NothingLostTest::stepKeepsNestedPlacements()
{
    const Drawing drawing;
    const TDF_Label root = drawing.addAssembly("machine");
    const TDF_Label group = drawing.addAssembly("group");
    const TDF_Label block = drawing.add(box(), "block");
    drawing.place(group, block, place(100, 0, 0, std::numbers::pi / 2), "turned");
    drawing.place(root, group, place(0, 0, 1000, std::numbers::pi / 2), "left group");
    drawing.place(root, group, place(0, 0, 2000), "right group");
    const Model model = throughStep(drawing);
    QCOMPARE(model.parts.size(), std::size_t(2));
    // Turned by half a turn in all; the corner at (100, 0, 0) goes to (0, 100, 1000).
    const Box left = partAt(model, "machine/left group/turned").box;
    QVERIFY((left.min() - Vec3(-0.01, 0.08, 1)).norm() < 1e-9);
    QVERIFY((left.max() - Vec3(0, 0.1, 1.03)).norm() < 1e-9);
    const Box right = partAt(model, "machine/right group/turned").box;
    QVERIFY((right.min() - Vec3(0.08, 0, 2)).norm() < 1e-9);
    QVERIFY((right.max() - Vec3(0.1, 0.01, 2.03)).norm() < 1e-9);
}

void NothingLostTest::stepKeepsColorsDownToFaces()
{
    const Drawing drawing;
    const TDF_Label root = drawing.addAssembly("machine");
    const TDF_Label block = drawing.add(box(), "block");
    drawing.paint(block, red);
    drawing.paintFirstFace(block, green);
    const TDF_Label bolt = drawing.add(cylinder(), "bolt");
    drawing.paint(bolt, blue);
    drawing.place(root, block, place(0, 0, 0), "first");
    drawing.place(root, bolt, place(100, 0, 0), "second");
    drawing.paint(drawing.place(root, bolt, place(200, 0, 0), "third"), green);
    const Model model = throughStep(drawing);
    const Part& first = partAt(model, "machine/first");
    QVERIFY(isSame(first.color, red));
    QCOMPARE(paintedFaces(first, green), std::size_t(1));
    QVERIFY(isSame(partAt(model, "machine/second").color, blue));
    QVERIFY(isSame(partAt(model, "machine/third").color, green));
}

void NothingLostTest::stepKeepsColorsOfSolidsInOneProduct()
{
    TopoDS_Compound both;
    const BRep_Builder builder;
    builder.MakeCompound(both);
    const TopoDS_Shape first = box();
    const TopoDS_Shape second = cylinder().Moved(place(100, 0, 0));
    builder.Add(both, first);
    builder.Add(both, second);
    const Drawing drawing;
    const TDF_Label product = drawing.add(both, "pair");
    drawing.paint(drawing.shapes()->AddSubShape(product, first), odd);
    drawing.paint(drawing.shapes()->AddSubShape(product, second), blue);
    const Model model = throughStep(drawing);
    QCOMPARE(model.parts.size(), std::size_t(2));
    QVERIFY(isSame(model.parts[0].color, odd));
    QVERIFY(isSame(model.parts[1].color, blue));
}

void NothingLostTest::stepKeepsLayers()
{
    const Drawing drawing;
    const TDF_Label root = drawing.addAssembly("machine");
    const TDF_Label block = drawing.add(box(), "block");
    const TDF_Label bolt = drawing.add(cylinder(), "bolt");
    drawing.putOnLayer(block, "Gehäuse");
    drawing.putOnLayer(bolt, "层");
    drawing.place(root, block, place(0, 0, 0), "first");
    drawing.place(root, bolt, place(100, 0, 0), "second");
    drawing.place(root, drawing.add(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "guard"), place(200, 0, 0), "third");
    const Model model = throughStep(drawing);
    QCOMPARE(partAt(model, "machine/first").layer, std::string("Gehäuse"));
    QCOMPARE(partAt(model, "machine/second").layer, std::string("层"));
    QCOMPARE(partAt(model, "machine/third").layer, std::string());
}

void NothingLostTest::stepKeepsWhatIsHidden()
{
    const Drawing drawing;
    const TDF_Label root = drawing.addAssembly("machine");
    const TDF_Label block = drawing.add(box(), "block");
    const TDF_Label bolt = drawing.add(cylinder(), "bolt");
    const TDF_Label guard = drawing.add(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "guard");
    drawing.place(root, block, place(0, 0, 0), "first");
    const TDF_Label again = drawing.place(root, block, place(50, 0, 0), "again");
    drawing.paint(again, red); // the writer crashes on an instance that is hidden and has no color
    drawing.hide(again);
    drawing.place(root, bolt, place(100, 0, 0), "second");
    drawing.place(root, guard, place(200, 0, 0), "third");
    drawing.hide(bolt);
    drawing.putOnLayer(guard, "construction");
    TDF_Label layer;
    QVERIFY(drawing.layers()->FindLayer("construction", layer));
    drawing.layers()->SetVisibility(layer, false);
    const Model model = throughStep(drawing);
    QVERIFY(partAt(model, "machine/first").visible);
    QVERIFY(!partAt(model, "machine/again").visible);
    QVERIFY(!partAt(model, "machine/second").visible);
    QVERIFY(!partAt(model, "machine/third").visible);
}

void NothingLostTest::igesKeepsNamesColorsAndLevels()
{
    const Drawing drawing;
    const TDF_Label block = drawing.add(box(), "BLOCK");
    drawing.paint(block, odd);
    drawing.putOnLayer(block, "7");
    drawing.writeIges(file("drawing.igs"));
    const Model model = importFile(file("drawing.igs"));
    QCOMPARE(model.parts.size(), std::size_t(1));
    const Part& part = model.parts.front();
    QCOMPARE(part.name, std::string("BLOCK"));
    QCOMPARE(part.layer, std::string("7"));
    QVERIFY(isSame(part.color, odd));
}

void NothingLostTest::igesKeepsColorNumbers()
{
    const Drawing drawing;
    drawing.add(box(), "BLOCK");
    drawing.writeIges(file("numbered.igs"));
    // The color is the third field of the second line; 2 is red, 3 green, 4 blue (IGES 5.3, section 2.2.4.4.13).
    changeTrimmedSurfaces(file("numbered.igs"), [](std::string& text, std::size_t entry, int surface) {
        if (surface < 3)
            text.replace(entry + lineLength + 16, 8, "       " + std::to_string(2 + surface));
    });
    const Part part = importFile(file("numbered.igs")).parts.front();
    QCOMPARE(part.faces.size(), std::size_t(6));
    for (const Color& color : {red, green, blue})
        QCOMPARE(paintedFaces(part, color), std::size_t(1));
}

void NothingLostTest::igesKeepsWhatIsBlanked()
{
    const Drawing drawing;
    drawing.add(box(), "BLOCK");
    // Columns 65 and 66 of the first directory line of an entity are its blank status.
    const auto blank = [](std::string& text, std::size_t entry, int) { text.replace(entry + 64, 2, "01"); };
    drawing.writeIges(file("blanked.igs"));
    changeTrimmedSurfaces(file("blanked.igs"), blank);
    const Model hidden = importFile(file("blanked.igs"));
    QCOMPARE(hidden.parts.size(), std::size_t(1));
    QVERIFY(!hidden.parts.front().visible);

    drawing.writeIges(file("partly.igs"));
    changeTrimmedSurfaces(file("partly.igs"), [&](std::string& text, std::size_t entry, int surface) {
        if (surface < 2)
            blank(text, entry, surface);
    });
    const Model partly = importFile(file("partly.igs"));
    QCOMPARE(partly.parts.size(), std::size_t(2));
    QVERIFY(partly.parts[0].visible && !partly.parts[1].visible);
    QCOMPARE(partly.parts[0].faces.size(), std::size_t(4));
    QCOMPARE(partly.parts[1].faces.size(), std::size_t(2));
}

void NothingLostTest::igesNamesMayBeUtf8()
{
    const Drawing drawing;
    drawing.add(box(), "BLOCK");
    drawing.writeIges(file("named.igs"));
    std::string text = contentOf(file("named.igs"));
    for (std::size_t at = text.find("BLOCK"); at != std::string::npos; at = text.find("BLOCK", at))
        text.replace(at, 5,
                     "B\xC3\xBC"
                     "ck");
    std::ofstream(file("named.igs")) << text;
    QCOMPARE(importFile(file("named.igs")).parts.front().name, std::string("Bück"));
}

void NothingLostTest::onlyWantedPartsAreRead()
{
    const Drawing drawing;
    const TDF_Label root = drawing.addAssembly("machine");
    const TDF_Label group = drawing.addAssembly("group");
    const TDF_Label block = drawing.add(box(), "block");
    drawing.place(group, block, place(0, 0, 0), "one");
    drawing.place(group, block, place(50, 0, 0), "two");
    drawing.place(root, group, place(0, 0, 0), "left");
    drawing.place(root, group, place(0, 0, 100), "left side");
    drawing.writeStep(file("machine.step"));

    const Model one = importFile(file("machine.step"), {.parts = {"machine/left side/two"}});
    QCOMPARE(one.parts.size(), std::size_t(1));
    QCOMPARE(one.parts[0].path, std::string("machine/left side/two"));
    QVERIFY((one.parts[0].box.min() - Vec3(0.05, 0, 0.1)).norm() < 1e-9);
    QVERIFY(one.missing.empty());
    QCOMPARE(one.tree.children[0].children.size(), std::size_t(1));
    QCOMPARE(*one.tree.children[0].children[0].children[0].part, std::size_t(0));

    const Model left = importFile(file("machine.step"), {.parts = {"machine/left"}});
    QCOMPARE(left.parts.size(), std::size_t(2)); // and not those of "left side"
    try {
        importFile(file("machine.step"), {.parts = {"machine/left", "machine/right"}});
        QFAIL("a part that does not exist was read");
    } catch (const std::runtime_error& error) {
        QVERIFY2(std::string(error.what()).starts_with("machine.step: there is no part or assembly \"machine/right\""),
                 error.what());
    }
}

void NothingLostTest::escapedNamesAreReadable_data()
{
    QTest::addColumn<QByteArray>("written");
    QTest::addColumn<QString>("name");
    QTest::newRow("X2") << QByteArray("\\X2\\65E5672C\\X0\\ part") << QString::fromUtf8("日本 part");
    QTest::newRow("X4") << QByteArray("\\X4\\0001F529\\X0\\") << QString::fromUtf8("🔩");
    QTest::newRow("X") << QByteArray("B\\X\\FCgel") << QString::fromUtf8("Bügel");
    QTest::newRow("S") << QByteArray("B\\S\\|gel") << QString::fromUtf8("Bügel");
    QTest::newRow("UTF-8") << QByteArray("B\xC3\xBCgel") << QString::fromUtf8("Bügel");
    QTest::newRow("UTF-8 of four bytes") << QByteArray("螺栓 🔩") << QString::fromUtf8("螺栓 🔩");
    QTest::newRow("Latin-1") << QByteArray("B\xFCgel") << QString::fromUtf8("Bügel");
    QTest::newRow("quote") << QByteArray("5'' rod") << QString("5' rod");
    QTest::newRow("backslash") << QByteArray("a\\\\b") << QString("a\\b");
}

void NothingLostTest::escapedNamesAreReadable()
{
    QFETCH(QByteArray, written);
    QFETCH(QString, name);
    QFile bar(QString(KNEAD_RESOURCES) + "/examples/bar.step");
    QVERIFY(bar.open(QIODevice::ReadOnly));
    QByteArray text = bar.readAll();
    QVERIFY(text.contains("'Bar'"));
    text.replace("'Bar'", "'" + written + "'");
    std::ofstream(file("named.step"), std::ios::binary) << text.toStdString();
    QCOMPARE(QString::fromStdString(importFile(file("named.step")).parts.front().name), name);
}

QTEST_GUILESS_MAIN(NothingLostTest)
#include "nothing_lost_test.moc"
