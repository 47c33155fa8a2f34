#include "io/importer.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>

#include <QtTest>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>

using namespace knead;

// A sound file of each CAD format, damaged in one place.

namespace {

std::string contentOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t place = text.find(from);
    if (place == std::string::npos)
        throw std::logic_error("the file to damage has no " + from);
    return text.replace(place, from.size(), to);
}

/// Lines of a section of an IGES file changed by a function.
std::string withLines(const std::string& iges, char section, const std::function<std::string(std::string)>& change)
{
    std::istringstream lines(iges);
    std::string result;
    for (std::string line; std::getline(lines, line);)
        result += (line.size() > 72 && line[72] == section ? change(line) : line) + "\n";
    return result;
}

/// A line whose direction is a point, which the CAD reader would take for a direction.
std::string lineOfTwoPoints(const std::string& step)
{
    const std::size_t line = step.find("LINE('',#");
    const std::size_t point = line + 8;
    const std::size_t comma = step.find(",", point);
    const std::string name = step.substr(point, comma - point);
    return std::string(step).replace(comma + 1, step.find(")", comma) - comma - 1, name);
}

bool mention(const std::vector<knead::Message>& sentences, const std::string& words)
{
    return std::any_of(sentences.begin(), sentences.end(), [&](const knead::Message& sentence) {
        return sentence.english().find(words) != std::string::npos;
    });
}

} // namespace

class DamagedFilesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void soundFilesAreRead();
    void igesWithCarriageReturnsIsRead();
    void igesCommentsAreNoValues();
    void damageIsNamed_data();
    void damageIsNamed();
    void stepEntitiesThatReferToNothingCostTheirFacesOnly();
    void stepShellsWithoutAllFacesSaySo();
    void stepSolidsThatAreLostAreNamed();
    void strangeSchemaIsMentioned();

private:
    std::string write(const std::string& name, const std::string& text) const;

    QTemporaryDir m_folder;
    std::string m_step;
    std::string m_iges;
    std::string m_brep;
};

