#include "app/recipe_files.h"
#include "io/recipe/recipe_reader.h"
// A recipe as the window plays it, without a window: the same as knead run does.
#include "app/cad_process.h"
#include "app/cad_program.h"
#include "app/gui.h"
#include "core/document/history.h"
#include "core/session/recipe_runner.h"
#include "core/simulation/moment.h"
#include "core/simulation/replay.h"
#include "support/busy_recipe.h"
#include "support/workshop.h"
#include "ui/services.h"

#include <QtTest>

using namespace knead;
using workshop::json;

class RecipeScriptTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        setCadProgram(cadProgramBeside(KNEAD_PROGRAM));
        m_services = fileServices();
        m_recipe = workshop::busyRecipe(std::string(KNEAD_RESOURCES) + "/examples/bar.step");
    }

    void itIsWhatRunningComesTo()
    {
        const Run run = started(m_recipe);
        QVERIFY(playToEnd(*run.simulation, *run.script));
        QCOMPARE(run.simulation->stateHash(), hashOfRunning(m_recipe));
        QVERIFY(!run.script->carryOutDue(*run.simulation)); // the end is said once
    }

    void gesturesThatAreRecordedCanBeRepeated()
    {
        json recipe = m_recipe;
        recipe["events"].push_back({{"time_s", 0.95}, {"keep_moment", "there"}});
        const Run run = started(recipe);
        QVERIFY(playToEnd(*run.simulation, *run.script));
        const Gesture gesture = endGesture(*run.simulation);
        QVERIFY(gesture.commands.size() >= 10);
        const Simulation again =
            replay(Simulation(run.start.start.scene), gesture.commands, gesture.moment->steps.count);
        QCOMPARE(again.stateHash(), gesture.hash);
        QCOMPARE(gesture.hash, hashOfRunning(recipe));
    }

    void goingBackGoesOnFromThere()
    {
        const Run run = started(m_recipe);
        stepTo(run, 0.11);
        const Gesture middle = gestureOf(run);
        QVERIFY(playToEnd(*run.simulation, *run.script));
        const Gesture end = gestureOf(run);
        for (const bool isKnown : {true, false}) {
            Simulation other(run.start.start.scene);
            const std::unique_ptr<ScriptedEvents> script = isKnown ? run.start.script() : opened(m_recipe).script();
            other.goTo(middle.moment);
            script->wentTo(*middle.moment, other.stateHash());
            QVERIFY(playToEnd(other, *script));
            QCOMPARE(other.stateHash(), end.hash);
        }
        run.simulation->goTo(end.moment);
        run.script->wentTo(*end.moment, end.hash);
        QVERIFY(!run.script->carryOutDue(*run.simulation)); // it has ended there
    }

    /// Until something touches a rigid body, its positions and velocities are the same at every step.
    void goingBackBeforeAnythingMovesLosesNoEvent()
    {
        const json recipe = workshop::lateRecipe(std::string(KNEAD_RESOURCES) + "/examples/bar.step");
        const Run run = started(recipe);
        const Gesture first = gestureOf(run);
        stepTo(run, 0.07);
        const Gesture middle = gestureOf(run);
        stepTo(run, 0.12);
        const Gesture late = gestureOf(run);
        QCOMPARE(late.hash, first.hash);
        QCOMPARE(run.simulation->snapshot()->tools.size(), std::size_t{1});
        for (const Gesture* gesture : {&late, &first, &middle}) {
            run.simulation->goTo(gesture->moment);
            run.script->wentTo(*gesture->moment, gesture->hash);
            QVERIFY(playToEnd(*run.simulation, *run.script));
            QCOMPARE(run.simulation->snapshot()->tools.size(), std::size_t{1});
            QCOMPARE(gestureOf(run).moment->around.gravity.z(), -2.0);
        }
        run.simulation->goTo(first.moment);
        run.script->wentTo(*first.moment, first.hash);
        QVERIFY(playToEnd(*run.simulation, *run.script));
        QCOMPARE(run.simulation->stateHash(), hashOfRunning(recipe));
    }

    void namesMeanTheToolsOfTheRecipe()
    {
        const Run run = started(m_recipe);
        run.simulation->post(AddManipulator{{.name = "mine", .size = Vec3::Constant(0.01)}});
        const Fixture hold{.name = "my hold", .body = 0, .objects = {0, 1, 2}, .velocity = Vec3::Zero()};
        run.simulation->post(AddFixture{hold});
        stepTo(run, 0.14);
        const auto now = run.simulation->snapshot();
        QCOMPARE(now->tools.size(), std::size_t{3});
        QCOMPARE(now->tools[2].name, std::string("second"));
        QVERIFY(now->tools[2].pose.position.z() < 0.0285); // driven, in place of mine
        QCOMPARE(now->tools[1].pose.position.z(), 0.0);
        QCOMPARE(now->fixtures.back().name, std::string("other end"));
        QVERIFY(playToEnd(*run.simulation, *run.script));
        const auto end = run.simulation->snapshot();
        QCOMPARE(end->tools.size(), std::size_t{2});
        QCOMPARE(end->tools[1].name, std::string("mine"));
        QCOMPARE(end->fixtures.back().name, std::string("my hold"));
    }

    void itBeginsAgainAfterReset()
    {
        const Run run = started(m_recipe);
        stepTo(run, 0.85);
        run.simulation->post(Reset{});
        QVERIFY(!run.script->carryOutDue(*run.simulation));
        QCOMPARE(run.simulation->stepCount(), std::uint64_t{0});
        stepTo(run, 0.14);
        const auto now = run.simulation->snapshot();
        QCOMPARE(now->tools.size(), std::size_t{2}); // the second is there since the first time
        QCOMPARE(now->fixtures.size(), std::size_t{2});
        QVERIFY(playToEnd(*run.simulation, *run.script));
        QCOMPARE(run.simulation->snapshot()->tools.size(), std::size_t{1});
    }

    /// After Reset, what the recipe had added is there; before it, it is not.
    void goingBackOverAResetKnowsWhatIsThere()
    {
        const Run run = started(m_recipe);
        const Gesture first = gestureOf(run);
        stepTo(run, 0.13);
        gestureOf(run);
        run.simulation->post(Reset{});
        run.simulation->applyCommands();
        const Gesture again = gestureOf(run);
        QCOMPARE(again.hash, first.hash);
        const std::unique_ptr<ScriptedEvents> other = run.start.script(); // as after going back over another filling
        for (ScriptedEvents* script : {run.script.get(), other.get()})
            for (const Gesture* gesture : {&again, &first, &again}) {
                Simulation simulation(run.start.start.scene);
                simulation.goTo(gesture->moment);
                script->wentTo(*gesture->moment, simulation.stateHash());
                while (simulation.time() < 0.14) {
                    script->carryOutDue(simulation);
                    simulation.step();
                }
                QCOMPARE(simulation.snapshot()->tools.size(), std::size_t{2});
                QCOMPARE(simulation.snapshot()->fixtures.size(), std::size_t{2});
            }
    }

    void resetsOfTheRecipeAreItsOwn()
    {
        json recipe = m_recipe;
        recipe["events"] = json::array({{{"time_s", 0.05}, {"gravity_m_s2", {0, 0, -9.81}}},
                                        {{"time_s", 0.1}, {"reset", true}},
                                        {{"time_s", 0.05}, {"gravity_m_s2", {0, 0, 0}}}});
        recipe["duration_s"] = 0.12;
        const Run run = started(recipe);
        QVERIFY(playToEnd(*run.simulation, *run.script));
        QCOMPARE(run.simulation->stateHash(), hashOfRunning(recipe));
    }

    void facesOfFixturesAreKnown()
    {
        const RecipeStart start = opened(m_recipe);
        QCOMPARE(start.fixtures.size(), std::size_t{2});
        QCOMPARE(start.fixtures[1].name, std::string("other end"));
        QVERIFY(start.fixtures[1].faces == std::vector<std::uint32_t>{1});
        QCOMPARE(start.model->parts.size(), std::size_t{1});
        QCOMPARE(start.model->unit, std::string("mm"));
        QVERIFY(start.model->parts[0].exact.has_value());
    }

    void aPublishedArrangementIsSaidAgain()
    {
        const std::string paper = std::string(KNEAD_RESOURCES) + "/examples/paper-bar.recipe.json";
        const RecipeStart start = m_services.recipes.open(paper, TaskControl::none());
        Simulation simulation(start.start.scene);
        const HistoryRecord first = recordOf(endGesture(simulation), "Open");
        for (int i = 0; i < 40; ++i)
            simulation.step();
        const HistoryRecord second = recordOf(endGesture(simulation), "Simulate");
        Project project{.model = start.model, .import = start.choices, .starts = {start.start}};
        project.entries = {first, second};
        project.current = 1;
        const std::string path = m_shop.path("paper-again.recipe.json");
        QVERIFY(m_services.recipes.write(path, project, {}).empty());
        QCOMPARE(runRecipe(readRecipe(path, m_services.materials), recipeFiles(), m_shop.path("out")).stateHash,
                 second.hash);
    }

    void whatDoesNotFitIsASentence_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("a face that is not there") << "fixtures"
                                                  << R"([{"name": "end", "faces": [9]}])"
                                                  << "has faces 0 to 5";
        QTest::newRow("a body that is not there")
            << "events"
            << R"([{"time_s": 0.1, "material": {"youngs_modulus_pa": 3e5}, "body": "lid"}])"
            << "lid";
        QTest::newRow("no key") << "spacings_mm"
                                << "3"
                                << "spacings_mm";
    }
    void whatDoesNotFitIsASentence()
    {
        QFETCH(QString, key);
        QFETCH(QString, value);
        QFETCH(QString, sentence);
        json recipe = m_recipe;
        recipe[key.toStdString()] = json::parse(value.toStdString());
        try {
            opened(recipe);
            QFAIL("it was opened");
        } catch (const std::runtime_error& error) {
            QVERIFY2(QString(error.what()).contains(sentence), error.what());
        }
    }

