#include "io/importer.h"
#include "support/mesh_containers.h"
#include "support/zip_file.h"

#include <QtTest>

#include <fstream>

using namespace knead;

namespace {

/// A tetrahedron with its corners at the origin and at these distances along the axes; volume x y z / 6.
std::string meshXml(int x, int y, int z, const std::string& triangleColors = "")
{
    const auto vertex = [](int a, int b, int c) {
        return "<vertex x=\"" + std::to_string(a) + "\" y=\"" + std::to_string(b) + "\" z=\"" + std::to_string(c) +
               "\"/>";
    };
    return "<mesh><vertices>" + vertex(0, 0, 0) + vertex(x, 0, 0) + vertex(0, y, 0) + vertex(0, 0, z) +
           "</vertices><triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"" + triangleColors +
           "/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/><triangle v1=\"0\" v2=\"3\" v3=\"2\"/>"
           "<triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles></mesh>";
}

std::string threeMf(const std::string& unit, const std::string& resources, const std::string& build)
{
    return threeMfOf("<?xml version=\"1.0\" encoding=\"UTF-8\"?><model unit=\"" + unit +
                     "\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">"
                     "<resources>" +
                     resources + "</resources><build>" + build + "</build></model>");
}

const char* const oneItem = "<item objectid=\"1\"/>";

std::string object(const std::string& content, const std::string& attributes = "")
{
    return "<object id=\"1\" type=\"model\" name=\"corner\"" + attributes + ">" + content + "</object>";
}

/// The same tetrahedron, in metres: four points and the corners of four triangles.
QByteArray tetrahedron()
{
    const std::vector<float> points{0, 0, 0, 0.06F, 0, 0, 0, 0.03F, 0, 0, 0, 0.02F};
    const std::vector<std::uint16_t> corners{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    QByteArray bytes(reinterpret_cast<const char*>(points.data()), static_cast<qsizetype>(4 * points.size()));
    return bytes.append(reinterpret_cast<const char*>(corners.data()), static_cast<qsizetype>(2 * corners.size()));
}

std::string gltfWith(const std::string& buffer, const std::string& nodes, const std::string& more)
{
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)" + more + R"("nodes":[)" + nodes +
           R"(],"meshes":[{"name":"shape","primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
           "materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.2158605,0,1,1]}}],
           "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],
           "max":[0.06,0.03,0.02]},{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],
           "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
           "buffers":[{"byteLength":72)" +
           buffer + "}]}";
}

/// With the numbers in the text, or in another file.
std::string gltf(const std::string& nodes, const std::string& more = "", const std::string& file = "")
{
    const std::string inText = "data:application/octet-stream;base64," + tetrahedron().toBase64().toStdString();
    return gltfWith(",\"uri\":\"" + (file.empty() ? inText : file) + "\"", nodes, more);
}

/// The same as a GLB: a chunk of JSON and a chunk of numbers.
std::string glb(const std::string& nodes)
{
    return glbOf(gltfWith("", nodes, ""), tetrahedron().toStdString());
}

const char* const plainNode = R"({"name":"corner","mesh":0})";

bool isClose(const Vec3& a, const Vec3& b)
{
    return (a - b).norm() < 1e-7;
}

} // namespace

class SceneFormatsTest : public QObject {
    Q_OBJECT

private slots:
    void threeMfHasItsUnit_data();
    void threeMfHasItsUnit();
    void threeMfItemsAndComponentsArePlaced();
    void threeMfKeepsColorsOfTriangles();
    void threeMfSupportIsHidden();
    void gltfIsInMetresWithZUp_data();
    void gltfIsInMetresWithZUp();
    void gltfNodesArePlacedAndNested();
    void gltfColorBecomesSrgb();
    void onlyWantedPartsAreRead();
    void brokenFilesGiveASentence_data();
    void brokenFilesGiveASentence();
    void cutFilesNeverCrash();

private:
    std::string write(const std::string& name, const std::string& bytes) const
    {
        const std::string path = m_folder.path().toStdString() + "/" + name;
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }
    std::string refusalOf(const std::string& name, const std::string& bytes) const
    {
        try {
            importFile(write(name, bytes));
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return {};
    }

    QTemporaryDir m_folder;
};

void SceneFormatsTest::threeMfHasItsUnit_data()
{
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("shown");
    QTest::addColumn<double>("metres");
    QTest::newRow("mm") << "millimeter"
                        << "mm" << 1e-3;
    QTest::newRow("inch") << "inch"
                          << "inch" << 0.0254;
    QTest::newRow("m") << "meter"
                       << "m" << 1.0;
    QTest::newRow("um") << "micron"
                        << "um" << 1e-6;
    QTest::newRow("cm") << "centimeter"
                        << "cm" << 1e-2;
    QTest::newRow("ft") << "foot"
                        << "ft" << 0.3048;
}

void SceneFormatsTest::threeMfHasItsUnit()
{
    QFETCH(QString, unit);
    QFETCH(QString, shown);
    QFETCH(double, metres);
    // The ending tells nothing.
    const Model model =
        importFile(write("corner.zip", threeMf(unit.toStdString(), object(meshXml(60, 30, 20)), oneItem)));
    QCOMPARE(model.format, std::string("3MF"));
    QCOMPARE(QString::fromStdString(model.unit), shown);
    QCOMPARE(model.parts.size(), std::size_t(1));
    const Part& part = model.parts.front();
    QCOMPARE(part.name, std::string("corner"));
    QVERIFY(part.watertight && part.valid);
    QVERIFY((part.box.sizes() - metres * Vec3(60, 30, 20)).norm() < 1e-6 * metres);
    QVERIFY(std::abs(part.volume / (6000 * metres * metres * metres) - 1) < 1e-6);
}

void SceneFormatsTest::threeMfItemsAndComponentsArePlaced()
{
    // A quarter turn about z takes x to y. The numbers are the rows of the matrix that row vectors are multiplied with.
    const std::string turn = "0 1 0 -1 0 0 0 0 1 ";
    const std::string group = "<object id=\"2\" type=\"model\" name=\"группа\"><components>"
                              "<component objectid=\"1\" transform=\"" +
                              turn +
                              "100 0 0\"/><component objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"
                              "</components></object>";
    const Model model =
        importFile(write("placed.3mf", threeMf("millimeter", object(meshXml(60, 30, 20)) + group,
                                               "<item objectid=\"2\" transform=\"" + turn + "0 0 1000\"/>")));
    QCOMPARE(model.parts.size(), std::size_t(2));
    QCOMPARE(model.parts[0].path, std::string("группа/corner"));
    QCOMPARE(model.tree.children.size(), std::size_t(1));
    QCOMPARE(model.tree.children[0].children.size(), std::size_t(2));
    const Box& turned = model.parts[0].box; // half a turn in all, and 100 mm along x turned to y
    QVERIFY(isClose(turned.min(), Vec3(-0.06, 0.07, 1)) && isClose(turned.max(), Vec3(0, 0.1, 1.02)));
    const Box& mirrored = model.parts[1].box; // x to -x, then a quarter turn
    QVERIFY(isClose(mirrored.min(), Vec3(-0.03, -0.06, 1)) && isClose(mirrored.max(), Vec3(0, 0, 1.02)));
    QVERIFY(model.parts[1].warnings.empty()); // mirroring turns nothing inside out
    QVERIFY(model.parts[1].watertight);
}

void SceneFormatsTest::threeMfKeepsColorsOfTriangles()
{
    const std::string materials = "<basematerials id=\"5\"><base name=\"PLA\" displaycolor=\"#FF0000FF\"/>"
                                  "<base name=\"PETG\" displaycolor=\"#0000FFFF\"/></basematerials>";
    const std::string file =
        threeMf("millimeter", materials + object(meshXml(60, 30, 20, " pid=\"5\" p1=\"1\""), " pid=\"5\" pindex=\"0\""),
                oneItem);
    const Part part = importFile(write("colors.3mf", file)).parts.front();
    QCOMPARE(part.mesh.faceOfTriangle.size(), std::size_t(4));
    QCOMPARE(part.faces.size(), std::size_t(2));
    const auto colorOf = [&](std::size_t triangle) {
        return part.faces[part.mesh.faceOfTriangle[triangle]].color.value_or(part.color.value());
    };
    QVERIFY((colorOf(0) == Color{0, 0, 1}));
    for (const std::size_t triangle : {1, 2, 3})
        QVERIFY((colorOf(triangle) == Color{1, 0, 0}));
}

void SceneFormatsTest::threeMfSupportIsHidden()
{
    std::string content = object(meshXml(60, 30, 20));
    content.replace(content.find("\"model\""), 7, "\"support\"");
    const std::string more = "<object id=\"2\" type=\"model\">" + meshXml(10, 10, 10) + "</object>";
    const Model model = importFile(
        write("support.3mf", threeMf("millimeter", content + more, "<item objectid=\"2\"/><item objectid=\"1\"/>")));
    QCOMPARE(model.parts.size(), std::size_t(2));
    QVERIFY(model.parts[0].visible && model.parts[0].layer.empty());
    QCOMPARE(model.parts[0].name, std::string("support")); // without a name it is called as the file
    QVERIFY(!model.parts[1].visible);
    QCOMPARE(model.parts[1].layer, std::string("support"));
}

void SceneFormatsTest::gltfIsInMetresWithZUp_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("gltf") << "corner.gltf" << QByteArray::fromStdString(gltf(plainNode));
    QTest::newRow("glb") << "corner.glb" << QByteArray::fromStdString(glb(plainNode));
    QTest::newRow("another ending") << "corner.step" << QByteArray::fromStdString(gltf(plainNode));
    QTest::newRow("no ending") << "corner" << QByteArray::fromStdString(glb(plainNode));
}

void SceneFormatsTest::gltfIsInMetresWithZUp()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    const Model model = importFile(write(name.toStdString(), bytes.toStdString()));
    QCOMPARE(model.format, std::string("glTF"));
    QCOMPARE(model.unit, std::string("m"));
    QVERIFY(model.warnings.empty());
    QCOMPARE(model.parts.size(), std::size_t(1));
    const Part& part = model.parts.front();
    QCOMPARE(part.name, std::string("corner"));
    QVERIFY(part.watertight && part.warnings.empty());
    QVERIFY(isClose(part.box.min(), Vec3(0, -0.02, 0)) && isClose(part.box.max(), Vec3(0.06, 0, 0.03)));
}

