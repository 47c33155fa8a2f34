#include "core/session/recipe_runner.h"

#include "core/message/message.h"
#include "core/model/file_names.h"
#include "core/model/number_words.h"
#include "core/session/export_jobs.h"
#include "core/session/pace_watch.h"
#include "core/session/recipe_progress.h"
#include "core/session/recipe_scene.h"
#include "core/simulation/simulation.h"
#include "core/skin/former_shape.h"
#include "core/skin/skin.h"
#include "core/skin/skin_map.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

using Clock = std::chrono::steady_clock;

// Shares of the progress: reading and filling, simulating, writing.
constexpr double sceneEnd = 0.1;
constexpr double stepsEnd = 0.95;

constexpr double stillShare = 1e-4;    // of the size: nobody sees that a part has moved by less
constexpr double frameTime = 1.0 / 60; // forces on tools are means over this time [s]
constexpr std::chrono::milliseconds reportInterval{100};

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string fixed(double number, int digits)
{
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", digits, number);
    return text.data();
}

/// From the opened part: of the objects, or of those of the first filling where there are others now [m].
std::vector<Vec3> displacementsOf(const Snapshot::BodyState& body)
{
    std::vector<Vec3> displacements = body.displacements();
    if (!body.aggregate->former)
        return displacements;
    const Lattice& first = firstFillingOf(*body.aggregate).lattice;
    std::vector<Vec3> opened;
    for (ObjectIndex i = 0; i < first.size(); ++i)
        opened.push_back(first.position(i));
    std::vector<Vec3> places(opened.size());
    if (body.aggregate->former->isInPieces())
        Skin::ofPlacesWhenFilled(*body.aggregate, firstFillingWhenFilled(*body.aggregate))
            .evaluate(displacements, places);
    else
        SkinMap(*body.aggregate, std::move(displacements)).evaluate(opened, places);
    for (std::size_t i = 0; i < opened.size(); ++i)
        places[i] -= opened[i];
    return places;
}

BodyMotion motionOf(const std::string& name, const Snapshot::BodyState& body)
{
    BodyMotion motion{.name = name};
    const std::vector<Vec3> displacements = displacementsOf(body);
    for (const Vec3& displacement : displacements) {
        motion.meanDisplacement += displacement;
        motion.largestDisplacement = std::max(motion.largestDisplacement, displacement.norm());
    }
    motion.meanDisplacement /= static_cast<double>(std::max<std::size_t>(1, displacements.size()));
    return motion;
}

/// What fixtures say their moments are about, by name.
std::map<std::string, Vec3> momentCenters(const Recipe& recipe)
{
    std::map<std::string, Vec3> centers;
    const auto add = [&](const RecipeFixture& fixture) {
        if (fixture.momentCenter)
            centers[fixture.name] = *fixture.momentCenter;
    };
    for (const RecipeFixture& fixture : recipe.fixtures)
        add(fixture);
    for (const RecipeEvent& event : recipe.events)
        if (const auto* added = std::get_if<AddRecipeFixture>(&event.action))
            add(added->fixture);
    return centers;
}

/// Steps a simulation from 0 to the end of a recipe, with its events.
class Runner {
public:
    Runner(const Recipe& recipe, const RecipeScene& ready, ProbeSeries probes, SayAtOnce say)
        : m_recipe(recipe)
        , m_progress(recipe, ready)
        , m_ready(ready)
        , m_simulation(ready.scene)
        , m_say(std::move(say))
        , m_forces(momentCenters(recipe))
        , m_probes(std::move(probes))
    {
        if (!m_probes.isEmpty())
            m_simulation.showPressing(true); // stress needs to know where
    }

    void run(TaskControl& control)
    {
        Clock::time_point nextReport = m_start;
        m_latest = m_simulation.snapshot();
        m_probes.add(*m_latest);
        if (!m_latest->notice.empty())
            warnAtOnce(m_latest->notice.english());
        PaceWatch watch([this](const std::string& sentence) { say(sentence); });
        for (carryOutDueEvents(); !m_progress.isDone(m_simulation); carryOutDueEvents()) {
            control.throwIfCancelled();
            m_simulation.step();
            checkHealth();
            m_forces.add(m_simulation.reactions(), m_simulation.time());
            watch.reached({m_simulation.time(), m_simulation.timeStep(), share()});
            if (m_simulation.time() + 0.5 * m_simulation.timeStep() >= m_latest->time + frameTime)
                takeFrame();
            if (Clock::now() >= nextReport) {
                report(control, secondsSince(m_start));
                nextReport = Clock::now() + reportInterval;
            }
        }
        m_wall = secondsSince(m_start);
        m_simulation.showPressing(true); // stress needs to know where
        takeFrame();
        warnOfEventsLeft();
    }

