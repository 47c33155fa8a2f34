#include "core/geometry/mass_properties.h"
#include "io/importer.h"
#include "support/workshop.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>

using namespace knead;
using namespace workshop;

namespace {

const std::string examples = std::string(KNEAD_RESOURCES) + "/examples/";

/// The closed surfaces of a mesh that hang together each for itself, as their volumes; none when some surface is open.
std::vector<double> shellVolumes(const TriangleMesh& mesh)
{
    if (!isWatertight(mesh))
        return {};
    std::vector<std::size_t> root(mesh.vertices.size());
    for (std::size_t i = 0; i < root.size(); ++i)
        root[i] = i;
    const auto find = [&](std::size_t i) {
        while (root[i] != i)
            i = root[i] = root[root[i]];
        return i;
    };
    for (const TriangleMesh::Triangle& t : mesh.triangles)
        for (const std::uint32_t corner : {t[1], t[2]})
            root[find(corner)] = find(t[0]);
    std::map<std::size_t, double> volumes;
    for (const TriangleMesh::Triangle& t : mesh.triangles)
        volumes[find(t[0])] += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6;
    std::vector<double> result;
    for (const auto& [shell, volume] : volumes)
        result.push_back(volume);
    return result;
}

double sum(const std::vector<double>& numbers)
{
    return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

} // namespace

/// Examples whole: simulated, exported, read back.
class ExampleRunsTest : public QObject {
    Q_OBJECT

private slots:
    void brokenPartsComeAsClosedPieces_data();
    void brokenPartsComeAsClosedPieces();
    void exportedExamplesAreSound_data();
    void exportedExamplesAreSound();

private:
    Workshop m_shop;
};

void ExampleRunsTest::brokenPartsComeAsClosedPieces_data()
{
    QTest::addColumn<QString>("part");
    QTest::addColumn<QString>("recipe");
    QTest::addColumn<QString>("result");
    QTest::addColumn<int>("leastPieces");
    QTest::addColumn<double>("volumeError");
    QTest::newRow("shattered plate") << "plate.step"
                                     << "shatter-plate"
                                     << "plate-shattered" << 3 << 0.01;
    // Rubber between two blades is squeezed: the pieces have the volume that it has then.
    QTest::newRow("severed bar") << "bar.step"
                                 << "cut-bar"
                                 << "bar-cut" << 2 << 0.01;
}

void ExampleRunsTest::brokenPartsComeAsClosedPieces()
{
    QFETCH(QString, part);
    QFETCH(QString, recipe);
    QFETCH(QString, result);
    QFETCH(int, leastPieces);
    QFETCH(double, volumeError);
    const QString file = QString::fromStdString(examples) + recipe + ".recipe.json";
    const Outcome outcome = workshop::runKnead({"run", file, "--out", m_shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    QVERIFY(report.at("objects").get<int>() <= 3000);
    for (const json& one : report.at("exports"))
        QVERIFY2(one.at("sound").get<bool>(), one.dump().c_str());

    const std::string path = m_shop.path("out/" + result.toStdString());
    const Part whole = importFile(examples + part.toStdString()).parts.front();
    const Model cad = importFile(path + ".step", {.heal = false});
    QVERIFY(cad.parts.size() >= static_cast<std::size_t>(leastPieces));
    std::vector<double> volumes;
    for (std::size_t i = 0; i < cad.parts.size(); ++i) {
        const Part& piece = cad.parts[i];
        QCOMPARE(piece.name, whole.name + ", piece " + std::to_string(i + 1));
        QCOMPARE(piece.solids, 1);
        QVERIFY2(piece.watertight && piece.valid && piece.openEdges.empty(), piece.name.c_str());
        QVERIFY(piece.color && std::abs(piece.color->r - whole.color->r) < 0.01F);
        volumes.push_back(piece.volume);
    }
    qInfo("%zu pieces, volume %.5f of the whole", volumes.size(), sum(volumes) / whole.volume);
    QVERIFY(std::abs(sum(volumes) / whole.volume - 1) < volumeError);

    const Model mesh = importFile(path + ".stl", {.heal = false, .unit = "mm"});
    QCOMPARE(mesh.parts.size(), std::size_t{1});
    const std::vector<double> shells = shellVolumes(mesh.parts.front().mesh);
    // What broke out of the middle of a piece leaves a void.
    QCOMPARE(std::ranges::count_if(shells, [](double volume) { return volume > 0; }), std::ssize(volumes));
    QVERIFY(std::abs(sum(shells) / sum(volumes) - 1) < 1e-3);
}

void ExampleRunsTest::exportedExamplesAreSound_data()
{
    QTest::addColumn<QString>("recipe");
    QTest::addColumn<QString>("file");
    QTest::newRow("paper bar") << "paper-bar"
                               << "paper-bar-pushed.step";
    QTest::newRow("clay") << "press-clay"
                          << "clay-pressed.step";
}

/// As the program itself says of the file.
void ExampleRunsTest::exportedExamplesAreSound()
{
    QFETCH(QString, recipe);
    QFETCH(QString, file);
    const QString path = QString::fromStdString(examples) + recipe + ".recipe.json";
    const Outcome outcome = workshop::runKnead({"run", path, "--out", m_shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    for (const json& one : json::parse(outcome.out).at("exports"))
        QVERIFY2(one.at("sound").get<bool>(), one.dump().c_str());
    const Outcome info = workshop::runKnead({"info", m_shop.qPath("out/" + file.toStdString()), "--json"});
    QVERIFY2(info.status == 0, info.errors.c_str());
    for (const json& part : json::parse(info.out).at("parts")) {
        QVERIFY2(part.at("watertight").get<bool>(), info.out.c_str());
        QVERIFY2(part.at("valid").get<bool>(), info.out.c_str());
    }
}

QTEST_GUILESS_MAIN(ExampleRunsTest)
#include "example_runs_test.moc"