void SceneFormatsTest::gltfNodesArePlacedAndNested()
{
    const std::string nodes = R"({"name":"arm","children":[1,2],"translation":[1,0,0]},
        {"name":"left","mesh":0,"translation":[0,2,0],"scale":[2,2,2]},
        {"name":"right","mesh":0,"scale":[-1,1,1]})";
    const Model model = importFile(write("nested.gltf", gltf(nodes)));
    QCOMPARE(model.parts.size(), std::size_t(2));
    QCOMPARE(model.parts[0].path, std::string("arm/left"));
    QCOMPARE(model.parts[1].path, std::string("arm/right"));
    QVERIFY(isClose(model.parts[0].box.min(), Vec3(1, -0.04, 2)));
    QVERIFY(isClose(model.parts[0].box.max(), Vec3(1.12, 0, 2.06)));
    QVERIFY(isClose(model.parts[1].box.min(), Vec3(0.94, -0.02, 0)));
    QVERIFY(model.parts[1].warnings.empty());

    const std::string unnamed = R"({"children":[1]},{"children":[2]},{"mesh":0})";
    const Model bare = importFile(write("bare.gltf", gltf(unnamed)));
    QCOMPARE(bare.parts.size(), std::size_t(1));
    QCOMPARE(bare.parts[0].name, std::string("bare"));
}

