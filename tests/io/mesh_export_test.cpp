#include "core/geometry/mass_properties.h"
#include "core/model/file_formats.h"
#include "io/formats/mesh_writer.h"
#include "io/formats/vtp/base64_sink.h"
#include "io/importer.h"
#include "support/shapes.h"

#include <QtTest>

#include <algorithm>
#include <bit>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <string>

#include <malloc.h>
#include <sys/resource.h>

using namespace knead;
using namespace std::string_literals;

namespace {

namespace fs = std::filesystem;

constexpr Color red{0.8F, 0.2F, 0.0F};
constexpr Color blue{0.0F, 0.4F, 1.0F};
constexpr Color green{0.2F, 0.8F, 0.2F};

TriangleMesh torus(std::uint32_t around = 40, std::uint32_t aroundTube = 24)
{
    return shapes::moved(shapes::torus(0.03, 0.01, around, aroundTube), shapes::tilt(0.7, Vec3(0.2, -0.1, 0.05)));
}

/// A box whose faces -x and +z have colors of their own; its triangles are in no order of color.
MeshBody paintedBox()
{
    MeshBody body{"box", blue, shapes::box(Vec3(0.01, 0.02, 0.03))};
    std::swap(body.mesh.triangles[0], body.mesh.triangles[6]);
    std::swap(body.mesh.faceOfTriangle[0], body.mesh.faceOfTriangle[6]);
    body.faceColors = {red, {}, {}, {}, {}, green};
    return body;
}

bool isNear(const Color& a, const Color& b)
{
    return std::abs(a.r - b.r) < 0.003F && std::abs(a.g - b.g) < 0.003F && std::abs(a.b - b.b) < 0.003F;
}

Color colorAt(const Part& part, std::size_t triangle)
{
    const std::optional<Color> own =
        part.faces.empty() ? std::nullopt : part.faces[part.mesh.faceOfTriangle[triangle]].color;
    return own.value_or(part.color.value_or(Color{1, 1, 1}));
}

std::string contentOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Normals and corners of a text.
std::vector<float> stlNumbers(const std::string& content)
{
    std::vector<float> numbers;
    std::istringstream words(content);
    for (std::string word; words >> word;)
        if (word == "normal" || word == "vertex")
            for (int i = 0; i < 3; ++i) {
                words >> word;
                numbers.push_back(std::strtof(word.c_str(), nullptr));
            }
    return numbers;
}

/// Places of the vertices of a text.
std::vector<float> plyNumbers(const std::string& content)
{
    std::vector<float> numbers;
    std::istringstream lines(content.substr(content.find("end_header\n") + 11));
    for (std::string line; std::getline(lines, line) && !line.starts_with("3 ");) {
        std::istringstream words(line);
        std::string word;
        for (int i = 0; i < 3; ++i) {
            words >> word;
            numbers.push_back(std::strtof(word.c_str(), nullptr));
        }
    }
    return numbers;
}

/// The disk refuses files beyond some bytes.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit limit{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &m_before); }

private:
    rlimit m_before{};
};

class CancelledLater final : public TaskControl {
public:
    void report(double, std::string_view) override { ++m_reports; }
    bool isCancelled() const override { return m_reports > 1; }

private:
    int m_reports = 0;
};

/// What writeMeshes() says when it fails; empty when it does not.
std::string complaint(const std::string& path, const std::vector<MeshBody>& bodies, const ExportOptions& options = {})
{
    try {
        writeMeshes(path, bodies, options);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

/// Kilobytes that /proc says about this process.
long memoryOf(const std::string& what)
{
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == what + ":") {
            long size = 0;
            status >> size;
            return size;
        }
    return 0;
}

} // namespace

