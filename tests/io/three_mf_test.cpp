// What 3MF files of other programs hold, and what those of strangers might.
#include "io/formats/threemf/zip_archive.h"
#include "io/importer.h"
#include "support/mesh_containers.h"

#include <QtTest>

#include <cstdint>
#include <fstream>

using namespace knead;

namespace {

const std::string cornersText = "<vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"60\" y=\"0\" z=\"0\"/>"
                                "<vertex x=\"0\" y=\"30\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"20\"/></vertices>";
const std::string threeSidesText = "<triangle v1=\"0\" v2=\"1\" v3=\"3\"/><triangle v1=\"0\" v2=\"3\" v3=\"2\"/>"
                                   "<triangle v1=\"1\" v2=\"2\" v3=\"3\"/>";

/// A tetrahedron whose first triangle has these attributes.
std::string meshText(const std::string& first = "", const std::string& more = "")
{
    return "<mesh>" + cornersText + "<triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\" " + first + "/>" + threeSidesText +
           more + "</triangles></mesh>";
}

std::string objectText(int id, const std::string& content, const std::string& attributes = "")
{
    return "<object id=\"" + std::to_string(id) + "\" name=\"thing " + std::to_string(id) + "\" " + attributes + ">" +
           content + "</object>";
}

std::string modelText(const std::string& resources, const std::string& build, const std::string& before = "")
{
    return "<?xml version=\"1.0\"?>" + before +
           "<model unit=\"millimeter\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
           "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
           "xmlns:prod=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "
           "xmlns:slicer=\"http://slicer.example.org\"><resources>" +
           resources + "</resources><build>" + build + "</build></model>";
}

const char* const oneItem = "<item objectid=\"1\"/>";

std::string numberBytes(std::uint64_t value, int length)
{
    std::string bytes;
    for (int i = 0; i < length; ++i)
        bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
    return bytes;
}

} // namespace

