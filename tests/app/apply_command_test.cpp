// knead apply: what was done to a part, done to its next revision.
#include "support/bracket_files.h"

#include "app/cad_process.h"
#include "app/cad_program.h"
#include "app/project_field.h"
#include "core/geometry/refine.h"
#include "core/geometry/surface_distance.h"
#include "io/project/packing.h"
#include "io/project/project_file.h"
#include "support/pressed_part.h"
#include "support/workshop.h"

#include <QtTest>

using namespace knead;
using namespace knead::sessions;
using namespace bracket_files;
using namespace workshop;

namespace {

constexpr double spacing = 0.003;
constexpr double radius = 0.009; // of the ball
constexpr double depth = 0.004;  // that it is pushed in

/// Off the middle, so that a mirror image is another shape.
const Vec3 pressed(0.022, 0.009, 0.008);

/// A ball that is pushed into the foot, which stands on its lower face.
Project pressedBracket(const std::string& file)
{
    const auto model = std::make_shared<const Model>(importFile(file));
    Scene scene = restingScene(*model, spacing);
    scene.floorHeight.reset();
    const Part& part = model->parts[0];
    std::vector<std::uint32_t> below;
    for (std::size_t t = 0; t < part.mesh.triangles.size(); ++t)
        if (cornersOf(part.mesh.vertices, part.mesh.triangles[t])[0].z() < 1e-6 &&
            crossOf(part.mesh.vertices, part.mesh.triangles[t]).normalized().z() < -0.99)
            below.push_back(part.mesh.faceOfTriangle[t]);
    std::ranges::sort(below);
    below.erase(std::ranges::unique(below).begin(), below.end());
    scene.fixtures = {{"ground", 0, objectsAtFaces(*scene.bodies[0].aggregate, part.mesh, below)}};
    Document document(scene);
    Manipulator ball{.name = "ball", .size = Vec3::Constant(2 * radius)};
    ball.kind = ToolKind::ball;
    ball.pose.position = pressed + Vec3(0, 0, radius + 0.1 * spacing);
    ball.speedLimit = 1;
    document.simulation.post(AddManipulator{ball});
    document.simulation.applyCommands();
    endGesture(document, "Add ball");
    drag(document, 0, ball.pose.position, Vec3(0, 0, -depth - 0.1 * spacing), 60);
    for (int i = 0; i < 60; ++i)
        document.simulation.step();
    endGesture(document, "Push with ball");
    Project project = projectOf(document, model, {0});
    project.import.paths = {file};
    return packed(std::move(project));
}

/// How far the surface around the dent of one file is from that of another one, where a map takes it: largest and mean [m].
template <class Map>
std::pair<double, double> distanceOfDents(const std::string& one, const std::string& other, const Map& map)
{
    const TriangleMesh there = importFile(other).parts.at(0).mesh;
    const SurfaceDistance surface(there);
    const TriangleMesh mesh = refine(importFile(one).parts.at(0).mesh, spacing / 2);
    double largest = 0;
    double sum = 0;
    double count = 0;
    for (const Vec3& vertex : mesh.vertices) {
        if ((vertex - pressed).head<2>().norm() > 1.2 * radius || vertex.z() < pressed.z() / 4)
            continue; // the wall is not far, and does not shift as the dent does
        const double distance = surface.nearest(map(vertex)).distance;
        largest = std::max(largest, distance);
        sum += distance;
        ++count;
    }
    return {largest, sum / std::max(count, 1.0)};
}

Vec3 shiftOf(const json& report, const std::string& what)
{
    for (const json& moved : report.at("transfer").at("moved"))
        if (moved.at("what") == what)
            return Vec3(moved.at("shift_mm")[0], moved.at("shift_mm")[1], moved.at("shift_mm")[2]) / 1000;
    return Vec3::Constant(1e9);
}

} // namespace

class ApplyCommandTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        setCadProgram(cadProgramBeside(KNEAD_PROGRAM));
        writeBracket(m_shop.path("old.step"), {});
        writeBracket(m_shop.path("new.step"), {.foot = 55, .footHole = 3.5, .wallHole = 3});
        writeBracket(m_shop.path("left.step"), {.isMirrored = true});
        writeBracket(m_shop.path("large.step"), {.scale = 2});
        writeProject(m_shop.path("session.knead"), pressedBracket(m_shop.path("old.step")));
        const Outcome outcome = workshop::runKnead(
            {"replay", m_shop.qPath("session.knead"), "--from-moments", "--export", m_shop.qPath("old-pressed.step")});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        // There is a dent that somebody could miss.
        const auto [largest, mean] =
            distanceOfDents(m_shop.path("old-pressed.step"), m_shop.path("old.step"), [](const Vec3& v) { return v; });
        QVERIFY2(largest > 0.7 * depth, qPrintable(QString::number(1000 * largest)));
        m_dentMean = mean;
    }

    void theNextRevisionHasTheSameDent()
    {
        const json report = applied({"new.step", "--output", m_shop.qPath("out")});
        QCOMPARE(report.at("transfer").at("faces_found"), 11);
        QVERIFY(report.at("transfer").at("left_out").empty());
        QVERIFY(report.at("run").at("exports")[0].at("sound").get<bool>());
        const Vec3 shift = shiftOf(report, "the tool \"ball\"");
        QVERIFY2(shift.x() > 0 && shift.x() < 0.005 && std::abs(shift.y()) < 1e-4 && std::abs(shift.z()) < 1e-4,
                 qPrintable(QString::number(shift.x())));
        verifyDent("out/new-deformed.step", [&](const Vec3& v) -> Vec3 { return v + shift; });
    }

    void theShapeIsCarriedWithoutASimulation()
    {
        const json report = applied({"new.step", "--output", m_shop.qPath("carried"), "--by-field"});
        QVERIFY(report.at("exports")[0].at("sound").get<bool>());
        const Vec3 shift = shiftOf(report, "the tool \"ball\"");
        const json& faces = report.at("exports")[0].at("parts")[0].at("faces");
        QCOMPARE(faces.at("before"), faces.at("after"));
        verifyDent("carried/new-deformed.step", [&](const Vec3& v) -> Vec3 { return v + shift; });
    }

    void aMirroredPartnerHasTheMirroredDent()
    {
        const json report = applied({"left.step", "--mirror", "y", "--output", m_shop.qPath("out")});
        QCOMPARE(report.at("transfer").at("faces_found"), 11);
        QVERIFY(report.at("run").at("exports")[0].at("sound").get<bool>());
        verifyDent("out/left-deformed.step", [](const Vec3& v) { return Vec3(v.x(), -v.y(), v.z()); });
    }

    void aRecipeIsWrittenThatCanBeRun()
    {
        const json report = applied({"large.step", "--scale", "auto", "--recipe", m_shop.qPath("large.recipe.json")});
        QVERIFY(std::abs(report.at("transfer").at("scale").get<double>() - 2) < 1e-3);
        const json recipe = json::parse(std::ifstream(m_shop.path("large.recipe.json")));
        QCOMPARE(recipe.at("part").at("file").get<std::string>(), std::string("large.step"));
        QVERIFY(std::abs(recipe.at("spacing_mm").get<double>() - 2000 * spacing) < 0.01);
        double last = 0; // of its events
        for (const json& event : recipe.at("events"))
            last = std::max(last, event.value("time_s", 0.0));
        const Outcome outcome = workshop::runKnead(
            {"run", m_shop.qPath("large.recipe.json"), "--out", m_shop.qPath("large"), "--set",
             QString("duration_s=%1").arg(1.01 * last, 0, 'g', 17), "--set", "exports=[]", "--json"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        QVERIFY(json::parse(outcome.out).at("tools").size() == 1);
    }

    void aProjectIsAField()
    {
        const FieldFile field = projectField(m_shop.path("session.knead"), {}, TaskControl::none());
        QCOMPARE(field.steps.size(), std::size_t{3});
        QCOMPARE(field.step, std::size_t{2});
        QCOMPARE(field.field.nodes.size(), field.field.displacements.size());
        double lowest = 0;
        for (std::size_t i = 0; i < field.field.nodes.size(); ++i)
            if ((field.field.nodes[i] - pressed).norm() < spacing)
                lowest = std::min(lowest, field.field.displacements[i].z());
        QVERIFY2(lowest < -0.7 * depth, qPrintable(QString::number(1000 * lowest)));
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, projectField(m_shop.path("old.step"), {}, TaskControl::none()));
        QVERIFY_THROWS_EXCEPTION(std::runtime_error,
                                 projectField(m_shop.path("session.knead"), 0, TaskControl::none())); // nothing moved
    }

    void whatIsNotThereIsSaid()
    {
        const QString session = m_shop.qPath("session.knead");
        QCOMPARE(workshop::runKnead({"apply", session, m_shop.qPath("new.step")}).status, 2);
        QCOMPARE(workshop::runKnead({"apply", m_shop.qPath("old.step"), m_shop.qPath("new.step"), "-o", "x"}).status,
                 2);
        QCOMPARE(workshop::runKnead({"apply", session, m_shop.qPath("none.step"), "-o", m_shop.qPath("x")}).status, 2);
        QCOMPARE(workshop::runKnead({"apply", session, m_shop.qPath("new.step"), "-o", "x", "--mirror", "q"}).status,
                 2);
        QCOMPARE(workshop::runKnead({"apply", session, m_shop.qPath("new.step"), "-o", "x", "--scale", "0"}).status, 2);
        QCOMPARE(workshop::runKnead({"apply", session, m_shop.qPath("new.step"), "-o", "x", "--entry", "9"}).status, 2);
    }

private:
    json applied(const QStringList& arguments)
    {
        QStringList all{"apply", m_shop.qPath("session.knead"), m_shop.qPath(arguments[0].toStdString())};
        const Outcome outcome = workshop::runKnead(all + arguments.mid(1) + QStringList{"--json"});
        if (outcome.status != 0)
            qWarning("%s", outcome.errors.c_str());
        return outcome.status == 0 ? json::parse(outcome.out) : json();
    }

    template <class Map>
    void verifyDent(const std::string& file, const Map& map)
    {
        const auto [largest, mean] = distanceOfDents(m_shop.path("old-pressed.step"), m_shop.path(file), map);
        const QString said =
            QString("%1 mm, mean %2 mm of %3 mm").arg(1000 * largest).arg(1000 * mean).arg(1000 * m_dentMean);
        QVERIFY2(largest < spacing / 2, qPrintable(said));
        QVERIFY2(mean < 0.2 * m_dentMean, qPrintable(said));
        qInfo("%s: %s", file.c_str(), qPrintable(said));
    }

    Workshop m_shop;
    double m_dentMean = 0; ///< of the dent from the part without it [m]
};

QTEST_GUILESS_MAIN(ApplyCommandTest)
#include "apply_command_test.moc"