std::string DamagedFilesTest::write(const std::string& name, const std::string& text) const
{
    const std::string path = m_folder.path().toStdString() + "/" + name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

void DamagedFilesTest::initTestCase()
{
    QVERIFY(m_folder.isValid());
    ::Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
    m_step = contentOf(std::string(KNEAD_RESOURCES) + "/examples/bar.step");
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
    std::ostringstream brep;
    BRepTools::Write(box, brep);
    m_brep = brep.str();
    IGESControl_Controller::Init();
    IGESControl_Writer writer("MM", 0);
    writer.AddShape(box);
    std::ostringstream iges;
    QVERIFY(writer.Write(iges));
    m_iges = iges.str();
}

void DamagedFilesTest::soundFilesAreRead()
{
    QCOMPARE(importFile(write("a.step", m_step)).parts.size(), std::size_t(1));
    for (const std::string& path : {write("a.igs", m_iges), write("a.brep", m_brep)}) {
        const Model model = importFile(path);
        QCOMPARE(model.parts.size(), std::size_t(1));
        QVERIFY(model.missing.empty());
        QVERIFY(std::abs(model.parts.front().volume - 6e-6) < 1e-12);
    }
}

void DamagedFilesTest::igesWithCarriageReturnsIsRead()
{
    const std::string text = withLines(m_iges, 'S', [](std::string line) { return line + "\r"; });
    QVERIFY(importFile(write("dos.igs", text)).parts.front().canBeFilled());
}

void DamagedFilesTest::igesCommentsAreNoValues()
{
    bool isDone = false;
    const std::string text = withLines(m_iges, 'P', [&](std::string line) {
        const std::size_t end = line.find(";");
        if (!isDone && end < 50) {
            line.replace(end + 1, 8, " no,nmbr");
            isDone = true;
        }
        return line;
    });
    QVERIFY(isDone);
    QVERIFY(importFile(write("comment.igs", text)).parts.front().canBeFilled());
}

void DamagedFilesTest::damageIsNamed_data()
{
    QTest::addColumn<std::string>("text");
    QTest::addColumn<std::string>("words");
    const auto row = [](const char* name, const std::string& text, const char* words) {
        QTest::newRow(name) << text << std::string(words);
    };
    row("iges cut off", m_iges.substr(0, m_iges.size() / 2 / 81 * 81), "cut off");
    row("iges line too short", withLines(m_iges, 'D', [](const std::string& line) { return line.substr(0, 60); }),
        "80 columns");
    bool isFirst = true;
    row("iges lines lost", withLines(m_iges, 'T', [](std::string line) { return line.replace(25, 7, "9999999"); }),
        "lacks lines of its section P");
    row("iges letters",
        withLines(m_iges, 'P',
                  [&](std::string line) {
                      if (isFirst)
                          line.replace(4, 3, "xyz");
                      isFirst = false;
                      return line;
                  }),
        "in place of a number");
    row("iges long text",
        withLines(m_iges, 'G',
                  [](std::string line) {
                      if (const std::size_t place = line.find("2HMM,"); place != std::string::npos)
                          line.replace(place, 5, "9999H");
                      return line;
                  }),
        "9999 letters");
    row("brep version", replaced(m_brep, "Topology V", "Topology V9"), "is unknown");
    row("brep count", replaced(m_brep, "Surfaces 6", "Surfaces 600000000"), "impossible number of Surfaces");
    row("brep negative", replaced(m_brep, "TShapes ", "TShapes -"), "impossible number of TShapes");
    row("brep section lost", replaced(m_brep, "Curves", "Curses"), "sections are missing");
    row("brep cut off", m_brep.substr(0, m_brep.size() * 9 / 10), "damaged");
    row("step cycle",
        replaced(m_step, "ENDSEC;\nEND-ISO",
                 "#90001=PRODUCT_DEFINITION('','',$,$);\n#90002=PRODUCT_DEFINITION('','',$,$);\n"
                 "#90003=NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','','',#90001,#90002,$);\n"
                 "#90004=NEXT_ASSEMBLY_USAGE_OCCURRENCE('2','','',#90002,#90001,$);\nENDSEC;\nEND-ISO"),
        "holds itself");
}

void DamagedFilesTest::damageIsNamed()
{
    QFETCH(std::string, text);
    QFETCH(std::string, words);
    try {
        importFile(write("damaged.x", text));
    } catch (const std::runtime_error& error) {
        const std::string sentence = error.what();
        QVERIFY2(sentence.starts_with("damaged.x: ") && sentence.ends_with('.'), sentence.c_str());
        QVERIFY2(sentence.find(words) != std::string::npos, sentence.c_str());
        return;
    }
    QFAIL("a damaged file was imported");
}

/// Of the two faces at an edge whose line has no direction the rest of the file knows nothing.
void DamagedFilesTest::stepEntitiesThatReferToNothingCostTheirFacesOnly()
{
    const Model model = importFile(write("line.step", lineOfTwoPoints(m_step)));
    QVERIFY(mention(
        model.warnings,
        "refers to something of the wrong kind or nothing at all; what needs it could not be read (faces: 2)."));
    QCOMPARE(model.parts.size(), std::size_t{1});
    QVERIFY(!model.parts.front().canBeFilled());
    QCOMPARE(model.parts.front().faces.size(), std::size_t{4});
    QVERIFY(mention(model.parts.front().warnings, "4 of 6 faces"));
}

void DamagedFilesTest::stepShellsWithoutAllFacesSaySo()
{
    const std::string text = replaced(m_step, "CLOSED_SHELL('',(#17,#137", "CLOSED_SHELL('',(#17,#99999");
    const Part part = importFile(write("lost.step", text)).parts.front();
    QCOMPARE(part.solids, 0);
    QVERIFY(!part.canBeFilled());
    QVERIFY(mention(part.warnings, "5 of 6 faces"));
}

void DamagedFilesTest::stepSolidsThatAreLostAreNamed()
{
    std::string text = m_step;
    for (std::size_t place = text.find("PLANE("); place != std::string::npos; place = text.find("PLANE(", place + 8))
        text.replace(place, 6, "PLAIN(");
    try {
        importFile(write("nothing.step", text));
    } catch (const std::runtime_error& error) {
        QVERIFY2(std::string(error.what()).find("1 shape of the STEP file could not be read") != std::string::npos,
                 error.what());
        return;
    }
    QFAIL("a file without a readable face was imported");
}

void DamagedFilesTest::strangeSchemaIsMentioned()
{
    const Model model = importFile(write("ifc.step", replaced(m_step, "AUTOMOTIVE_DESIGN", "IFC4")));
    QVERIFY(mention(model.warnings, "IFC4"));
    QVERIFY(model.parts.front().canBeFilled());
}

QTEST_GUILESS_MAIN(DamagedFilesTest)
#include "damaged_files_test.moc"
