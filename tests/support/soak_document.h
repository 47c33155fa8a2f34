#pragma once

#include "core/document/moment_hash.h"
#include "core/session/export_jobs.h"
#include "core/session/filled_model.h"
#include "core/session/frame.h"
#include "core/session/history_navigation.h"
#include "core/session/prepared_project.h"
#include "io/project/packing.h"
#include "io/project/project_file.h"
#include "support/fuzz_random.h"
#include "support/project_digest.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace knead::soak {

/// What was found in a piece of a soak.
struct Findings {
    std::vector<std::string> faults;   ///< of the program
    std::map<std::string, int> counts; ///< of what was done, and of what the program told
    std::map<std::string, double> most;

    void fault(const std::string& what) { faults.push_back(what); }
    void count(const std::string& what) { ++counts[what]; }
    void atMost(const std::string& what, double value) { most[what] = std::max(most[what], value); }
};

/// An opened part with its simulation and its history, as the window's document has it, without a window and its threads: what is done
/// to it is done at once. Whatever it goes back to it compares with what was.
class Document {
public:
    using Entry = History::Entry;
    static constexpr double frameTime = 1.0 / 60; // [s]

    Document(PreparedModel prepared, std::size_t memory, Findings& findings)
        : m_findings(findings)
        , m_memory(memory)
        , m_opened(prepared.content.model)
        , m_simulation(std::move(prepared.simulation))
        , m_history(recordOf(std::move(prepared.first), "start", zstandardPacking()), memory)
    {
        begin(std::move(prepared.content), std::move(prepared.scene), std::move(prepared.frame));
        m_whole.push_back(hashOfCurrent());
    }

    const FilledModel& content() const { return *m_content; }
    const Snapshot& now() const { return *m_now; }
    const Frame& frame() const { return *m_frame; }
    const FramePointer& framePointer() const { return m_frame; }
    const History& history() const { return m_history; }
    const MomentPointer& moment() const { return m_moment; } ///< at the end of the last gesture
    double simulated() const { return m_simulated; }         ///< in all, what was undone too [s]

    /// Of all that was done, bit for bit.
    std::uint64_t digest() const
    {
        ByteWriter bytes;
        for (const std::uint64_t hash : m_whole)
            bytes(hash);
        bytes(m_noted);
        return checksumOf(bytes.take());
    }
    void note(std::uint64_t number) { m_noted = 31 * m_noted + number; } ///< belongs to the digest

    void post(Command command) { m_simulation.post(std::move(command)); }
    void postAll(const std::vector<Command>& commands)
    {
        for (const Command& command : commands)
            post(command);
    }

    /// Carries out what was posted while time stands still.
    void apply()
    {
        m_simulation.applyCommands();
        look();
    }

    /// Time goes on by a frame, or by as many short steps as a window has time for. @return whether it may go on: a person gives up
    /// what takes too long
    bool step()
    {
        const int most = m_now->integrator == Integrator::implicitEuler ? 12 : 100;
        const double begin = m_simulation.time();
        int steps = 0;
        for (; steps < most && m_simulation.time() < begin + frameTime - 1e-9 && m_simulation.health().ok; ++steps)
            m_simulation.step();
        m_simulated += std::max(0.0, m_simulation.time() - begin);
        look();
        m_effort += static_cast<double>(m_now->objects) * steps * (1 + m_now->solverIterations);
        return m_simulation.health().ok && !isTooLong();
    }

    /// The gesture, in steps and iterations of objects: the same on any machine.
    bool isTooLong() const { return m_effort > 4e6; }
    void forgetEffort() { m_effort = 0; }

    /// Puts the part where there is balance.
    void findBalance()
    {
        if (const StaticReport report = m_simulation.settle({}); !report.converged)
            m_findings.count("told: " + report.message.text());
        look();
    }

    /// The surfaces of now.
    void draw()
    {
        m_frame = prepareFrame(m_content->bodies, m_now, m_frame);
        for (const auto& body : m_frame->bodies)
            if (!std::ranges::all_of(body->points, [](float x) { return std::isfinite(x); }))
                m_findings.fault("a surface is drawn at no place");
    }

    void endGesture(const std::string& name)
    {
        Gesture gesture = knead::endGesture(m_simulation);
        m_moment = gesture.moment;
        m_history.append(recordOf(std::move(gesture), name, zstandardPacking()));
        m_whole.push_back(hashOfCurrent());
        look();
        std::size_t ofMoments = 0;
        for (const HistoryRecord& record : m_history.records())
            ofMoments += record.moment ? record.moment->size() : 0;
        if (m_history.memory() > m_memory + m_largestRecord && ofMoments > m_memory / 2 + m_largestRecord)
            m_findings.fault("the history takes more memory than it may");
    }

    /// Goes to an entry of the history. @return its state is what it was
    void visit(Entry entry)
    {
        HistoryDestination there = navigationTo(entry).go(TaskControl::none());
        if (there.found) {
            m_findings.count("found again by repeating");
            m_history.keep(entry, std::move(there.found));
        }
        m_content = std::move(there.content);
        if (there.simulation) {
            m_simulation = std::move(*there.simulation);
            m_frame = std::move(there.frame);
        } else {
            m_simulation.goTo(there.moment);
        }
        m_moment = there.moment;
        m_history.goTo(entry);
        compare("going back to \"" + m_history.record(entry).name + "\"");
    }