    /// The same by load steps, each at its balance.
    void findBalances(TaskControl& control)
    {
        m_latest = m_simulation.snapshot();
        m_probes.add(*m_latest);
        const double duration = m_recipe.duration / m_recipe.loadSteps;
        for (int i = 0; i < m_recipe.loadSteps; ++i) {
            control.throwIfCancelled();
            carryOutDueEvents();
            const StaticReport found = m_simulation.findBalance(duration);
            if (!found.converged)
                throw Problem(Message("Balance", "Load step %1: %2").with(i + 1, found.message));
            m_balances.push_back(found);
            m_forces.addRow(m_simulation.reactions(), m_simulation.time());
            takeSnapshot();
            m_probes.add(*m_latest);
            report(control, secondsSince(m_start));
        }
        m_wall = secondsSince(m_start);
        warnOfEventsLeft();
    }

    const Snapshot& latest() const { return *m_latest; }

    RunReport takeReport() const
    {
        RunReport report;
        report.bodies = m_latest->bodies.size();
        report.objects = m_latest->objects;
        report.connections = m_latest->connections;
        report.steps = m_latest->step;
        report.timeStep =
            m_latest->step > 0 ? m_latest->time / static_cast<double>(m_latest->step) : m_latest->timeStep;
        report.simulated = m_latest->time;
        report.wall = m_wall;
        report.stateHash = m_simulation.stateHash();
        report.integrator = m_latest->integratorReason.english();
        report.energy = m_latest->energy;
        report.broken = m_latest->broken;
        report.refills = m_latest->refills;
        report.joints = m_latest->joints;
        report.components = m_latest->components;
        report.addedMass = m_latest->addedMass;
        report.quality = qualityOf(*m_latest);
        report.fineness = m_ready.fineness;
        for (std::size_t i = 0; i < m_latest->bodies.size(); ++i) {
            report.motions.push_back(motionOf(m_ready.parts()[i].path, m_latest->bodies[i]));
            report.motions.back().stress = bodyStress(m_ready.parts()[i].mesh, *m_latest, static_cast<BodyId>(i));
        }
        report.tools = m_tools;
        report.forces = m_forces;
        report.probes = m_probes.curves();
        report.balances = m_balances;
        for (const Message& warning : m_ready.warnings)
            report.warnings.push_back(warning.english());
        report.warnings.insert(report.warnings.end(), m_warnings.begin(), m_warnings.end());
        for (const Remark& remark : remarksOn(report.quality))
            report.warnings.push_back(remark.sentence.english());
        return report;
    }

    /// A person who pressed a part expects to see it, while it went on at least.
    void noteStillness(RunReport& report) const
    {
        double size = 0;
        for (const Part& part : m_ready.parts())
            size = std::max(size, part.box.diagonal().norm());
        double largest = m_largestMove;
        for (const BodyMotion& motion : report.motions)
            largest = std::max(largest, motion.largestDisplacement);
        if (largest < stillShare * size && !m_latest->tools.empty())
            report.warnings.push_back("Nothing moved by more than " + lengthWords(largest) +
                                      ": fixtures hold all that the tools reach, or the tools reach nothing.");
    }

    /// What is known after a failure: of the last good state, to which the simulation went back.
    RunReport takeReport(const std::string& failure)
    {
        m_wall = secondsSince(m_start);
        takeSnapshot();
        RunReport report = takeReport();
        report.failure = failure;
        report.trouble = m_simulation.health().trouble;
        return report;
    }

private:
    void takeFrame()
    {
        takeSnapshot();
        m_forces.endRow();
        m_probes.add(*m_latest);
    }

    void warnOfEventsLeft()
    {
        if (const std::size_t left = m_recipe.events.size() - m_progress.mark().nextEvent; left > 0)
            m_warnings.push_back("The run ended before " + std::to_string(left) + " of the events were due.");
        if (m_progress.isOnTheWay(m_simulation))
            m_warnings.push_back("The run ended before the grips that deform by physics had gone their way; let it "
                                 "last longer.");
    }

    /// A command that makes no sense changes nothing; the person gets to know why.
    void carryOutDueEvents()
    {
        m_progress.carryOutDue(m_simulation, [this] {
            takeSnapshot();
            m_warnings.push_back("at " + fixed(m_latest->time, 3) + " s: " + m_latest->notice.english());
        });
    }

    void checkHealth() const
    {
        const Health& health = m_simulation.health();
        if (!health.ok)
            throw Problem(health.message);
    }

    /// Tools are remembered by id, so that those taken away stay in the report.
    void takeSnapshot()
    {
        m_latest = m_simulation.snapshot();
        for (const Snapshot::BodyState& body : m_latest->bodies)
            for (const Vec3& displacement : body.displacements())
                m_largestMove = std::max(m_largestMove, displacement.norm());
        for (const ToolState& tool : m_latest->tools) {
            const auto same = [&](const ToolState& other) { return other.id == tool.id; };
            const auto known = std::find_if(m_tools.begin(), m_tools.end(), same);
            if (known == m_tools.end())
                m_tools.push_back(tool);
            else
                *known = tool;
        }
    }

