#include "io/fields/field_bytes.h"
#include "io/fields/field_reader.h"
#include "support/byte_mutation.h"
#include "support/sample_fields.h"

#include <QTemporaryDir>
#include <QtTest>

#include <filesystem>
#include <fstream>
#include <optional>

#include <sys/resource.h>

using namespace knead;
using samples::sample;

namespace {

/// A sentence is one line that names the file and ends with a full stop.
bool isSentence(const std::string& text, const std::string& name)
{
    return text.starts_with(name + ": ") && text.ends_with('.') && text.size() < 400 && text.find('\n') == text.npos;
}

/// Files of every format, as they are written in field_files_test.
std::vector<std::string> soundFiles()
{
    const auto line = [](std::size_t i, const Vec3& X, const Vec3& u) {
        return std::to_string(i) + ";" + samples::triple(X, ";") + ";" + samples::triple(u, ";");
    };
    return {samples::frd({sample(1), sample(2)}, 0),
            samples::frd({sample(1), sample(2)}, 1),
            samples::frd({sample()}, 2),
            samples::legacyVtk(sample(), "UNSTRUCTURED_GRID", false, true),
            samples::legacyVtk(sample(), "UNSTRUCTURED_GRID", true, false),
            samples::legacyVtk(sample(), "POLYDATA", true, true),
            samples::xmlVtk(sample(), {.format = "ascii"}),
            samples::xmlVtk(sample(), {.format = "binary", .isCompressed = true}),
            samples::xmlVtk(sample(), {.isBase64 = true}),
            samples::xmlVtk(sample(), {.isCompressed = true, .order = std::endian::big}),
            samples::gmsh({sample(1), sample(2)}, false, false),
            samples::gmsh({sample()}, false, true),
            samples::gmsh({sample()}, true, false),
            samples::gmsh({sample()}, true, true),
            samples::table(sample(), "Node;X [cm];Y [cm];Z [cm];dx;dy;dz\n", line),
            samples::table(sample(), "", line),
            samples::report({sample(1), sample(2)}),
            samples::input(sample())};
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    const std::size_t place = text.find(what);
    return place == text.npos ? std::string() : text.replace(place, what.size(), by);
}

} // namespace

/// Broken, huge, empty, mismatched and hostile files: a sound field or one sentence, and never much memory.
///
/// KNEAD_FUZZ_INPUTS says how many files are damaged, KNEAD_FUZZ_SEED how.
class FieldDamageTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void eachKindOfDamageHasItsSentence_data();
    void eachKindOfDamageHasItsSentence();
    void whatIsCutOffAnywhereIsASentence();
    void damageIsASentenceOrASoundField();
    void bytesOfAnotherProcessAreChecked();

private:
    std::string write(const std::string& name, const std::string& content) const
    {
        const std::string path = m_folder.filePath(name.c_str()).toStdString();
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }
    std::string flawOf(const std::string& content) const;

    QTemporaryDir m_folder;
};

/// A count that lies asks for memory that there is not.
void FieldDamageTest::initTestCase()
{
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    constexpr rlim_t most = 1U << 30U; // bytes of addresses; the files have some thousands
    rlimit limit{};
    QCOMPARE(getrlimit(RLIMIT_AS, &limit), 0);
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, most);
    QCOMPARE(setrlimit(RLIMIT_AS, &limit), 0);
#endif
}

void FieldDamageTest::eachKindOfDamageHasItsSentence_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("words");
    const auto add = [](const char* row, const char* name, const std::string& content, const char* words) {
        QTest::newRow(row) << name << QByteArray::fromStdString(content) << words;
    };
    const std::string frd = samples::frd({sample()});
    const std::string vtu = samples::xmlVtk(sample(), {.format = "ascii"});
    const std::string vtk = samples::legacyVtk(sample(), "UNSTRUCTURED_GRID", true, false);
    const std::string msh = samples::gmsh({sample()}, true, false);
    add("empty", "a.frd", "", "the file is empty");
    add("a poem", "a.csv", "The woods are lovely,\ndark and deep\n", "no lines of numbers");
    add("too few columns", "a.csv", "1 2 3 4 5\n6 7 8 9 1\n", "what its 5 columns are");
    add("no displacements in a table", "a.csv", "X,Y,Z,T\n1,2,3,4\n", "what its 4 columns are");
    add("bytes", "a.csv", std::string("\x01\x02\x03", 3), "no file of displacements");
    add("STEP", "a.csv", "ISO-10303-21;\nHEADER;\n", "no file of displacements");
    add("UTF-16", "a.csv",
        "\xFF\xFE"
        "1\t",
        "UTF-16");
    add("gzip", "a.vtu", "\x1F\x8B\x08", "gzip");
    add("only the mesh", "a.frd", frd.substr(0, frd.find("  100CL")), "no vectors at nodes");
    add("without mesh", "a.frd", "    1C\n" + frd.substr(frd.find("  100CL")), "no nodes");
    add("a letter in a number", "a.frd", replaced(frd, "3.33333E+01", "3.3X333E+01"), "at line");
    add("an image", "a.vtu", replaced(vtu, "type=\"UnstructuredGrid\"", "type=\"ImageData\""), "ImageData");
    add("LZ4", "a.vtu", replaced(vtu, "header_type", "compressor=\"vtkLZ4DataCompressor\" header_type"),
        "vtkLZ4DataCompressor");
    add("mismatched", "a.vtu", replaced(vtu, "0 0 -1", "1 2 3 0 0 -1"), "has 13 values for 12 nodes");
    add("half a vector", "a.vtu", replaced(vtu, "0 0 -1", "1 0 0 -1"), "damaged");
    add("an enormous count", "a.vtk", replaced(vtk, "POINTS 12", "POINTS 999999999999999"), "at line");
    add("an enormous grid", "a.vtk",
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 99999 99999 99999\nORIGIN 0 0 0\n"
        "SPACING 1 1 1\nPOINT_DATA 1\nVECTORS u float\n1 2 3\n",
        "no nodes");
    add("an old Gmsh", "a.msh", replaced(msh, "4.1", "1.5"), "version 1.5");
    add("an enormous mesh", "a.msh", replaced(msh, "$Nodes\n1 12", "$Nodes\n999999999999 12"), "at line");
    add("no values at all", "a.msh", msh.substr(0, msh.find("$NodeData")), "no vectors at nodes");
    add("no coordinates", "a.rpt", samples::report({sample()}, false), "write COORD");
    add("a model", "a.inp", samples::input(sample()), "without displacements");
    add("a collection of nothing", "a.pvd", "<VTKFile type=\"Collection\"></VTKFile>", "names no files");
    add("a collection of what is missing", "a.pvd",
        "<VTKFile type=\"Collection\"><DataSet timestep=\"0\" file=\"missing.vtu\"/></VTKFile>", "does not exist");
    add("no numbers", "a.txt", "nan nan nan 1 2 3\n1 2 3 nan nan nan\n", "no node in it has a displacement");
}

