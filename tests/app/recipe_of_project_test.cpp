#include "app/recipe_files.h"
#include "io/recipe/recipe_reader.h"
// Sessions as recipes: carried out, they come to the same bits.
#include "app/cad_process.h"
#include "app/cad_program.h"
#include "app/thread_limit.h"
#include "core/session/recipe_runner.h"
#include "core/session/recipe_scene.h"
#include "io/project/project_file.h"
#include "io/recipe/recipe_of_project.h"
#include "support/random_lumps.h"
#include "support/same_values.h"
#include "support/sample_project.h"
#include "support/workshop.h"

#include <QtTest>

using namespace knead;
using namespace knead::sessions;
using workshop::json;

namespace {

const std::vector<MaterialPreset> presets{{"clay", "Clay", "a pit", scenes::clay()}};

} // namespace

class RecipeOfProjectTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        setCadProgram(cadProgramBeside(KNEAD_PROGRAM));
        m_model = std::make_shared<const Model>(importFile(writeLumps(m_shop.path("lumps.3mf"))));
        QCOMPARE(m_model->parts.size(), std::size_t{2});
    }

    void theRecipeComesToTheSameBits_data()
    {
        QTest::addColumn<int>("seed");
        QTest::addColumn<bool>("isRich");
        for (const int seed : {1, 2, 3, 4, 5, 6, 10}) { // 10: a grip is put on a body that was filled anew
            QTest::addRow("plain %d", seed) << seed << false;
            QTest::addRow("rich %d", seed) << seed << true;
        }
    }
    void theRecipeComesToTheSameBits()
    {
        QFETCH(int, seed);
        QFETCH(bool, isRich);
        const Scene scene = isRich ? richScene(*m_model) : restingScene(*m_model, lumpSpacing);
        bool isStopped = false;
        const Document document = randomDocument(scene, static_cast<std::uint64_t>(seed), isStopped);
        Project project = projectOf(document, m_model, {0, 1});
        project.import.paths = {m_shop.path("lumps.3mf")};
        const std::string text = write(project, "session.recipe.json").text;
        for (const unsigned threads : {1U, 2U}) {
            const ThreadLimit limit(threads);
            RunReport report;
            try {
                report = runRecipe(read("session.recipe.json"), recipeFiles(), m_shop.path("out"));
            } catch (const RunFailed& failure) { // where a session that is stopped goes back to is not in the recipe
                QVERIFY2(isStopped, failure.what());
                continue;
            }
            // Random sessions may be poor physics, which is said; nothing is said of what the recipe left out.
            const std::vector<Remark> poor = remarksOn(report.quality);
            for (const std::string& warning : report.warnings)
                QVERIFY2(warning.starts_with("Nothing moved") || warning.find("begins ") != std::string::npos ||
                             warning == report.fineness.warning.english() ||
                             std::any_of(poor.begin(), poor.end(),
                                         [&](const Remark& remark) { return remark.sentence.english() == warning; }),
                         warning.c_str());
            if (report.stateHash != document.simulation.stateHash())
                qInfo("%s", text.c_str());
            QCOMPARE(report.stateHash, document.simulation.stateHash());
            QCOMPARE(report.steps, document.simulation.stepCount());
        }
    }

    void theSceneIsTheSame()
    {
        bool isStopped = false;
        const Document document = randomDocument(richScene(*m_model), 20, isStopped);
        Project project = projectOf(document, m_model, {0, 1});
        project.import.paths = {m_shop.path("lumps.3mf")};
        write(project, "scene.recipe.json");
        const RecipeScene ready = buildScene(read("scene.recipe.json"), recipeFiles(), TaskControl::none());
        QVERIFY(same::values(ready.scene.bodies[0].aggregate, document.scene.bodies[0].aggregate));
        for (std::size_t i = 0; i < 2; ++i) {
            QCOMPARE(ready.scene.fixtures[i].objects, document.scene.fixtures[i].objects);
            QVERIFY(same::values(ready.scene.fixtures[i].velocity, document.scene.fixtures[i].velocity));
            QVERIFY(same::values(ready.scene.manipulators[i].pose, document.scene.manipulators[i].pose));
            QVERIFY(same::values(ready.scene.manipulators[i].size, document.scene.manipulators[i].size));
            QVERIFY(same::values(ready.scene.bodies[i].velocity, document.scene.bodies[i].velocity));
            QVERIFY(same::values(ready.scene.bodies[i].angularVelocity, document.scene.bodies[i].angularVelocity));
            QCOMPARE(ready.scene.bodies[0].regions[i].objects, document.scene.bodies[0].regions[i].objects);
        }
        QVERIFY(same::values(ready.scene.gravity, document.scene.gravity));
        QVERIFY(same::values(ready.scene.floorHeight, document.scene.floorHeight));
    }

    /// What a mouse did is one line for each gesture, in millimeters.
    void aPersonCanReadIt()
    {
        const Project project = pressedPart(KNEAD_RESOURCES "/examples/bracket.step", 0.004);
        const std::string text = write(project, "bracket.recipe.json").text;
        const json recipe = json::parse(text);
        QCOMPARE(recipe.at("part").size(), std::size_t{1});
        QCOMPARE(recipe.at("spacing_mm").get<double>(), 4.0);
        QVERIFY2(text.find("\"spacing_mm\": 4,\n") != std::string::npos, text.c_str());
        QVERIFY2(text.find("\"material\": {\"youngs_modulus_pa\": 2e+05") != std::string::npos ||
                     text.find("\"material\": {\"youngs_modulus_pa\": 200000") != std::string::npos,
                 text.c_str());
        std::vector<std::string> said;
        for (const json& event : recipe.at("events"))
            said.push_back(std::next(event.begin(), event.begin().key() == "step" ? 1 : 0).key());
        QCOMPARE(said, (std::vector<std::string>{"keep_moment", "add_manipulator", "keep_moment", "move_manipulator",
                                                 "keep_moment", "move_manipulator", "keep_moment"}));
        QCOMPARE(recipe.at("events")[4].at("keep_moment").get<std::string>(), std::string("Push with Block 1"));
        QCOMPARE(recipe.at("events")[3].at("move_manipulator").at("path").size(), std::size_t{60});
        QCOMPARE(recipe.at("duration_steps").get<std::uint64_t>(), project.entries[4].step);
        QVERIFY(workshop::lineCount(text) < 130);
        QVERIFY(readRecipe(m_shop.path("bracket.recipe.json"), presets).events.size() > 90);
    }

    void fixturesAreSaidByFacesOrBoxes()
    {
        Project project = pressedPart(KNEAD_RESOURCES "/examples/bracket.step", 0.004);
        const Part& part = project.model->parts[0];
        const Aggregate& aggregate = *project.starts[0].scene.bodies[0].aggregate;
        const std::vector<std::uint32_t> faces{0, 3};
        const Box corner(part.box.min() - Vec3::Constant(1), part.box.center());
        project.starts[0].scene.fixtures = {{"faces", 0, objectsAtFaces(aggregate, part.mesh, faces)},
                                            {"box", 0, objectsInBox(aggregate, corner)},
                                            {"others", 0, {2, 3, 9, 400}}};
        project.current = 0;
        const json fixtures = json::parse(write(project, "held.recipe.json").text).at("fixtures");
        QVERIFY2(fixtures[0].contains("faces"), fixtures.dump().c_str());
        QVERIFY2(fixtures[1].contains("box_mm"), fixtures.dump().c_str());
        QCOMPARE(fixtures[2].at("objects"), json::parse("[[2, 3], 9, 400]"));
        const RecipeScene ready = buildScene(read("held.recipe.json"), recipeFiles(), TaskControl::none());
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE(ready.scene.fixtures[i].objects, project.starts[0].scene.fixtures[i].objects);

        Recipe finer = read("held.recipe.json");
        finer.spacing.value = 0.003;
        try {
            buildScene(finer, recipeFiles(), TaskControl::none());
            QFAIL("numbers of objects belong to one filling");
        } catch (const UnusableInput& error) {
            QVERIFY2(std::string(error.what())
                         .starts_with(
                             "held.recipe.json: the fixture \"others\" names objects of a body that is filled with "),
                     error.what());
        }
        finer.fixtures.pop_back();
        QVERIFY(buildScene(finer, recipeFiles(), TaskControl::none()).scene.fixtures[0].objects.size() >
                project.starts[0].scene.fixtures[0].objects.size());
    }

    void bodiesOfOneNameAreToldApart()
    {
        Model model = *m_model;
        model.parts[0].name = model.parts[1].name = "Lump";
        model.parts[0].path = model.parts[1].path = "a/Lump";
        Document document(restingScene(model, lumpSpacing));
        document.simulation.post(SetMaterial{1, scenes::clay()});
        endGesture(document, "Material");
        Project project = projectOf(document, std::make_shared<const Model>(model), {0, 1});
        project.import.paths = {m_shop.path("lumps.3mf")};
        const auto bodyOf = [&] {
            const json event = json::parse(write(project, "names.recipe.json").text).at("events")[1];
            return event.at("body").get<std::string>();
        };
        QCOMPARE(bodyOf(), std::string("#1"));
        model.parts[1].path = "b/Lump";
        project.model = std::make_shared<const Model>(model);
        QCOMPARE(bodyOf(), std::string("b/Lump"));
    }

    void partsAndToolsComeFromTheProjectWhereFilesAreGone()
    {
        const Model& model = *m_model;
        Document document(restingScene(model, lumpSpacing));
        Manipulator part = sample::partManipulator(sample::toolPart(0.01 / 3));
        part.pose = shapes::tilt(0.3, Vec3(0, 0, 0.006));
        part.motion = DriveAt{Vec3(0, 0, -0.3), Vec3::Zero()};
        document.simulation.post(AddManipulator{part});
        document.simulation.post(ReshapeManipulator{.tool = 0,
                                                    .size = sample::toolPart(0.002)->size(),
                                                    .friction = 0.1,
                                                    .speedLimit = 1,
                                                    .kind = ToolKind::part,
                                                    .part = sample::toolPart(0.002)});
        for (int i = 0; i < 200; ++i)
            document.simulation.step();
        endGesture(document, "Push");
        Project project = projectOf(document, m_model, {0, 1});
        project.import.paths = {"/nowhere/lumps.3mf"};
        writeProject(m_shop.path("lumps.knead"), project);
        const RecipeOfProject recipe = write(project, "kept.recipe.json", m_shop.path("lumps.knead"));
        QCOMPARE(recipe.remarks.size(), std::size_t{1});
        QCOMPARE(json::parse(recipe.text).at("part").at("file").get<std::string>(), std::string("lumps.knead"));
        const RunReport report = runRecipe(read("kept.recipe.json"), recipeFiles(), m_shop.path("out"));
        QCOMPARE(report.stateHash, document.simulation.stateHash());
        QVERIFY(report.tools[0].peakForce > 0);
    }

    void whatWasBeforeARefillIsLeftOut()
    {
        Document document(restingScene(*m_model, lumpSpacing));
        fuzz::Random random(3);
        document.doSomething(random, 20);
        Project project = projectOf(document, m_model, {0, 1});
        project.import.paths = {m_shop.path("lumps.3mf")};
        Document refilled(restingScene(*m_model, 0.7 * lumpSpacing));
        refilled.doSomething(random, 50);
        project.starts.push_back({refilled.scene, {0, 1}});
        for (HistoryRecord record : refilled.history.records()) {
            record.parent = static_cast<std::uint32_t>(project.entries.size() - 1);
            record.start = 1;
            project.entries.push_back(record);
        }
        project.current = static_cast<std::uint32_t>(project.entries.size() - 1);
        const RecipeOfProject recipe = write(project, "refilled.recipe.json");
        QVERIFY(recipe.remarks.at(0).english().starts_with("The recipe begins where the part was filled last"));
        const RunReport report = runRecipe(read("refilled.recipe.json"), recipeFiles(), m_shop.path("out"));
        QCOMPARE(report.stateHash, refilled.simulation.stateHash());
    }

    /// By numbers or by a field: no file has the parts as they were filled last.
    void deformedPartsComeFromTheProject()
    {
        Document document(restingScene(*m_model, lumpSpacing));
        Project project = projectOf(document, m_model, {0, 1});
        project.import.paths = {m_shop.path("lumps.3mf")};
        Model longer = *m_model;
        for (Part& part : longer.parts)
            for (Vec3& vertex : part.mesh.vertices)
                vertex.x() *= 1.25;
        Document deformed(restingScene(longer, lumpSpacing));
        fuzz::Random random(5);
        deformed.doSomething(random, 30);
        project.starts.push_back({deformed.scene, {0, 1}, std::make_shared<const Model>(longer)});
        for (HistoryRecord record : deformed.history.records()) {
            record.parent = static_cast<std::uint32_t>(project.entries.size() - 1);
            record.start = 1;
            project.entries.push_back(record);
        }
        project.current = static_cast<std::uint32_t>(project.entries.size() - 1);
        QVERIFY_EXCEPTION_THROWN(write(project, "unsaved.recipe.json"), Problem);
        writeProject(m_shop.path("longer.knead"), project);
        const RecipeOfProject recipe = write(project, "longer.recipe.json", m_shop.path("longer.knead"));
        QVERIFY(recipe.remarks.at(0).english().starts_with("The parts were deformed by numbers or by a field"));
        QCOMPARE(json::parse(recipe.text).at("part").at("file").get<std::string>(), std::string("longer.knead"));
        const RunReport report = runRecipe(read("longer.recipe.json"), recipeFiles(), m_shop.path("out"));
        QCOMPARE(report.stateHash, deformed.simulation.stateHash());
    }

    void whatCannotBeSaidIsASentence()
    {
        const Document document(restingScene(*m_model, lumpSpacing));
        Project project = projectOf(document, m_model, {0, 1});
        const auto complaint = [&] {
            try {
                write(project, "never.recipe.json");
            } catch (const std::runtime_error& error) {
                return std::string(error.what());
            }
            return std::string();
        };
        QCOMPARE(complaint(),
                 std::string("A recipe cannot say what was done here: the files of its parts are not there "
                             "any more; save the project first."));
        project.import.paths = {m_shop.path("lumps.3mf")};
        QCOMPARE(complaint(), std::string());
        project.starts[0].scene.bodies.pop_back();
        project.starts[0].partOfBody = {0};
        QVERIFY(
            complaint().starts_with("A recipe cannot say what was done here: some of its parts could not be filled"));
        QVERIFY(!QFileInfo::exists(m_shop.qPath("never.knead")));
        project = Project{};
        QCOMPARE(complaint(), std::string("The project has nothing in it yet that a recipe could say."));
    }

    void settingsBeforeTheFirstStepCanBecomeTheStart()
    {
        Document document(restingScene(*m_model, lumpSpacing));
        document.simulation.post(SetMaterial{0, scenes::clay()});
        document.simulation.post(SetGravity{Vec3(0, 0, -9.81)});
        document.simulation.applyCommands();
        endGesture(document, "Settings");
        document.simulation.post(SetFloor{-0.02, 0.1});
        document.simulation.step();
        document.simulation.post(SetGravity{Vec3::Zero()});
        endGesture(document, "More");
        const Project settled = withSettingsFirst(projectOf(document, m_model, {0, 1}));
        const Scene& scene = settled.starts[0].scene;
        QCOMPARE(scene.bodies[0].material, scenes::clay());
        QCOMPARE(scene.bodies[1].material, scenes::soft());
        QCOMPARE(scene.gravity.z(), -9.81);
        QCOMPARE(*scene.floorHeight, -0.02);
        QCOMPARE(settled.entries[1].commands.size(), std::size_t{1});
        QCOMPARE(settled.entries[2].commands.size(), std::size_t{2});
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
