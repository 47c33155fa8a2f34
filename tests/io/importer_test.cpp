#include "core/aggregate/fill.h"
#include "core/geometry/mass_properties.h"
#include "io/importer.h"

#include <QtTest>

#include <filesystem>
#include <fstream>
#include <set>

using namespace knead;

namespace {

std::string example(const std::string& name)
{
    return std::string(KNEAD_RESOURCES) + "/examples/" + name;
}

/// What importFile() says about a file it refuses; empty when it does not.
std::string refusalOf(const std::string& path)
{
    try {
        importFile(path);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

bool mentions(const std::string& sentence, const std::string& words)
{
    return sentence.find(words) != std::string::npos;
}

class CancelAt final : public TaskControl {
public:
    explicit CancelAt(double fraction)
        : m_fraction(fraction)
    {
    }

    void report(double fraction, std::string_view) override { m_reached = std::max(m_reached, fraction); }
    bool isCancelled() const override { return m_reached >= m_fraction; }

private:
    double m_fraction;
    double m_reached = 0;
};

class ProgressList final : public TaskControl {
public:
    void report(double fraction, std::string_view) override { fractions.push_back(fraction); }
    bool isCancelled() const override { return false; }

    std::vector<double> fractions;
};

const char* const smallestBrep = "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nLocations 0\n";

} // namespace

class ImporterTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void barHasItsExactMeasures();
    void assemblyKeepsNamesPathsAndColors();
    void closedPartsBecomeWatertightMeshes();
    void meshVolumeIsWithinAThousandthOfCad();
    void trianglesKnowTheirFace();
    void finerDeflectionComesCloser();
    void filledVolumeIsWithinAThousandthOfCad();
    void contentDecidesNotTheEnding();
    void byteOrderMarkIsSkipped();
    void refusalNamesFileAndCause_data();
    void refusalNamesFileAndCause();
    void missingFileAndFolderAreNamed();
    void longNamesAreShortened();
    void cancelStopsTheImport();
    void progressNeverRunsBackwards();

private:
    std::string write(const std::string& name, const std::string& bytes) const;

    QTemporaryDir m_folder;
    Model m_bracket;
    std::vector<Model> m_examples;
};

std::string ImporterTest::write(const std::string& name, const std::string& bytes) const
{
    const std::string path = m_folder.path().toStdString() + "/" + name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

void ImporterTest::initTestCase()
{
    QVERIFY(m_folder.isValid());
    for (const std::string name : {"bar.step", "bracket.step", "handle.step"})
        m_examples.push_back(importFile(example(name)));
    m_bracket = m_examples[1];
}

void ImporterTest::barHasItsExactMeasures()
{
    const Model& model = m_examples[0];
    QCOMPARE(model.format, std::string("STEP AP214"));
    QCOMPARE(model.unit, std::string("mm"));
    QCOMPARE(model.parts.size(), std::size_t(1));
    const Part& bar = model.parts.front();
    QCOMPARE(bar.name, std::string("Bar"));
    QCOMPARE(bar.solids, 1);
    QCOMPARE(bar.shells, 1);
    QCOMPARE(bar.faces.size(), std::size_t(6));
    QCOMPARE(bar.edges, 12);
    QVERIFY(bar.watertight && bar.valid && bar.warnings.empty());
    QVERIFY(std::abs(bar.volume - 64000e-9) < 1e-12);
    QVERIFY(std::abs(bar.area - 13600e-6) < 1e-10);
    QVERIFY((bar.box.sizes() - Vec3(0.16, 0.02, 0.02)).norm() < 1e-9);
    QCOMPARE(bar.mesh.vertices.size(), std::size_t(8));
    QCOMPARE(bar.mesh.triangles.size(), std::size_t(12));
}

void ImporterTest::assemblyKeepsNamesPathsAndColors()
{
    QCOMPARE(m_bracket.parts.size(), std::size_t(2));
    QCOMPARE(m_bracket.parts[0].name, std::string("Bracket"));
    QCOMPARE(m_bracket.parts[0].path, std::string("bracket/Bracket"));
    QCOMPARE(m_bracket.parts[1].name, std::string("Bushing"));
    QCOMPARE(m_bracket.tree.children.size(), std::size_t(1));
    QCOMPARE(m_bracket.tree.children[0].name, std::string("bracket"));
    QCOMPARE(m_bracket.tree.children[0].children.size(), std::size_t(2));
    QCOMPARE(*m_bracket.tree.children[0].children[1].part, std::size_t(1));
    const Color blue = m_bracket.parts[0].color.value();
    QVERIFY(std::abs(blue.r - 0.27F) < 0.005F && std::abs(blue.g - 0.47F) < 0.005F &&
            std::abs(blue.b - 0.68F) < 0.005F);
    QVERIFY(m_bracket.parts[1].color.has_value());
    QVERIFY(!(m_bracket.parts[1].color == m_bracket.parts[0].color));
}

void ImporterTest::closedPartsBecomeWatertightMeshes()
{
    for (const Model& model : m_examples)
        for (const Part& part : model.parts) {
            QVERIFY2(part.canBeFilled(), part.path.c_str());
            QVERIFY2(isWatertight(part.mesh), part.path.c_str());
        }
}

void ImporterTest::meshVolumeIsWithinAThousandthOfCad()
{
    for (const Model& model : m_examples)
        for (const Part& part : model.parts)
            QVERIFY2(std::abs(massProperties(part.mesh).volume / part.volume - 1) < 1e-3, part.path.c_str());
}

void ImporterTest::trianglesKnowTheirFace()
{
    const Part& part = m_bracket.parts.front();
    QCOMPARE(part.mesh.faceOfTriangle.size(), part.mesh.triangles.size());
    const std::set<std::uint32_t> used(part.mesh.faceOfTriangle.begin(), part.mesh.faceOfTriangle.end());
    QCOMPARE(used.size(), part.faces.size());
    QCOMPARE(*used.rbegin() + 1, part.faces.size());
}

void ImporterTest::finerDeflectionComesCloser()
{
    double before = 1;
    for (const double deflection : {1e-3, 2e-4, 4e-5}) {
        const Part bushing = importFile(example("bracket.step"), {deflection, 1.0}).parts[1];
        const double error = std::abs(massProperties(bushing.mesh).volume / bushing.volume - 1);
        QVERIFY(error < 0.5 * before);
        before = error;
    }
}

void ImporterTest::filledVolumeIsWithinAThousandthOfCad()
{
    for (const Model& model : m_examples)
        for (const Part& part : model.parts) {
            const Aggregate aggregate = fill(part.mesh, {.spacing = spacingForCellsAcross(part.mesh, 20)});
            QVERIFY2(std::abs(aggregate.filledVolume / part.volume - 1) < 1e-3, part.path.c_str());
        }
}

void ImporterTest::contentDecidesNotTheEnding()
{
    const std::string renamed = m_folder.path().toStdString() + "/really_step.stl";
    std::filesystem::copy_file(example("bar.step"), renamed);
    QCOMPARE(importFile(renamed).format, std::string("STEP AP214"));
}

void ImporterTest::byteOrderMarkIsSkipped()
{
    std::ifstream file(example("bar.step"), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const Model model = importFile(write("marked.step", "\xEF\xBB\xBF" + bytes));
    QCOMPARE(model.parts.size(), std::size_t(1));
}

void ImporterTest::refusalNamesFileAndCause_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("cause");
    using namespace std::string_literals;
    const auto row = [](const char* name, const std::string& bytes, const char* cause) {
        QTest::newRow(name) << QByteArray::fromStdString(bytes) << cause;
    };
    const std::string head = "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n";
    const std::string tail = "ENDSEC;\nEND-ISO-10303-21;\n";
    row("empty", "", "is empty");
    row("zip", "PK\x03\x04 and more", "zip archive");
    row("gzip", "\x1F\x8B\x08 and more", "gzip archive");
    row("utf16", "\xFF\xFEI\0S\0O\0"s, "UTF-16");
    row("pdf", "%PDF-1.7 and more", "PDF");
    row("text", "Dear Ann,\nplease find the part enclosed.\n", "this is a text");
    row("binary", "\x01\x02\x03\x04\x05\x06"s, "none of STEP");
    row("truncated", head + "#1=CARTESIAN_POINT('',(0.,0.,0.));\n", "cut off");
    row("insideText", "ISO-10303-21;\nHEADER;\nFILE_NAME('bra", "cut off");
    row("noShapes", head + tail, "no shape");
    row("noSolid", head + "#1=CARTESIAN_POINT('',(0.,0.,0.));\n" + tail, "no shape");
    row("notANumber", head + "#1=CARTESIAN_POINT('',(0.,NaN,0.));\n" + tail, "NAN");
    row("deepList", head + "#1=X(" + std::string(100'000, '(') + std::string(100'000, ')') + ");\n" + tail, "nested");
    row("brep", smallestBrep, "BREP file is cut off");
}

void ImporterTest::refusalNamesFileAndCause()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, cause);
    const std::string sentence = refusalOf(write("given.step", bytes.toStdString()));
    QVERIFY2(sentence.starts_with("given.step: "), sentence.c_str());
    QVERIFY2(mentions(sentence, cause.toStdString()), sentence.c_str());
    QVERIFY2(sentence.ends_with('.'), sentence.c_str());
}

void ImporterTest::missingFileAndFolderAreNamed()
{
    QCOMPARE(refusalOf("/no/such/place/gear.step"), std::string("gear.step: the file does not exist."));
    QVERIFY(mentions(refusalOf(m_folder.path().toStdString()), "is a folder"));
}

void ImporterTest::longNamesAreShortened()
{
    const std::string sentence = refusalOf(write(std::string(240, 'n') + ".step", ""));
    QVERIFY2(sentence.size() < 120 && mentions(sentence, ".step: the file is empty"), sentence.c_str());
}

void ImporterTest::cancelStopsTheImport()
{
    for (const double fraction : {0.0, 0.2, 0.6}) {
        CancelAt control(fraction);
        QVERIFY_EXCEPTION_THROWN(importFile(example("handle.step"), {}, control), Cancelled);
    }
}

void ImporterTest::progressNeverRunsBackwards()
{
    ProgressList list;
    importFile(example("handle.step"), {}, list);
    QVERIFY(list.fractions.size() > 3);
    QVERIFY(std::is_sorted(list.fractions.begin(), list.fractions.end()));
    QCOMPARE(list.fractions.back(), 1.0);
}

QTEST_GUILESS_MAIN(ImporterTest)
#include "importer_test.moc"
