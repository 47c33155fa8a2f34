#include "app/recipe_runner.h"

#include "app/recipe_events.h"
#include "app/recipe_exports.h"
#include "app/recipe_scene.h"
#include "core/simulation/simulation.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace knead {

namespace {

using Clock = std::chrono::steady_clock;

// Shares of the progress: reading and filling, simulating, writing.
constexpr double sceneEnd = 0.1;
constexpr double stepsEnd = 0.95;

constexpr double frame = 1.0 / 60; // forces on tools are means over this time [s]
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

BodyMotion motionOf(const std::string& name, const Snapshot::BodyState& body)
{
    BodyMotion motion{.name = name};
    const std::vector<Vec3> displacements = body.displacements();
    for (const Vec3& displacement : displacements) {
        motion.meanDisplacement += displacement;
        motion.largestDisplacement = std::max(motion.largestDisplacement, displacement.norm());
    }
    motion.meanDisplacement /= static_cast<double>(std::max<std::size_t>(1, displacements.size()));
    return motion;
}

/// Steps a simulation from 0 to the end of a recipe, with its events.
class Runner {
public:
    Runner(const Recipe& recipe, const RecipeScene& ready)
        : m_recipe(recipe)
        , m_events(recipe, ready)
        , m_ready(ready)
        , m_simulation(ready.scene)
    {
        for (std::size_t i = 0; i < recipe.events.size(); ++i)
            if (std::holds_alternative<StartAgain>(recipe.events[i].action))
                m_eventsToDo = i + 1;
    }

    void run(TaskControl& control)
    {
        const Clock::time_point start = Clock::now();
        Clock::time_point nextReport = start;
        m_latest = m_simulation.snapshot();
        for (carryOutDueEvents(); !isDone(); carryOutDueEvents()) {
            control.throwIfCancelled();
            m_simulation.step();
            checkHealth();
            if (isAt(m_latest->time + frame))
                takeSnapshot();
            if (Clock::now() >= nextReport) {
                report(control, secondsSince(start));
                nextReport = Clock::now() + reportInterval;
            }
        }
        m_wall = secondsSince(start);
        takeSnapshot();
        if (m_nextEvent < m_recipe.events.size())
            m_warnings.push_back("The run ended before " + std::to_string(m_recipe.events.size() - m_nextEvent) +
                                 " of the events were due.");
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
        report.integrator = m_latest->integratorReason;
        report.energy = m_latest->energy;
        report.broken = m_latest->broken;
        report.joints = m_latest->joints;
        report.components = m_latest->components;
        report.addedMass = m_latest->addedMass;
        for (std::size_t i = 0; i < m_latest->bodies.size(); ++i)
            report.motions.push_back(motionOf(m_ready.parts[i].path, m_latest->bodies[i]));
        report.tools = m_tools;
        report.warnings = m_ready.warnings;
        report.warnings.insert(report.warnings.end(), m_warnings.begin(), m_warnings.end());
        return report;
    }

private:
    /// Whether the step nearest to a time has been reached.
    bool isAt(double time) const { return m_simulation.time() + 0.5 * m_simulation.timeStep() >= time; }

    bool isDue(const RecipeEvent& event) const
    {
        return event.step ? m_simulation.stepCount() >= *event.step : isAt(event.time);
    }

    /// The end counts from the last time that the run begins again.
    bool isDone() const
    {
        return m_nextEvent >= m_eventsToDo && (m_recipe.durationSteps
                                                   ? m_simulation.stepCount() >= *m_recipe.durationSteps
                                                   : isAt(m_recipe.duration));
    }

    void carryOutDueEvents()
    {
        for (; m_nextEvent < m_recipe.events.size() && isDue(m_recipe.events[m_nextEvent]); ++m_nextEvent)
            for (Command& command : m_events.commandsOf(m_nextEvent, m_simulation.bodies()))
                carryOut(std::move(command));
    }

    /// A command that makes no sense changes nothing; the person gets to know why.
    void carryOut(Command command)
    {
        const std::size_t before = m_simulation.recording().size();
        m_simulation.post(std::move(command));
        m_simulation.applyCommands();
        const std::vector<RecordedCommand>& recording = m_simulation.recording();
        if (recording.size() > before)
            return m_events.carriedOut(recording.back().command);
        takeSnapshot();
        m_warnings.push_back("at " + fixed(m_latest->time, 3) + " s: " + m_latest->notice);
    }

    void checkHealth() const
    {
        const Health& health = m_simulation.health();
        if (!health.ok)
            throw std::runtime_error(health.message);
    }

    /// Tools are remembered by id, so that those taken away stay in the report.
    void takeSnapshot()
    {
        m_latest = m_simulation.snapshot();
        for (const ToolState& tool : m_latest->tools) {
            const auto same = [&](const ToolState& other) { return other.id == tool.id; };
            const auto known = std::find_if(m_tools.begin(), m_tools.end(), same);
            if (known == m_tools.end())
                m_tools.push_back(tool);
            else
                *known = tool;
        }
    }

    void report(TaskControl& control, double wall) const
    {
        const double time = m_simulation.time();
        const auto steps = static_cast<double>(m_recipe.durationSteps.value_or(0));
        const double done = m_recipe.durationSteps
                                ? static_cast<double>(m_simulation.stepCount()) / std::max(1.0, steps)
                                : time / m_recipe.duration;
        const std::string end = m_recipe.durationSteps ? " s, " : " of " + fixed(m_recipe.duration, 2) + " s, ";
        control.report(sceneEnd + (stepsEnd - sceneEnd) * std::min(1.0, done),
                       "simulating " + fixed(time, 2) + end + fixed(wall > 0 ? time / wall : 0, 2) + "x");
    }

    const Recipe& m_recipe;
    EventCommands m_events;
    const RecipeScene& m_ready;
    Simulation m_simulation;
    SnapshotPointer m_latest;
    std::vector<ToolState> m_tools;
    std::vector<std::string> m_warnings;
    std::size_t m_nextEvent = 0;
    std::size_t m_eventsToDo = 0; ///< before the end counts
    double m_wall = 0;
};

/// Names and boxes are checked before the first step, not when the event is due.
void checkEvents(const Recipe& recipe, const RecipeScene& ready)
{
    const EventCommands events(recipe, ready);
    for (std::size_t i = 0; i < recipe.events.size(); ++i)
        events.commandsOf(i, ready.scene.bodies);
}

} // namespace

RunReport runRecipe(const Recipe& recipe, const std::string& outputFolder, TaskControl& control)
{
    TaskPortion preparing(control, 0, sceneEnd);
    const RecipeScene ready = buildScene(recipe, preparing);
    checkEvents(recipe, ready);
    prepareFolders(recipe.exports, outputFolder);

    Runner runner(recipe, ready);
    runner.run(control);

    TaskPortion writing(control, stepsEnd, 1);
    RunReport report = runner.takeReport();
    if (recipe.exports.empty())
        return report;
    WrittenExports written = writeExports(recipe.exports, outputFolder, exportJobOf(ready, runner.latest()),
                                          runner.latest(), writing);
    report.files = std::move(written.files);
    report.exports = std::move(written.reports);
    return report;
}

} // namespace knead