private:
    struct Run {
        RecipeStart start;
        std::unique_ptr<Simulation> simulation;
        std::unique_ptr<ScriptedEvents> script;
    };

    RecipeStart opened(const json& recipe)
    {
        return m_services.recipes.open(m_shop.write(recipe).toStdString(), TaskControl::none());
    }

    Run started(const json& recipe)
    {
        Run run{opened(recipe), nullptr, nullptr};
        run.simulation = std::make_unique<Simulation>(run.start.start.scene);
        run.script = run.start.script();
        return run;
    }

    static bool playToEnd(Simulation& simulation, ScriptedEvents& script)
    {
        for (int i = 0; i < 200'000; ++i) {
            if (script.carryOutDue(simulation))
                return true;
            simulation.step();
        }
        return false;
    }

    static void stepTo(const Run& run, double time)
    {
        while (run.simulation->time() < time) {
            run.script->carryOutDue(*run.simulation);
            run.simulation->step();
        }
    }

    static Gesture gestureOf(const Run& run)
    {
        Gesture gesture = endGesture(*run.simulation);
        run.script->ended(gesture);
        return gesture;
    }

    std::uint64_t hashOfRunning(const json& recipe)
    {
        const Recipe read = readRecipe(m_shop.write(recipe).toStdString(), m_services.materials);
        return runRecipe(read, recipeFiles(), m_shop.path("out")).stateHash;
    }

    workshop::Workshop m_shop;
    Services m_services;
    json m_recipe;
};

QTEST_GUILESS_MAIN(RecipeScriptTest)
#include "recipe_script_test.moc"