class MeshExportTest : public QObject {
    Q_OBJECT

private slots:
    void namesInAnyScriptComeBack_data();
    void namesInAnyScriptComeBack();
    void bodiesOfOneNameStayApart_data();
    void bodiesOfOneNameStayApart();
    void colorsOfFacesComeBack_data();
    void colorsOfFacesComeBack();
    void plyHasColorsOfFaces();
    void unitIsKeptOrSaid_data();
    void unitIsKeptOrSaid();
    void unitThatNobodyKnowsIsRefused();
    void unitThatThreeMfDoesNotKnowIsRefused();
    void textAndBinaryAgree_data();
    void textAndBinaryAgree();
    void glbAndGltfHoldTheSameNumbers();
    void base64EqualsThatOfQt();
    void emptyBodiesAreLeftOut_data();
    void emptyBodiesAreLeftOut();
    void nothingAtAllIsRefused_data();
    void nothingAtAllIsRefused();
    void infinitePointsAreRefused();
    void fileNamesMayHaveSpacesQuotesAndLetters_data();
    void fileNamesMayHaveSpacesQuotesAndLetters();
    void fullDiskLeavesOldFiles_data();
    void fullDiskLeavesOldFiles();
    void unwritableTargetGivesOneSentence_data();
    void unwritableTargetGivesOneSentence();
    void cancelLeavesOldFile_data();
    void cancelLeavesOldFile();
    void largeMeshesStream_data();
    void largeMeshesStream();

private:
    std::string path(const std::string& name) const { return m_folder.path().toStdString() + "/" + name; }
    static void addEndings(const std::vector<const char*>& endings)
    {
        QTest::addColumn<QString>("ending");
        for (const char* ending : endings)
            QTest::newRow(ending) << ending;
    }
    static void addAllEndings()
    {
        std::vector<const char*> endings;
        for (const FileFormat& format : fileFormats)
            for (const std::string& ending : format.endings)
                if (!format.isSmooth)
                    endings.push_back(ending.c_str());
        addEndings(endings);
    }

    QTemporaryDir m_folder;
};

void MeshExportTest::namesInAnyScriptComeBack_data()
{
    addEndings({"obj", "glb", "gltf", "3mf"});
}

void MeshExportTest::namesInAnyScriptComeBack()
{
    QFETCH(QString, ending);
    const std::vector<std::string> names{"Bügel", "歯車", "шестерня \"2\" <b> & 'c'", "ترس", "🔩"};
    std::vector<MeshBody> bodies;
    for (const std::string& name : names)
        bodies.push_back({name, red,
                          shapes::moved(shapes::box(Vec3(0.01, 0.01, 0.01)),
                                        {Vec3(0.02 * static_cast<double>(bodies.size()), 0, 0)})});
    const std::string file = path("names." + ending.toStdString());
    writeMeshes(file, bodies);
    const Model model = importFile(file);
    QCOMPARE(model.warnings.size(), std::size_t(ending == "obj")); // that it states no unit
    QCOMPARE(model.parts.size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::string expected = names[i];
        if (ending == "obj")
            std::replace(expected.begin(), expected.end(), ' ', '_');
        QCOMPARE(model.parts[i].name, expected);
        QVERIFY(std::abs(model.parts[i].box.center().x() - 0.02 * static_cast<double>(i)) < 1e-6);
    }
}

void MeshExportTest::bodiesOfOneNameStayApart_data()
{
    addEndings({"glb", "gltf", "3mf"});
}

void MeshExportTest::bodiesOfOneNameStayApart()
{
    QFETCH(QString, ending);
    const std::string file = path("nuts." + ending.toStdString());
    const TriangleMesh box = shapes::box(Vec3(0.01, 0.01, 0.01));
    writeMeshes(file, {{"nut", red, box}, {"nut", blue, shapes::moved(box, {Vec3(0.05, 0, 0)})}, {"", green, torus()}});
    const Model model = importFile(file);
    QCOMPARE(model.parts.size(), std::size_t(3));
    QCOMPARE(model.parts[0].name, std::string("nut"));
    QCOMPARE(model.parts[1].name, std::string("nut"));
    QCOMPARE(model.parts[2].name, std::string("part"));
    QVERIFY(isNear(model.parts[0].color.value(), red) && isNear(model.parts[1].color.value(), blue));
    QVERIFY(std::abs(model.parts[1].box.center().x() - 0.05) < 1e-6);
}

void MeshExportTest::colorsOfFacesComeBack_data()
{
    addEndings({"obj", "glb", "gltf", "3mf"});
}

