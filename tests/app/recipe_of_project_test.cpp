// Sessions as recipes: carried out, they come to the same bits.
#include "app/cad_process.h"
#include "app/recipe_runner.h"
#include "app/thread_limit.h"
#include "io/mesh_writer.h"
#include "io/project/project_file.h"
#include "io/project/recipe_of_project.h"
#include "support/pressed_part.h"
#include "support/same_values.h"
#include "support/workshop.h"

#include <QtTest>

using namespace knead;
using namespace knead::sessions;
using workshop::json;

namespace {

const std::vector<MaterialPreset> presets{{"clay", "Clay", "a pit", scenes::clay()}};

/// The scene of two lumps as files have it.
std::string writeLumps(const std::string& path)
{
    const auto lump = [](const std::string& name, double size, double height) {
        return MeshBody{name, Color{},
                        shapes::moved(shapes::box(Vec3::Constant(size)), scenes::placedAt(Vec3(0, 0, height)))};
    };
    writeMeshes(path, {lump("Lump", 4 * lumpSpacing, 0), lump("Lump", 2 * lumpSpacing, 6 * lumpSpacing)});
    return path;
}

/// Everything that scenes and commands can say, at random.
Command anyMove(fuzz::Random& random)
{
    const auto number = [&] { return 1e-6 * static_cast<double>(random.below(20'001)) / 3 - 0.003; };
    const Pose place = shapes::tilt(100 * number(), Vec3(number(), number(), 0.01 + number()));
    const auto tool = static_cast<ToolId>(random.below(3));
    Manipulator cylinder{.name = random.chance(50) ? "roller \"1\"" : "", .size = Vec3(0.003, 0.003, 0.01 / 3)};
    cylinder.kind = ToolKind::cylinder;
    cylinder.pose = place;
    cylinder.friction = 1.0 / 3;
    cylinder.speedLimit = 0.7 / 3;
    cylinder.forceLimit = random.chance(50) ? 1.0 / 3 : std::numeric_limits<double>::infinity();
    cylinder.motion = DriveAt{Vec3(number(), number(), -0.1), Vec3(number(), 1.0 / 3, 0)};
    switch (random.below(9)) {
    case 0:
        return SetManipulatorMotion{tool, DriveAt{100 * place.position, Vec3(number(), 1, number())}};
    case 1:
        return SetManipulatorMotion{tool, HoldStill{}};
    case 2:
        return SetManipulatorMotion{tool, FollowKeyFrames{{{1e-3 / 3, place}, {0.01 / 3, Pose{}}, {0.2, place}}}};
    case 3:
        return AddManipulator{cylinder};
    case 4:
        return ReshapeManipulator{.tool = tool,
                                  .size = Vec3::Constant(0.01 / 3),
                                  .friction = 0.1,
                                  .speedLimit = 0.3,
                                  .kind = random.chance(50) ? ToolKind::ball : ToolKind::wedge};
    case 5:
        return Renormalize{0, {3, 4, 5, 90}, random.chance(50) ? 0 : 1e-3 / 3};
    case 6:
        return SetMaterial{1, scenes::clay(), {2, 5, 6}};
    case 7:
        return KeepMoment{};
    default:
        return SetManipulatorMotion{tool, GoTo{place}};
    }
}

Document randomDocument(const Scene& scene, std::uint64_t seed)
{
    fuzz::Random random(seed);
    Document document(scene);
    for (int i = 0; i < 12; ++i) {
        if (random.chance(25))
            document.visit(static_cast<Entry>(random.below(document.history.records().size())));
        for (std::size_t n = random.below(12); n > 0; --n) {
            document.simulation.post(random.chance(60) ? anyMove(random) : anyCommand(random));
            for (std::size_t steps = random.below(5); steps > 0; --steps)
                document.simulation.step();
        }
        endGesture(document, "gesture " + std::to_string(i));
    }
    return document;
}

/// A scene in which every key of a recipe has something to say.
Scene richScene(const Model& model)
{
    Scene scene = restingScene(model, lumpSpacing);
    scene.bodies[0].velocity = Vec3(0, 0, 0.1 / 3);
    scene.bodies[1].velocity = Vec3(0, 0.01 / 7, -0.3);
    scene.bodies[1].angularVelocity = Vec3(1.0 / 3, 0, 20);
    scene.bodies[1].material = scenes::clay();
    scene.bodies[0].regions = {{"", {1, 2, 3}, scenes::clay()}, {"soft", {7, 9, 40}, scenes::soft(0.1)}};
    scene.floorHeight = -2.5 * lumpSpacing;
    scene.floorFriction = 1.0 / 3;
    scene.gravity = Vec3(0, 0, -9.81);
    scene.touching = Touching::glued;
    scene.vicinity = VicinityMethod::halfPartition;
    scene.integrator = Integrator::automatic;
    scene.fixtures = {{"hold", 0, {0, 1, 2, 3, 4}, {}}, {"hold", 1, {0, 5, 11}, Vec3(0, 0, 0.01 / 3)}};
    scene.manipulators = scenes::smallPress(scenes::soft(), 4).manipulators;
    scene.manipulators.push_back(scene.manipulators[0]);
    scene.manipulators[1].motion = GoTo{shapes::tilt(0.3, Vec3(0.02, 0, 0.01))};
    return scene;
}

} // namespace

class RecipeOfProjectTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        setCadProgram(KNEAD_PROGRAM);
        m_model = std::make_shared<const Model>(importFile(writeLumps(m_shop.path("lumps.3mf"))));
        QCOMPARE(m_model->parts.size(), std::size_t{2});
    }

    void theRecipeComesToTheSameBits_data()
    {
        QTest::addColumn<int>("seed");
        QTest::addColumn<bool>("isRich");
        for (int seed = 1; seed <= 6; ++seed) {
            QTest::addRow("plain %d", seed) << seed << false;
            QTest::addRow("rich %d", seed) << seed << true;
        }
    }
    void theRecipeComesToTheSameBits()
    {
        QFETCH(int, seed);
        QFETCH(bool, isRich);
        const Scene scene = isRich ? richScene(*m_model) : restingScene(*m_model, lumpSpacing);
        const Document document = randomDocument(scene, static_cast<std::uint64_t>(seed));
        Project project = projectOf(document, m_model, {0, 1});
        project.import.paths = {m_shop.path("lumps.3mf")};
        const std::string text = write(project, "session.recipe.json").text;
        for (const unsigned threads : {1U, 2U}) {
            const ThreadLimit limit(threads);
            const RunReport report = runRecipe(read("session.recipe.json"), m_shop.path("out"));
            QVERIFY2(report.warnings.empty(), report.warnings.empty() ? "" : report.warnings[0].c_str());
            if (report.stateHash != document.simulation.stateHash())
                qInfo("%s", text.c_str());
            QCOMPARE(report.stateHash, document.simulation.stateHash());
            QCOMPARE(report.steps, document.simulation.stepCount());
        }
    }

private:
    RecipeOfProject write(const Project& project, const std::string& name, const std::string& projectPath = {})
    {
        RecipeOfProject recipe =
            recipeOfProject(project, {.recipePath = m_shop.path(name), .projectPath = projectPath}, presets);
        std::ofstream(m_shop.path(name)) << recipe.text;
        return recipe;
    }
    Recipe read(const std::string& name) { return readRecipe(m_shop.path(name), presets); }

    workshop::Workshop m_shop;
    std::shared_ptr<const Model> m_model;
};

QTEST_GUILESS_MAIN(RecipeOfProjectTest)
#include "recipe_of_project_test.moc"