    /// Goes on from within an entry, on a branch.
    void branchAt(Entry entry, std::uint64_t step)
    {
        const HistoryRecord& record = m_history.record(entry);
        const Entry parent = record.parent;
        Branch branch = navigationTo(parent).branch(record.commands, 0, step, TaskControl::none());
        visit(parent);
        m_moment = branch.gesture.moment;
        m_simulation.goTo(m_moment);
        m_history.append(recordOf(std::move(branch.gesture), "branch", zstandardPacking()));
        m_whole.push_back(hashOfCurrent());
        compare("a branch");
    }

    /// Fills all bodies anew with another spacing, which begins another start.
    void fillAgain(double spacing)
    {
        PreparedModel again = prepareRefill(*m_content, spacing, *m_now, {}, TaskControl::none());
        m_simulation = std::move(again.simulation);
        m_moment = again.first.moment;
        m_history.appendStart(recordOf(std::move(again.first), "fill again", zstandardPacking()),
                              static_cast<std::uint32_t>(m_starts.size()));
        begin(std::move(again.content), std::move(again.scene), std::move(again.frame));
        m_whole.push_back(hashOfCurrent());
    }

    /// Writes a project, and goes on with what is read.
    void saveAndReopen(const std::string& path)
    {
        const Project saved = project();
        writeProject(path, saved);
        Project read = readProject(path);
        if (digests::of(read) != digests::of(saved))
            m_findings.fault("a project is read as another one than was written");
        PreparedProject opened = prepareProject(std::move(read), zstandardPacking(), TaskControl::none());
        m_opened = opened.project.model;
        m_starts = std::move(opened.project.starts);
        m_history = History(std::move(opened.project.entries), opened.project.current, m_memory);
        m_content = std::move(opened.destination.content);
        m_simulation = std::move(*opened.destination.simulation);
        m_moment = opened.destination.moment;
        m_frame = std::move(opened.destination.frame);
        compare("a reopened project");
    }

    /// As all parts are now.
    ExportJob exportJob()
    {
        m_simulation.showPressing(true); // stress needs to know where
        look();
        m_simulation.showPressing(false);
        return exportJobOf(*m_content->model, m_starts[start()].partOfBody, *m_now);
    }

private:
    std::uint32_t start() const { return m_history.record(m_history.current()).start; }

    void begin(FilledModel content, Scene scene, FramePointer frame)
    {
        m_starts.push_back(startOf(content, std::move(scene)));
        if (content.model != m_opened)
            m_starts.back().model = content.model;
        m_content = std::make_shared<const FilledModel>(std::move(content));
        m_frame = std::move(frame);
        look();
    }

    Project project() const
    {
        Project project;
        project.model = m_opened;
        project.import = m_content->request;
        project.starts = m_starts;
        project.entries = m_history.records();
        project.current = m_history.current();
        return project;
    }

    HistoryNavigation navigationTo(Entry entry) const
    {
        HistoryNavigation navigation;
        navigation.way = m_history.wayTo(entry);
        const std::uint32_t index = navigation.way.start;
        navigation.start = {
            .start = m_starts[index], .content = index == start() ? m_content : nullptr, .choices = m_content->request};
        navigation.model = m_starts[index].model ? m_starts[index].model : m_opened;
        navigation.packing = zstandardPacking();
        navigation.changesStart = index != start();
        return navigation;
    }

    /// All of the moment at the present entry.
    std::uint64_t hashOfCurrent()
    {
        const HistoryRecord& record = m_history.record(m_history.current());
        m_largestRecord = std::max(m_largestRecord, record.moment->size());
        const auto& bodies = m_starts[record.start].scene.bodies;
        const std::uint64_t hash = momentHash(momentFromBytes(*record.moment, bodies, {}, zstandardPacking()));
        if (m_moment && momentHash(*m_moment) != hash)
            m_findings.fault("a moment is unpacked as another one than was packed");
        return hash;
    }

    /// That the simulation is where the present entry was, with all that belongs to it.
    void compare(const std::string& what)
    {
        const Entry entry = m_history.current();
        const HistoryRecord& record = m_history.record(entry);
        if (m_simulation.stateHash() != record.hash || m_simulation.stepCount() != record.step)
            m_findings.fault(what + " leads to another state than it was");
        if (m_moment && momentHash(*m_moment) != m_whole.at(entry))
            m_findings.fault(what + " leads to another moment than it was");
        look();
    }

    void look()
    {
        m_now = m_simulation.snapshot();
        for (const Snapshot::BodyState& body : m_now->bodies)
            if (!std::ranges::all_of(body.positions, [](const Vec3& place) { return place.allFinite(); }))
                m_findings.fault("objects are at no place");
        const EnergyLedger& energy = m_now->energy;
        for (const double part : {energy.kinetic, energy.elastic, energy.gravity, energy.contact, energy.toolWork,
                                  energy.dissipated(), energy.imbalance, energy.turnover})
            if (!std::isfinite(part))
                m_findings.fault("an energy is no number");
    }

    Findings& m_findings;
    std::size_t m_memory;
    std::size_t m_largestRecord = 0;
    std::shared_ptr<const Model> m_opened;
    std::shared_ptr<const FilledModel> m_content;
    std::vector<ProjectStart> m_starts;
    Simulation m_simulation;
    History m_history;
    std::vector<std::uint64_t> m_whole; ///< per entry, of its moment
    std::uint64_t m_noted = 0;
    SnapshotPointer m_now;
    FramePointer m_frame;
    MomentPointer m_moment;
    double m_simulated = 0;
    double m_effort = 0;
};

} // namespace knead::soak