void MeshExportTest::colorsOfFacesComeBack()
{
    QFETCH(QString, ending);
    const std::string file = path("painted." + ending.toStdString());
    writeMeshes(file, {paintedBox(), {"ring", green, torus()}});
    const Model model = importFile(file);
    QCOMPARE(model.parts.size(), std::size_t(2));
    const Part& box = model.parts[0];
    QVERIFY(box.watertight);
    QVERIFY(std::abs(box.volume / 6e-6 - 1) < 1e-5);
    QCOMPARE(box.mesh.triangles.size(), std::size_t(12));
    for (std::size_t t = 0; t < 12; ++t) {
        Vec3 middle = Vec3::Zero();
        for (const std::uint32_t vertex : box.mesh.triangles[t])
            middle += box.mesh.vertices[vertex] / 3;
        const Color expected = middle.x() < -0.0049 ? red : middle.z() > 0.0149 ? green : blue;
        QVERIFY(isNear(colorAt(box, t), expected));
    }
    QVERIFY(model.parts[1].watertight);
    QVERIFY(isNear(model.parts[1].color.value(), green));
    QVERIFY(model.parts[1].faces.empty());
}

void MeshExportTest::plyHasColorsOfFaces()
{
    writeMeshes(path("painted.ply"), {paintedBox()}, {.isText = true});
    std::ifstream file(path("painted.ply"));
    std::map<std::string, int> lines; // by their colors
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("3 ")) {
            std::istringstream words(line);
            int number = 0;
            for (int i = 0; i < 4; ++i)
                words >> number;
            std::string color;
            std::getline(words, color);
            ++lines[color];
        }
    QCOMPARE(lines, (std::map<std::string, int>{{" 204 51 0", 2}, {" 0 102 255", 8}, {" 51 204 51", 2}}));
    QVERIFY(importFile(path("painted.ply")).parts.front().watertight);
    writeMeshes(path("painted2.ply"), {paintedBox()});
    QVERIFY(importFile(path("painted2.ply")).parts.front().watertight);
}

void MeshExportTest::unitIsKeptOrSaid_data()
{
    QTest::addColumn<QString>("ending");
    QTest::addColumn<QString>("unit");
    for (const char* ending : {"stl", "obj", "ply", "3mf", "glb"})
        for (const char* unit : {"inch", "m", "um"})
            QTest::newRow((std::string(ending) + " in " + unit).c_str()) << ending << unit;
}

void MeshExportTest::unitIsKeptOrSaid()
{
    QFETCH(QString, ending);
    QFETCH(QString, unit);
    const std::string file = path("unit." + ending.toStdString());
    const TriangleMesh written = torus();
    writeMeshes(file, {{"ring", red, written}}, {.unit = unit.toStdString()});
    const bool isStated = ending == "3mf" || ending == "glb";
    const Model model = importFile(file, {.unit = isStated ? "" : unit.toStdString()});
    QCOMPARE(model.unit, ending == "glb" ? "m" : unit.toStdString());
    const Part& part = model.parts.front();
    QVERIFY(part.watertight);
    QCOMPARE(part.mesh.vertices.size(), written.vertices.size());
    QVERIFY(std::abs(part.volume / massProperties(written).volume - 1) < 1e-5);
    QVERIFY((part.box.min() - massProperties(written).box.min()).norm() < 1e-7);
    if (!isStated)
        QVERIFY(contentOf(file).substr(0, 200).find("Knead, lengths in " + unit.toStdString()) != std::string::npos);
}

void MeshExportTest::unitThatNobodyKnowsIsRefused()
{
    const std::string said = complaint(path("cubit.stl"), {paintedBox()}, {.unit = "cubit"});
    QVERIFY(said.starts_with("cubit.stl: the length unit \"cubit\" is not known"));
    QVERIFY(!fs::exists(path("cubit.stl")));
}

void MeshExportTest::unitThatThreeMfDoesNotKnowIsRefused()
{
    const std::string said = complaint(path("mile.3mf"), {paintedBox()}, {.unit = "mile"});
    QVERIFY(said.starts_with("mile.3mf: 3MF does not know the length unit mile"));
    QVERIFY(!fs::exists(path("mile.3mf")));
}

void MeshExportTest::textAndBinaryAgree_data()
{
    addEndings({"stl", "ply"});
}

