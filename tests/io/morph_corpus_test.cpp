#include "core/aggregate/fill.h"
#include "core/simulation/simulation.h"
#include "io/export/exporter.h"
#include "io/importer.h"
#include "support/deep.h"
#include "support/skip.h"
#include "support/space_maps.h"

#include <QtTest>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <numbers>
#include <set>
#include <tuple>

using namespace knead;

// Closed valid solids of the corpus through several maps, written as STEP and read back: the table is printed as it grows.
// Without further wishes only files o0* and parts of up to 30 faces are taken, in depth 60; KNEAD_FILES=o* and
// KNEAD_MOST_FACES=100000 take all, some of which need minutes each; KNEAD_LEAST_FACES leaves small ones out. KNEAD_PART takes
// only parts of a name, KNEAD_MAP only a map; KNEAD_NUMBERS=1 takes deformations by number instead of maps, KNEAD_FOLDER=hard
// another folder of the corpus.

namespace {

constexpr double leastShare = 0.98;   // of pairs that are exact and sound
constexpr double medianVolume = 1e-4; // of their relative volume errors

struct Row {
    bool isExact = false;
    bool isSound = false;
    double volumeError = 0;
    double share = 0; ///< largest deviation by tolerance
    double kink = 0;  ///< across edges that were smooth [degrees]
    double seconds = 0;
    std::size_t bytes = 0;
    std::string reason;
};

/// Two cells across its walls, as far as that can be simulated quickly: where a wall has gaps in the lattice, the material is torn,
/// and its surface with it.
double spacingFor(const Part& part)
{
    const double wall = 2 * part.volume / part.area;
    return std::max(std::min(spacingForCellsAcross(part.mesh, 16), wall / 2), spacingForObjectCount(part.mesh, 60'000));
}

/// Pressed between two plates by a tenth of its thinnest side.
/// @throws std::runtime_error when it is too thin for so few objects
PartToExport squeezed(const Part& part)
{
    PartToExport out{.part = part};
    out.aggregate = std::make_shared<const Aggregate>(fill(part.mesh, {.spacing = spacingFor(part)}));
    Eigen::Index axis = 0;
    const Vec3 sides = part.box.sizes();
    sides.minCoeff(&axis);
    Material rubber;
    rubber.youngsModulus = 2e5;
    rubber.dampingRatio = 0.3;
    rubber.shapeDamping = 50;
    Scene scene;
    scene.bodies.push_back({.name = part.name, .aggregate = out.aggregate, .material = rubber});
    scene.gravity = Vec3::Zero();
    const double thickness = sides[axis];
    for (const double side : {-1.0, 1.0}) {
        Manipulator plate{.name = side < 0 ? "lower" : "upper"};
        plate.size = 1.2 * sides;
        plate.size[axis] = 0.5 * thickness;
        plate.pose.position = part.box.center();
        plate.pose.position[axis] += side * 0.76 * thickness;
        Vec3 goal = plate.pose.position;
        goal[axis] -= side * 0.06 * thickness;
        plate.motion = GoTo{{goal, Quaternion::Identity()}};
        scene.manipulators.push_back(plate);
    }
    Simulation simulation(std::move(scene));
    // As long as sound takes to cross the part several times.
    const double steps = 40 * part.box.diagonal().norm() / out.aggregate->lattice.spacing;
    for (int step = 0; step < steps && simulation.health().ok; ++step)
        simulation.step();
    out.displacements = simulation.snapshot()->bodies[0].displacements();
    return out;
}

/// Along the longest side, between a quarter and three quarters of it, toward the shortest one.
NumberDeformation byNumber(const Part& part, NumberKind kind)
{
    const Vec3 sides = part.box.sizes();
    Eigen::Index longest = 0;
    Eigen::Index shortest = 0;
    sides.maxCoeff(&longest);
    sides.minCoeff(&shortest);
    if (shortest == longest)
        shortest = (longest + 1) % 3;
    return {.kind = kind,
            .origin = part.box.center(),
            .axis = Vec3::Unit(longest),
            .side = Vec3::Unit(shortest),
            .from = -sides[longest] / 4,
            .to = sides[longest] / 4};
}

std::vector<std::pair<std::string, PartToExport>> jobsByNumber(const Part& part)
{
    std::vector<std::pair<std::string, PartToExport>> jobs;
    const auto add = [&](const char* name, const NumberDeformation& deformation) {
        PartToExport job{.part = part};
        job.deformations = std::make_shared<const std::vector<Deformation>>(1, deformation);
        jobs.emplace_back(name, std::move(job));
    };
    NumberDeformation bend = byNumber(part, NumberKind::bend);
    bend.angle = std::numbers::pi / 6;
    add("bend", bend);
    NumberDeformation twist = byNumber(part, NumberKind::twist);
    twist.angle = std::numbers::pi / 6;
    add("twist", twist);
    NumberDeformation taper = byNumber(part, NumberKind::taper);
    taper.factor = 0.8;
    add("taper", taper);
    NumberDeformation stretch = byNumber(part, NumberKind::stretch);
    stretch.factor = 1.2;
    add("stretch", stretch);
    return jobs;
}

std::vector<std::pair<std::string, PartToExport>> jobsOf(const Part& part)
{
    if (qEnvironmentVariableIsSet("KNEAD_NUMBERS"))
        return jobsByNumber(part);
    const double size = part.box.diagonal().norm();
    std::vector<std::pair<std::string, PartToExport>> jobs;
    const auto add = [&](const char* name, std::shared_ptr<const SmoothMap> map) {
        jobs.emplace_back(name, PartToExport{.part = part, .map = std::move(map)});
    };
    add("identity", std::make_shared<maps::Identity>());
    add("bend", std::make_shared<maps::Bend>(part.box, std::numbers::pi / 2));
    add("twist", std::make_shared<maps::Twist>(part.box, std::numbers::pi / 2));
    add("dent", std::make_shared<maps::Dent>(part.box.max(), -0.08 * part.box.sizes(), 0.15 * size));
    try {
        jobs.emplace_back("squeeze", squeezed(part));
    } catch (const std::runtime_error& error) {
        std::printf("%s is not squeezed: %s\n", part.name.c_str(), error.what());
    }
    return jobs;
}

/// KNEAD_KEEP names a folder for files that are not sound, to be looked at.
void keep(const ExportedFile& file, const std::string& name)
{
    const QString folder = qEnvironmentVariable("KNEAD_KEEP");
    if (folder.isEmpty())
        return;
    QFile out(folder + "/" + QString::fromStdString(name) + ".step");
    if (out.open(QIODevice::WriteOnly))
        out.write(file.bytes.data(), static_cast<qint64>(file.bytes.size()));
}

Row tryOne(const PartToExport& part, const std::string& map)
{
    ExportJob job{.parts = {part}};
    job.tree.children.push_back({part.part.name, 0, {}});
    Row row;
    try {
        const ExportedFile file = exportCad(FormatKind::Step, job, TaskControl::none());
        const PartExportReport& report = file.report.parts.front();
        row.isExact = report.form == PartExportReport::Form::exact;
        row.isSound =
            report.isFit(); // the floor is of that; where surfaces cross or lost their smoothness is told beside it
        row.volumeError = std::abs(report.volumeError());
        row.share = report.largestDeviation / report.tolerance;
        row.kink = report.largestKink * 180 / std::numbers::pi;
        row.seconds = file.report.seconds;
        row.bytes = file.bytes.size();
        row.reason = report.reason.english();
        if (!report.isSound())
            keep(file, part.part.name + " " + map);
        if (row.isExact && !report.isSound())
            row.reason = !report.remarks.empty() ? report.remarks.back().english()
                         : !report.valid         ? "not valid"
                         : !report.closed        ? "not closed"
                                                 : "volume or deviation";
    } catch (const std::exception& error) {
        row.reason = error.what();
    }
    return row;
}

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

class MorphCorpusTest : public QObject {
    Q_OBJECT
private slots:
    void solidsComeThroughMapsAndFiles_data();
    void solidsComeThroughMapsAndFiles();
    void theFloorHolds();

private:
    void tryAll(const QString& file, const Part& part);

    std::map<std::string, std::pair<int, int>> m_counts; // sound and all, by map
    std::vector<double> m_volumeErrors;
    std::vector<double> m_seconds;
    int m_pairs = 0;
    int m_sound = 0;
};

void MorphCorpusTest::solidsComeThroughMapsAndFiles_data()
{
    QTest::addColumn<QString>("file");
    const QString folder = qEnvironmentVariable("KNEAD_CORPUS");
    const QString pattern = qEnvironmentVariable("KNEAD_FILES", "o0*");
    if (folder.isEmpty())
        QTest::newRow("no corpus") << QString();
    for (const QDir kind(folder + "/" + qEnvironmentVariable("KNEAD_FOLDER", "open"));
         const QString& file : kind.entryList({pattern}, QDir::Files))
        if (!folder.isEmpty() && !file.endsWith(".tsv"))
            QTest::newRow(qPrintable(file)) << kind.filePath(file);
}

void MorphCorpusTest::solidsComeThroughMapsAndFiles()
{
    QFETCH(QString, file);
    if (file.isEmpty())
        KNEAD_SKIP_WITHOUT("corpus", "The environment variable KNEAD_CORPUS names no corpus folder.");
    const auto mostFaces = qEnvironmentVariable("KNEAD_MOST_FACES", loadOf("30", "60")).toULongLong();
    const auto leastFaces = qEnvironmentVariable("KNEAD_LEAST_FACES", "0").toULongLong();
    const Model model = importFile(file.toStdString());
    std::set<std::tuple<std::size_t, long>> seen; // instances of a part are tried once
    for (const Part& part : model.parts)
        if (part.faces.size() >= leastFaces && part.faces.size() <= mostFaces && part.exact && part.valid &&
            part.watertight && seen.insert({part.faces.size(), std::lround(1e15 * part.volume)}).second)
            tryAll(QFileInfo(file).fileName(), part);
}

void MorphCorpusTest::tryAll(const QString& file, const Part& part)
{
    if (!qEnvironmentVariable("KNEAD_PART", QString::fromStdString(part.name)).contains(part.name.c_str()))
        return;
    for (const auto& [name, job] : jobsOf(part)) {
        if (!qEnvironmentVariable("KNEAD_MAP", name.c_str()).contains(name.c_str()))
            continue;
        const Row row = tryOne(job, name);
        const bool isGood = row.isExact && row.isSound;
        ++m_pairs;
        m_sound += isGood ? 1 : 0;
        m_counts[name].first += isGood ? 1 : 0;
        ++m_counts[name].second;
        m_seconds.push_back(row.seconds);
        if (row.isExact)
            m_volumeErrors.push_back(row.volumeError);
        std::printf("%-32s %-20.20s %5zu faces  %-8s %-9s deviation %5.2f of allowed, volume %8.1e, kink %5.2f deg, "
                    "%6.2f s, %5.1f kB/face %s\n",
                    qPrintable(file), part.name.c_str(), part.faces.size(), name.c_str(),
                    isGood        ? "sound"
                    : row.isExact ? "NOT SOUND"
                                  : "flat",
                    row.share, row.volumeError, row.kink, row.seconds,
                    1e-3 * static_cast<double>(row.bytes) / static_cast<double>(part.faces.size()), row.reason.c_str());
        std::fflush(stdout);
    }
}

void MorphCorpusTest::theFloorHolds()
{
    if (m_pairs == 0)
        QSKIP("No part was tried.");
    for (const auto& [name, count] : m_counts)
        std::printf("%-8s %d of %d\n", name.c_str(), count.first, count.second);
    QVERIFY(!m_volumeErrors.empty());
    std::printf("%d of %d pairs come out exact and sound; median volume error %.1e, median of %.2f s\n", m_sound,
                m_pairs, medianOf(m_volumeErrors), medianOf(m_seconds));
    QVERIFY(m_sound >= leastShare * m_pairs);
    QVERIFY(medianOf(m_volumeErrors) < medianVolume);
}

QTEST_GUILESS_MAIN(MorphCorpusTest)
#include "morph_corpus_test.moc"