void FieldDamageTest::eachKindOfDamageHasItsSentence()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    QFETCH(QString, words);
    const std::string path = write(name.toStdString(), content.toStdString());
    std::string sentence;
    try {
        readField(path, {}, TaskControl::none());
    } catch (const Problem& problem) {
        sentence = problem.what();
    }
    QVERIFY2(sentence.find(words.toStdString()) != std::string::npos, sentence.c_str());
    QVERIFY2(isSentence(sentence, name.toStdString()), sentence.c_str());
}

/// Why what is read of some content is not as it should be; empty when it is.
std::string FieldDamageTest::flawOf(const std::string& content) const
{
    const std::string path = write("damaged", content);
    const auto check = [&](const auto& read) -> std::string {
        try {
            return read();
        } catch (const Problem& problem) {
            return isSentence(problem.what(), "damaged") ? "" : problem.what();
        } catch (const std::exception& error) {
            return std::string("no sentence: ") + error.what();
        }
    };
    const std::string flaw = check([&] {
        const FieldFile file = readField(path, {}, TaskControl::none());
        fieldFromBytes(fieldToBytes(file)); // which checks what it can
        return file.field.isEmpty() ? std::string("it is empty") : std::string();
    });
    if (!flaw.empty())
        return flaw;
    return check([&] {
        meshFromBytes(meshToBytes(readNodes(path, {}, TaskControl::none())));
        return std::string();
    });
}

void FieldDamageTest::whatIsCutOffAnywhereIsASentence()
{
    for (const std::string& file : soundFiles())
        for (std::size_t part = 1; part < 24; ++part) {
            const std::string flaw = flawOf(file.substr(0, file.size() * part / 24));
            QVERIFY2(flaw.empty(), (file.substr(0, 40) + ": " + flaw).c_str());
        }
}

void FieldDamageTest::damageIsASentenceOrASoundField()
{
    bool isSaid = false;
    const int said = qEnvironmentVariableIntValue("KNEAD_FUZZ_INPUTS", &isSaid);
    const int count = isSaid ? said : 1500;
    const auto seed = static_cast<std::uint64_t>(qEnvironmentVariableIntValue("KNEAD_FUZZ_SEED")) + 1;
    const std::vector<std::string> files = soundFiles();
    for (int i = 0; i < count; ++i) {
        fuzz::Random random(seed * 1'000'003 + static_cast<std::uint64_t>(i));
        std::string content = files[static_cast<std::size_t>(i) % files.size()];
        for (std::size_t changes = 1 + random.below(3); changes > 0; --changes)
            random.chance(60) ? fuzz::mutateText(content, random) : fuzz::mutateBytes(content, random);
        if (content.empty())
            continue;
        const std::string flaw = flawOf(content);
        if (!flaw.empty())
            std::filesystem::copy_file(m_folder.filePath("damaged").toStdString(),
                                       std::filesystem::temp_directory_path() / "knead-field-damage",
                                       std::filesystem::copy_options::overwrite_existing);
        QVERIFY2(flaw.empty(), (std::to_string(i) + ": " + flaw).c_str());
    }
}

void FieldDamageTest::bytesOfAnotherProcessAreChecked()
{
    const FieldFile file = readField(write("a.frd", samples::frd({sample()})), {}, TaskControl::none());
    const std::string sound = fieldToBytes(file);
    QCOMPARE(fieldFromBytes(sound).field.nodes.size(), file.field.nodes.size());
    for (std::size_t length = 0; length < sound.size(); length += 7)
        QVERIFY_THROWS_EXCEPTION(Problem, fieldFromBytes(std::string_view(sound).substr(0, length)));
}

QTEST_GUILESS_MAIN(FieldDamageTest)
#include "field_damage_test.moc"