void SceneFormatsTest::gltfColorBecomesSrgb()
{
    const Color color = importFile(write("color.gltf", gltf(plainNode))).parts.front().color.value();
    QVERIFY(std::abs(color.r - 0.5020F) < 0.002F); // #80 is 0.2159 in linear light
    QVERIFY(color.g == 0 && std::abs(color.b - 1) < 1e-5F);

    std::string colorless = gltf(plainNode);
    colorless.erase(colorless.find(R"(,"material":0)"), 13);
    QVERIFY(!importFile(write("colorless.gltf", colorless)).parts.front().color);
}

void SceneFormatsTest::onlyWantedPartsAreRead()
{
    const std::string nodes = R"({"name":"arm","children":[1,2]},{"name":"left","mesh":0},{"name":"right","mesh":0})";
    const std::string file = write("wanted.gltf", gltf(nodes));
    const Model right = importFile(file, {.parts = {"arm/right"}});
    QCOMPARE(right.parts.size(), std::size_t(1));
    QCOMPARE(right.parts[0].name, std::string("right"));
    QCOMPARE(right.tree.children[0].children.size(), std::size_t(1));
    QCOMPARE(importFile(file, {.parts = {"arm"}}).parts.size(), std::size_t(2));
    QVERIFY_EXCEPTION_THROWN(importFile(file, {.parts = {"ar"}}), std::runtime_error);
}