void MeshExportTest::textAndBinaryAgree()
{
    QFETCH(QString, ending);
    const std::string text = path("text." + ending.toStdString());
    const std::string binary = path("binary." + ending.toStdString());
    writeMeshes(text, {{"ring", red, torus()}}, {.isText = true});
    writeMeshes(binary, {{"ring", red, torus()}}, {.isText = false});
    const std::string content = contentOf(text);
    QVERIFY(std::all_of(content.begin(), content.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
    const std::vector<float> numbers = ending == "stl" ? stlNumbers(content) : plyNumbers(content);
    const std::string bytes = contentOf(binary);
    const std::size_t begin = ending == "stl" ? 84 : bytes.find("end_header\n") + 11;
    const std::size_t count = ending == "stl" ? 12 : 3; // numbers, and the bytes behind them
    const std::size_t stride = ending == "stl" ? 50 : 15;
    QCOMPARE(numbers.size(), count * (ending == "stl" ? torus().triangles.size() : torus().vertices.size()));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        float number = 0;
        std::memcpy(&number, bytes.data() + begin + i / count * stride + i % count * sizeof number, sizeof number);
        QCOMPARE(std::bit_cast<std::uint32_t>(numbers[i]), std::bit_cast<std::uint32_t>(number));
    }
    const Part one = importFile(text).parts.front();
    const Part other = importFile(binary).parts.front();
    QCOMPARE(one.mesh.triangles, other.mesh.triangles);
    QCOMPARE(one.color, other.color);
}

void MeshExportTest::glbAndGltfHoldTheSameNumbers()
{
    writeMeshes(path("same.glb"), {paintedBox(), {"ring", green, torus()}});
    writeMeshes(path("same.gltf"), {paintedBox(), {"ring", green, torus()}});
    const Model one = importFile(path("same.glb"));
    const Model other = importFile(path("same.gltf"));
    for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE(one.parts[i].mesh.vertices, other.parts[i].mesh.vertices);
        QCOMPARE(one.parts[i].mesh.triangles, other.parts[i].mesh.triangles);
    }
}

void MeshExportTest::base64EqualsThatOfQt()
{
    struct Text final : ByteSink {
        std::string text;
        void write(std::string_view bytes) override { text += bytes; }
    };
    const std::string bytes = "\x00\xFF\x10\xFE~K.\x80nead"s;
    for (std::size_t size = 0; size < 12; ++size)
        for (std::size_t piece = 1; piece < 6; ++piece) {
            Text written;
            Base64Sink sink(written);
            for (std::size_t at = 0; at < size; at += piece)
                sink.write(std::string_view(bytes).substr(at, std::min(piece, size - at)));
            sink.finish();
            const QByteArray expected(bytes.data(), static_cast<qsizetype>(size));
            QCOMPARE(written.text, expected.toBase64().toStdString());
        }
}

void MeshExportTest::emptyBodiesAreLeftOut_data()
{
    addEndings({"stl", "obj", "ply", "glb", "gltf", "3mf"});
}

void MeshExportTest::emptyBodiesAreLeftOut()
{
    QFETCH(QString, ending);
    const std::string file = path("some." + ending.toStdString());
    MeshBody points{"points", red, shapes::box(Vec3(1, 1, 1))};
    points.mesh.triangles.clear();
    writeMeshes(file, {{"nothing", red, {}}, {"ring", blue, torus()}, points});
    const Model model = importFile(file);
    QCOMPARE(model.parts.size(), std::size_t(1));
    QVERIFY(model.parts.front().watertight);
}

void MeshExportTest::nothingAtAllIsRefused_data()
{
    addAllEndings();
}

void MeshExportTest::nothingAtAllIsRefused()
{
    QFETCH(QString, ending);
    const std::string name = "nothing." + ending.toStdString();
    QCOMPARE(complaint(path(name), {{"nothing", red, {}}}), name + ": there is no surface to write.");
    QVERIFY(!fs::exists(path(name)));
}

void MeshExportTest::infinitePointsAreRefused()
{
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e300}) {
        MeshBody body = paintedBox();
        body.mesh.vertices[3].y() = bad;
        QVERIFY(complaint(path("far.obj"), {body}).starts_with("far.obj: the surface of \"box\" leads to infinity"));
        QVERIFY(!fs::exists(path("far.obj")) && !fs::exists(path("far.mtl")));
    }
}