    void say(const std::string& sentence) const
    {
        if (m_say)
            m_say(sentence);
    }

    void warnAtOnce(const std::string& sentence)
    {
        m_warnings.push_back(sentence);
        say(sentence);
    }

    /// Of the run that is done, 0 .. 1.
    double share() const
    {
        const auto steps = static_cast<double>(m_recipe.durationSteps.value_or(0));
        const double done = m_recipe.durationSteps
                                ? static_cast<double>(m_simulation.stepCount()) / std::max(1.0, steps)
                                : m_simulation.time() / m_recipe.duration;
        return std::min(1.0, done);
    }

    void report(TaskControl& control, double wall) const
    {
        const double time = m_simulation.time();
        const std::string end = m_recipe.durationSteps ? " s, " : " of " + fixed(m_recipe.duration, 2) + " s, ";
        control.report(sceneEnd + (stepsEnd - sceneEnd) * share(),
                       "simulating " + fixed(time, 2) + end + fixed(wall > 0 ? time / wall : 0, 2) + "x");
    }

    const Recipe& m_recipe;
    RecipeProgress m_progress;
    const RecipeScene& m_ready;
    Simulation m_simulation;
    SnapshotPointer m_latest;
    std::vector<ToolState> m_tools;
    SayAtOnce m_say;
    ForceSeries m_forces;
    ProbeSeries m_probes;
    std::vector<StaticReport> m_balances;
    std::vector<std::string> m_warnings;
    double m_largestMove = 0; ///< of an object at any frame, from where it was filled [m]
    Clock::time_point m_start = Clock::now();
    double m_wall = 0;
};

/// @param remedy said besides when it cannot be written
void writeTable(const RecipeFiles& files, const std::string& path, const std::string& text, const Message& remedy)
{
    try {
        files.writeTable(path, text);
    } catch (const Problem& problem) {
        throw Problem(Message::sequence({problem.message(), remedy}));
    }
}

void writeTables(const RecipeFiles& files, const RunTables& tables, RunReport& report)
{
    if (!tables.forces.empty())
        writeTable(files, tables.forces, report.forces.csv(), Message("File", "Name another one with --csv."));
    if (!tables.probes.empty())
        writeTable(files, tables.probes, csvOf(report.probes), Message("File", "Name another one with --probes."));
    report.forcesFile = tables.forces;
    report.probesFile = tables.probes;
}

} // namespace

RunReport runRecipe(const Recipe& recipe, const RecipeFiles& files, const std::string& outputFolder,
                    TaskControl& control, const SayAtOnce& say, const RunTables& tables,
                    const WriteAtNodes& writeAtNodes)
{
    if (!tables.probes.empty() && recipe.probes.empty())
        throw UnusableInput(aboutFile(
            recipe.file, Message("Recipe", "it has no probes whose readings could be written; add the key probes.")));
    TaskPortion preparing(control, 0, sceneEnd);
    TaskPortion filling(preparing, 0, 0.9);
    const RecipeScene ready = buildScene(recipe, files, filling);
    checkEvents(recipe, ready);
    TaskPortion probing(preparing, 0.9, 1);
    ProbeSeries probes(recipe, ready, probing);
    files.prepareFolders(recipe.exports, outputFolder);

    if (say && !ready.fineness.warning.empty())
        say(ready.fineness.warning.english());
    Runner runner(recipe, ready, std::move(probes), say);
    try {
        recipe.analysis == Analysis::equilibrium ? runner.findBalances(control) : runner.run(control);
    } catch (const Cancelled&) {
        throw;
    } catch (const UnusableInput&) {
        throw; // nothing ran that could be reported
    } catch (const std::runtime_error& error) {
        RunReport known = runner.takeReport(error.what());
        writeTables(files, tables, known);
        throw RunFailed(std::move(known));
    }

    TaskPortion writing(control, stepsEnd, 1);
    RunReport report = runner.takeReport();
    runner.noteStillness(report);
    writeTables(files, tables, report);
    if (!recipe.exports.empty()) {
        TaskPortion exporting(writing, 0, writeAtNodes ? 0.5 : 1);
        WrittenExports written = files.writeExports(recipe.exports, outputFolder,
                                                    exportJobOf(*ready.model, ready.partOfBody(), runner.latest()),
                                                    runner.latest(), exporting);
        report.files = std::move(written.files);
        report.exports = std::move(written.reports);
    }
    if (writeAtNodes) {
        TaskPortion telling(writing, 0.5, 1);
        const WrittenAtNodes written = writeAtNodes(*ready.model, ready.partOfBody(), runner.latest(), telling);
        report.files.push_back(written.file);
        for (const Message& warning : written.warnings)
            report.warnings.push_back(warning.english());
    }
    return report;
}

} // namespace knead