class ThreeMfTest : public QObject {
    Q_OBJECT

private slots:
    void objectsMayLieInOtherFiles();
    void aFileHasOneName();
    void whatIsNoPartIsHidden();
    void extensionsThatItRequiresAreNamed();
    void groupsOfColorsColorTriangles();
    void whatOtherProgramsAddIsPassedOver();
    void trianglesWithoutAreaAreLeftOutAndSaid();
    void filesOfStrangersAreRefused_data();
    void filesOfStrangersAreRefused();
    void noMoreIsUnpackedThanTheDirectorySays();
    void largeArchivesAreRead();

private:
    std::string write(const std::string& bytes) const
    {
        const std::string path = m_folder.path().toStdString() + "/a.3mf";
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }
    std::string refusalOf(const std::string& bytes) const
    {
        try {
            importFile(write(bytes));
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return {};
    }

    QTemporaryDir m_folder;
};

/// As slicers write them: the root only says where each object is.
void ThreeMfTest::objectsMayLieInOtherFiles()
{
    const std::string root = modelText(
        objectText(7, "<components><component objectid=\"1\" prod:path=\"/3D/Objects/one.model\"/>"
                      "<component objectid=\"1\" prod:path=\"/3D/Objects/two.model\" transform=\"1 0 0 0 1 0 0 0 1 "
                      "100 0 0\"/></components>"),
        "<item objectid=\"7\"/>");
    const std::string relations =
        "<?xml version=\"1.0\"?><Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
        "<Relationship Target=\"/Metadata/thumbnail.png\" Id=\"rel1\" Type=\"thumbnail\"/><Relationship "
        "Target=\"/3D/Root.model\" Id=\"rel0\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
    const Model read = importFile(write(zipOf({{"_rels/.rels", relations},
                                               {"3D/Objects/one.model", modelText(objectText(1, meshText()), "")},
                                               {"3D/Objects/two.model", modelText(objectText(1, meshText()), oneItem)},
                                               {"3D/Root.model", root}})));
    QCOMPARE(read.parts.size(), std::size_t{2}); // what other files build is not built
    QCOMPARE(read.parts[0].path, std::string("thing 7/thing 1"));
    QVERIFY(std::abs(read.parts[1].box.min().x() - 0.1) < 1e-9);
    QVERIFY(read.warnings.empty());
}

/// However it is spelled: read once for each spelling, small files would become large ones.
void ThreeMfTest::aFileHasOneName()
{
    std::string components;
    for (const char* path : {"/3D/One.model", "3d/one.model", "/3D/ONE.MODEL"})
        components += std::string("<component objectid=\"1\" prod:path=\"") + path + "\"/>";
    const std::string flaw = "<triangle v1=\"1\" v2=\"1\" v3=\"2\"/>"; // counted each time it is read
    const Model read = importFile(
        write(zipOf({{"3D/one.model", modelText(objectText(1, meshText("", flaw)), "")},
                     {"3D/3dmodel.model", modelText(objectText(7, "<components>" + components + "</components>"),
                                                    "<item objectid=\"7\"/>")}})));
    QCOMPARE(read.parts.size(), std::size_t{3});
    QCOMPARE(read.warnings.size(), std::size_t{1});
    QVERIFY(read.warnings.front().english().find("in 1 place;") != std::string::npos);
}

void ThreeMfTest::whatIsNoPartIsHidden()
{
    std::string objects;
    std::string items;
    for (const char* type : {"model", "other", "support", "surface"}) {
        const int id = static_cast<int>(items.size()) + 1;
        objects += objectText(id, meshText(), std::string("type=\"") + type + "\"");
        items += "<item objectid=\"" + std::to_string(id) + "\"/>";
    }
    const Model read = importFile(write(threeMfOf(modelText(objects, items))));
    std::string layers;
    for (const Part& part : read.parts) {
        QCOMPARE(part.visible, part.layer.empty());
        layers += part.layer + ';';
    }
    QCOMPARE(layers, std::string(";other;support;;"));
}

/// Without them a part may be a stand-in.
void ThreeMfTest::extensionsThatItRequiresAreNamed()
{
    std::string text = modelText(objectText(1, meshText()), oneItem);
    text.replace(text.find("unit="), 0, "xmlns:b=\"http://beams.example.org/2017\" requiredextensions=\"m b  prod\" ");
    const Model read = importFile(write(threeMfOf(text)));
    QCOMPARE(read.parts.size(), std::size_t{1});
    QCOMPARE(read.warnings.size(), std::size_t{1});
    QVERIFY(read.warnings.front().english().find("(http://beams.example.org/2017)") != std::string::npos);
}

void ThreeMfTest::groupsOfColorsColorTriangles()
{
    const std::string colors = "<m:colorgroup id=\"5\"><m:color color=\"#00FF00\"/><m:color color=\"#0000FF80\"/>"
                               "</m:colorgroup>";
    const Part part = importFile(write(threeMfOf(modelText(
                                     colors + objectText(1, meshText("p1=\"0\""), "pid=\"5\" pindex=\"1\""), oneItem))))
                          .parts.front();
    const auto colorOf = [&](std::size_t triangle) {
        return part.faces[part.mesh.faceOfTriangle[triangle]].color.value_or(part.color.value());
    };
    QVERIFY((colorOf(0) == Color{0, 1, 0}));
    QVERIFY((colorOf(1) == Color{0, 0, 1}));
}

void ThreeMfTest::whatOtherProgramsAddIsPassedOver()
{
    const std::string added = "<slicer:object id=\"1\"><mesh/></slicer:object><m:texture2dgroup id=\"9\" texid=\"8\">"
                              "<m:tex2coord u=\"0\" v=\"0\"/></m:texture2dgroup>";
    const Model read = importFile(write(threeMfOf(modelText(
        added + objectText(1, "<metadatagroup><metadata name=\"a\">b</metadata></metadatagroup>" + meshText("p1=\"0\""),
                           "pid=\"9\" pindex=\"0\" slicer:id=\"2\""),
        "<item objectid=\"1\" slicer:printable=\"1\"/>"))));
    QCOMPARE(read.parts.size(), std::size_t{1});
    QCOMPARE(read.parts[0].mesh.triangles.size(), std::size_t{4});
    QVERIFY(!read.parts[0].color);
    QVERIFY(read.warnings.empty());
}

void ThreeMfTest::trianglesWithoutAreaAreLeftOutAndSaid()
{
    const Model read = importFile(
        write(threeMfOf(modelText(objectText(1, meshText("", "<triangle v1=\"1\" v2=\"1\" v3=\"2\"/>")), oneItem))));
    QCOMPARE(read.parts.front().mesh.triangles.size(), std::size_t{4});
    QVERIFY(read.parts.front().watertight);
    QCOMPARE(read.warnings.size(), std::size_t{1});
    QVERIFY(read.warnings.front().english().find("does not keep to the format in 1 place") != std::string::npos);
}

void ThreeMfTest::filesOfStrangersAreRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("words");
    const auto row = [](const char* tag, const std::string& text, const char* words) {
        QTest::newRow(tag) << QByteArray::fromStdString(text) << QString(words);
    };
    const std::string sound = objectText(1, meshText());
    row("entities", modelText(sound, oneItem, "<!DOCTYPE a [<!ENTITY b \"bb\"><!ENTITY c \"&b;&b;\">]>"), "damaged");
    row("files from outside", modelText(sound, oneItem, "<!DOCTYPE a SYSTEM \"file:///etc/passwd\">"), "damaged");
    std::string deep;
    for (int i = 0; i < 100'000; ++i)
        deep += "<a>";
    row("deep nesting", modelText(deep, oneItem), "damaged");
    row("objects in themselves",
        modelText(objectText(1, "<components>" + std::string("<component objectid=\"1\"/>") + "</components>"),
                  oneItem),
        "nests them more than 200 deep");
    row("objects that are not there", modelText(sound, "<item objectid=\"2\"/>"), "damaged");
    row("files that are not there", modelText(sound, "<item objectid=\"1\" prod:path=\"/3D/no.model\"/>"), "damaged");
    row("two objects of one number", modelText(sound + sound, oneItem), "damaged");
    row("corners that are not there",
        modelText(objectText(1, meshText("", "<triangle v1=\"0\" v2=\"1\" v3=\"4\"/>")), oneItem), "damaged");
    row("corners below none",
        modelText(objectText(1, meshText("", "<triangle v1=\"0\" v2=\"1\" v3=\"-1\"/>")), oneItem), "damaged");
    row("places that are no numbers",
        modelText(sound, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 nan 0 0 0\"/>"), "damaged");
    row("eleven numbers", modelText(sound, "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0\"/>"), "damaged");
    row("another document", "<?xml version=\"1.0\"?><svg/>", "damaged");
    std::string bomb;
    for (int i = 2; i <= 40; ++i) {
        const std::string one = "<component objectid=\"" + std::to_string(i - 1) + "\"/>";
        bomb += objectText(i, "<components>" + one + one + "</components>");
    }
    row("objects that double", modelText(sound + bomb, "<item objectid=\"40\"/>"), "more than 100000 objects");
}

void ThreeMfTest::filesOfStrangersAreRefused()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, words);
    const std::string sentence = refusalOf(threeMfOf(text.toStdString()));
    QVERIFY2(sentence.starts_with("a.3mf: ") && sentence.find(words.toStdString()) != std::string::npos,
             sentence.c_str());
}