void SceneFormatsTest::brokenFilesGiveASentence_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("words");
    using namespace std::string_literals;
    const auto row = [](const char* tag, const char* name, const std::string& bytes, const char* words) {
        QTest::newRow(tag) << QString(name) << QByteArray::fromStdString(bytes) << QString(words);
    };
    const std::string whole = threeMf("millimeter", object(meshXml(60, 30, 20)), oneItem);
    row("3MF cut off", "a.3mf", whole.substr(0, whole.size() / 2), "zip archive that is cut off");
    row("3MF with broken XML", "a.3mf", threeMf("millimeter", "<object", oneItem), "3MF file is damaged");
    row("3MF with wrong corners", "a.3mf", threeMf("millimeter", object(meshXml(1, 1, 1, " v3=\"77\"")), oneItem),
        "damaged");
    row("3MF without items", "a.3mf", threeMf("millimeter", object(meshXml(60, 30, 20)), ""), "builds no object");
    row("zip", "a.3mf", zipOf({{"readme.txt", "hello"}}), "this is a zip archive; unpack it");
    row("stpz", "a.stpz", zipOf({{"gear.stp", "ISO-10303-21;"}}), "holds \"gear.stp\"");
    row("Word", "a.docx", zipOf({{"[Content_Types].xml", ""}, {"word/document.xml", ""}}), "Word document");
    row("Excel", "a.xlsx", zipOf({{"[Content_Types].xml", ""}, {"xl/workbook.xml", ""}}), "Excel workbook");
    row("FreeCAD", "a.FCStd", zipOf({{"Document.xml", ""}, {"GuiDocument.xml", ""}}), "FreeCAD document");
    row("xz", "a.step",
        "\xFD"
        "7zXZ\0 more"s,
        "xz archive");
    row("zstd", "a.step", "\x28\xB5\x2F\xFD more", "zstd archive");
    row("rar", "a.step", "Rar!\x1A\x07 more", "rar archive");
    row("tar", "a.step", std::string(257, 'a') + "ustar" + std::string(300, '\0'), "tar archive");
    row("STEP as XML", "a.stpx",
        "<?xml version=\"1.0\"?><n0:Uos xmlns:n0=\"http://standards.iso.org/iso/ts/10303/-3001\"/>", "STEP as XML");
    row("another XML", "a.xml", "<?xml version=\"1.0\"?><svg/>", "XML text");
    row("another JSON", "a.json", R"({"version": 1})", "JSON text, but no glTF");
    row("cut JSON", "a.gltf", gltf(plainNode).substr(0, 300), "cut off or damaged");
    row("glTF 1", "a.gltf", R"({"asset":{"version":"1.0"}})", "only 2 can be read");
    row("glTF without shapes", "a.gltf", R"({"asset":{"version":"2.0"},"nodes":[]})", "");
    row("compressed glTF", "a.gltf", gltf(plainNode, R"("extensionsRequired":["KHR_draco_mesh_compression"],)"),
        "compressed");
    row("buffer that is missing", "a.gltf", gltf(plainNode, "", "num%20bers.bin"),
        "\"num bers.bin\", which is not beside");
    row("node in itself", "a.gltf", gltf(R"({"children":[1]},{"children":[0]})"), "hold themselves");
    row("node in two", "a.gltf", gltf(R"({"children":[1,2]},{"children":[2]},{"mesh":0})"), "in two others");
    row("GLB cut off", "a.glb", glb(plainNode).substr(0, 100), "cut off");
    row("GLB of nothing", "a.glb", "glTF", "damaged");
}

void SceneFormatsTest::brokenFilesGiveASentence()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, words);
    const std::string sentence = refusalOf(name.toStdString(), bytes.toStdString());
    QVERIFY2(sentence.starts_with(name.toStdString() + ": "), sentence.c_str());
    QVERIFY2(sentence.find(words.toStdString()) != std::string::npos, sentence.c_str());
    QVERIFY2(sentence.ends_with('.'), sentence.c_str());
}

/// What is read of a file whose bytes were turned over is refused in a sentence or read, but does not end the program.
void SceneFormatsTest::cutFilesNeverCrash()
{
    for (const std::string& whole : {threeMf("millimeter", object(meshXml(60, 30, 20)), oneItem), glb(plainNode)})
        for (std::size_t at = 8; at < whole.size(); at += 37) {
            std::string damagedBytes = whole;
            damagedBytes[at] = static_cast<char>(damagedBytes[at] ^ 0x15);
            const std::string sentence = refusalOf("damaged", damagedBytes);
            QVERIFY2(sentence.empty() || sentence.ends_with('.'), sentence.c_str());
        }
}

QTEST_GUILESS_MAIN(SceneFormatsTest)
#include "scene_formats_test.moc"