void MeshExportTest::fileNamesMayHaveSpacesQuotesAndLetters_data()
{
    addEndings({"stl", "obj", "ply", "glb", "gltf", "3mf"});
}

void MeshExportTest::fileNamesMayHaveSpacesQuotesAndLetters()
{
    QFETCH(QString, ending);
    const std::string file = path("mein \"Teil\" 歯車's." + ending.toStdString());
    writeMeshes(file, {{"ring", red, torus()}});
    const Part part = importFile(file).parts.front();
    QVERIFY(part.watertight);
    if (ending != "stl")
        QVERIFY(isNear(part.color.value(), red));
}

void MeshExportTest::fullDiskLeavesOldFiles_data()
{
    addAllEndings();
}

void MeshExportTest::fullDiskLeavesOldFiles()
{
    QFETCH(QString, ending);
    QVERIFY(QDir(m_folder.path()).mkpath("full"));
    const std::string file = path("full/old." + ending.toStdString());
    writeMeshes(file, {{"box", red, shapes::box(Vec3(0.01, 0.01, 0.01))}});
    const std::string old = contentOf(file);
    const std::string oldColors = contentOf(path("full/old.mtl"));
    const auto files = QDir(m_folder.path() + "/full").entryList(QDir::Files | QDir::Hidden);
    std::string said;
    {
        const FullDisk disk(10'000);
        said = complaint(file, {{"ring", blue, torus(100, 60)}});
    }
    QVERIFY(said.starts_with("old." + ending.toStdString() + ": the file cannot be written ("));
    QCOMPARE(contentOf(file), old);
    QCOMPARE(contentOf(path("full/old.mtl")), oldColors);
    QCOMPARE(QDir(m_folder.path() + "/full").entryList(QDir::Files | QDir::Hidden), files);
}

void MeshExportTest::unwritableTargetGivesOneSentence_data()
{
    addAllEndings();
}

void MeshExportTest::unwritableTargetGivesOneSentence()
{
    QFETCH(QString, ending);
    const std::string name = "ring." + ending.toStdString();
    const std::string said = complaint(path("missing/" + name), {{"ring", red, torus()}});
    QVERIFY(said.find("the file cannot be written (No such file or directory)") != std::string::npos);
    QVERIFY(!fs::exists(path("missing")));
}

void MeshExportTest::cancelLeavesOldFile_data()
{
    addAllEndings();
}

void MeshExportTest::cancelLeavesOldFile()
{
    QFETCH(QString, ending);
    const std::string file = path("cancelled." + ending.toStdString());
    writeMeshes(file, {{"box", red, shapes::box(Vec3(0.01, 0.01, 0.01))}});
    const std::string old = contentOf(file);
    CancelledLater control;
    QVERIFY_EXCEPTION_THROWN(writeMeshes(file, {{"ring", blue, torus(400, 200)}}, {}, control), Cancelled);
    QCOMPARE(contentOf(file), old);
}

void MeshExportTest::largeMeshesStream_data()
{
    addAllEndings();
}

/// A second copy of the surface, and be it as the bytes of a file, would not fit into what memory may grow by.
void MeshExportTest::largeMeshesStream()
{
    QFETCH(QString, ending);
    mallopt(M_MMAP_THRESHOLD, 1 << 17); // large blocks come from the system and go back at once
    const std::string file = path("large." + ending.toStdString());
    const std::vector<MeshBody> bodies{{"ring", red, torus(2000, 500)}}; // two million triangles
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5; // forgets the peak
    const long before = memoryOf("VmRSS");
    writeMeshes(file, bodies);
    const long grown = memoryOf("VmHWM") - before;
    const auto written = static_cast<long>(fs::file_size(file) / 1024);
    // glTF: eight bytes a vertex for which color uses it.
    const long most = ending.startsWith("gl") ? 12'000 : 3'000;
    QVERIFY2(grown < most, qPrintable(QString("%1 kB for a file of %2 kB").arg(grown).arg(written)));
    QVERIFY(written > 10'000);
    fs::remove(file);
}

QTEST_GUILESS_MAIN(MeshExportTest)
#include "mesh_export_test.moc"