void ThreeMfTest::noMoreIsUnpackedThanTheDirectorySays()
{
    const std::string archive = threeMfOf(modelText(objectText(1, meshText()), oneItem));
    for (const auto& [place, what] : {std::pair(24, "its size"), std::pair(16, "its checksum"), std::pair(20, "packed"),
                                      std::pair(10, "its method"), std::pair(42, "its place")}) {
        std::string wrong = archive;
        wrong.replace(archive.rfind("PK\x01\x02") + static_cast<std::size_t>(place), 2, numberBytes(77, 2));
        const std::string sentence = refusalOf(wrong);
        QVERIFY2(sentence.find("damaged") != std::string::npos, what);
    }
}

/// With the numbers of 64 bits that lib3mf writes for archives of any size.
void ThreeMfTest::largeArchivesAreRead()
{
    const std::string name = "3D/3dmodel.model";
    const std::string content = modelText(objectText(1, meshText()), oneItem);
    const std::string small = zipOf({{name, content}});
    const std::string sum = small.substr(14, 4);
    const std::string none = numberBytes(0xFFFF'FFFF, 4);
    const std::string sizes = numberBytes(content.size(), 8) + numberBytes(content.size(), 8);
    const std::string head = numberBytes(45, 2) + numberBytes(0, 8) + sum + none + none + numberBytes(name.size(), 2);
    const std::string file =
        "PK\x03\x04" + head + numberBytes(20, 2) + name + numberBytes(1, 2) + numberBytes(16, 2) + sizes + content;
    const std::string directory = "PK\x01\x02" + numberBytes(45, 2) + head + numberBytes(28, 2) + numberBytes(0, 2) +
                                  numberBytes(0, 8) + none + name + numberBytes(1, 2) + numberBytes(24, 2) + sizes +
                                  numberBytes(0, 8);
    const std::string end =
        "PK\x06\x06" + numberBytes(44, 8) + numberBytes(45, 2) + numberBytes(45, 2) + numberBytes(0, 8) +
        numberBytes(1, 8) + numberBytes(1, 8) + numberBytes(directory.size(), 8) + numberBytes(file.size(), 8) +
        "PK\x06\x07" + numberBytes(0, 4) + numberBytes(file.size() + directory.size(), 8) + numberBytes(1, 4) +
        "PK\x05\x06" + numberBytes(0, 4) + numberBytes(1, 2) + numberBytes(1, 2) + none + none + numberBytes(0, 2);
    const std::string path = write(file + directory + end);
    const auto entries = zipEntries(path);
    QVERIFY(entries && entries->size() == 1);
    QCOMPARE(entries->front().size, std::uint64_t{content.size()});
    QCOMPARE(importFile(path).parts.size(), std::size_t{1});
}

QTEST_GUILESS_MAIN(ThreeMfTest)
#include "three_mf_test.moc"
