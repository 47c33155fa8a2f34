#pragma once

#include "app/cad_process.h"
#include "app/export_file.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/self_intersection.h"
#include "core/session/comparison.h"
#include "core/session/measurement.h"
#include "io/worker/isolated_work.h"
#include "support/soak_hand.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace knead::soak {

/// A piece of a soak: who does the same again gets the same bits.
struct Piece {
    std::uint64_t seed = 1;
    double duration = 10;                               ///< simulated, what is undone too [s]
    int mostGestures = std::numeric_limits<int>::max(); ///< or that many, whatever comes first
    double objects = 300;                               ///< that it begins with, up to ten times as many
    std::string folder;                                 ///< for files
    bool writesCad = true;                              ///< the rest must come to the same without
    std::size_t memory = std::size_t{12} << 20U; ///< of the history [bytes]: little, so that moments are thinned out
    std::function<void(double simulated)> watch; ///< after each gesture; may be empty
};

/// What a piece begins with and chooses from.
struct Workshop {
    std::vector<std::shared_ptr<const Model>> models;
    std::vector<Material> materials;
};

struct Outcome {
    std::uint64_t digest = 0;
    double simulated = 0; ///< [s]
    std::size_t entries = 0;
    std::size_t commands = 0;
    Findings findings;
};

class Session {
public:
    Session(const Workshop& workshop, const Piece& piece, Findings& findings)
        : m_workshop(workshop)
        , m_piece(piece)
        , m_findings(findings)
        , m_random(piece.seed)
        , m_document(opened(), piece.memory, findings)
        , m_hand(m_document, workshop.materials, m_random, findings)
    {
    }

    void run()
    {
        goOn();
        attempt([this] { return finish(); });
    }

    const Document& document() const { return m_document; }

private:
    void goOn()
    {
        if (qEnvironmentVariableIsSet("KNEAD_SOAK_WORDS"))
            std::fprintf(stderr, "%s, %zu objects\n", m_document.content().model->file.c_str(),
                         m_document.now().objects);
        int idle = 0; // gestures without time: of a document that is stopped for good
        for (int n = 0; n < m_piece.mostGestures && m_document.simulated() < m_piece.duration && idle < 200; ++n) {
            const double before = m_document.simulated();
            const auto begin = std::chrono::steady_clock::now();
            const std::string name = attempt([this] { return somethingElse(); });
            idle = m_document.simulated() > before ? 0 : idle + 1;
            const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            m_findings.atMost("slowest [s]", took);
            if (qEnvironmentVariableIsSet("KNEAD_SOAK_WORDS"))
                sayGesture(name, took);
            if (m_piece.watch)
                m_piece.watch(m_document.simulated());
        }
    }

    /// What the program tells is no fault; all else that is thrown is. @return what was done
    template <typename Act>
    std::string attempt(Act act)
    {
        try {
            return act();
        } catch (const Problem& problem) {
            m_findings.count("told: " + problem.message().text());
            return std::string("told: ") + problem.what();
        } catch (const std::exception& error) {
            m_findings.fault(std::string("thrown: ") + error.what());
            return "fault";
        }
    }

    /// What each piece has, however short it is.
    std::string finish()
    {
        undo();
        redo();
        compare();
        exportTriangles();
        exportSmooth();
        m_document.saveAndReopen(m_piece.folder + "/soak.knead");
        return "the end";
    }

    /// What happens, for who looks for something.
    void sayGesture(const std::string& name, double took) const
    {
        const Snapshot& now = m_document.now();
        const History& history = m_document.history();
        std::fprintf(stderr,
                     "%9.3f s  %-10s %6.2f s  %016llx  step %.2g s, %zu contacts, %zu broken, %zu pieces, %zu objects, "
                     "E %.2g Pa, nu %.2f, yield %.2g, integrator %d, %d iterations, %.2f MB, %s\n",
                     m_document.simulated(), name.c_str(), took,
                     static_cast<unsigned long long>(history.record(history.current()).hash), now.timeStep,
                     now.contacts, now.broken, now.components, now.objects, now.materials[0].youngsModulus,
                     now.materials[0].poissonRatio, now.materials[0].yieldStress, static_cast<int>(now.integrator),
                     now.solverIterations, 1e-6 * static_cast<double>(history.memory()), now.notice.english().c_str());
    }

    PreparedModel opened()
    {
        const auto& model = m_random.oneOf(m_workshop.models);
        const Material material = m_random.oneOf(m_workshop.materials);
        ImportChoices choices;
        choices.paths = {model->file};
        const std::size_t more = m_random.below(m_random.chance(15) ? 28 : 8);
        choices.spacing =
            SpacingChoice{SpacingChoice::Kind::Objects, m_piece.objects * (1 + static_cast<double>(more) / 3)};
        if (m_random.chance(30))
            choices.touching = Touching::glued;
        return prepareModel(model, choices, material, TaskControl::none());
    }

    std::string somethingElse()
    {
        if (!m_document.now().health.ok) {
            m_findings.count("told: stopped, " + m_document.now().health.message.text());
            undo();
            return "undo of what was stopped";
        }
        if (m_document.isTooLong() && m_random.chance(70)) {
            m_document.forgetEffort();
            m_findings.count("given up");
            for (int n = 0; n < 4; ++n)
                undo();
            return "undo of what took too long";
        }
        m_document.forgetEffort();
        switch (m_random.below(60)) {
        case 0:
        case 1:
            m_findings.count("save");
            m_document.saveAndReopen(m_piece.folder + "/soak.knead");
            return "save";
        case 2:
            exportSmooth();
            return "export";
        case 3:
            exportTriangles();
            return "triangles";
        case 4:
            compare();
            return "compare";
        case 5:
        case 6:
        case 7:
        case 8:
        case 9:
            undo();
            return "undo";
        case 10:
        case 11:
        case 12:
            redo();
            return "redo";
        case 13:
            m_findings.count("go to");
            m_document.visit(recentEntry());
            return "go to";
        case 14:
            branch();
            return "branch";
        case 15:
            if (m_random.chance(15))
                fillAgain();
            return "fill again";
        default:
            return m_hand.gesture();
        }
    }

    /// One of the last: those long ago would take as long to find as they took.
    History::Entry recentEntry()
    {
        const auto count = static_cast<History::Entry>(m_document.history().records().size());
        return count - 1 - static_cast<History::Entry>(m_random.below(std::min<std::size_t>(count, 12)));
    }

    void undo()
    {
        for (std::size_t n = 1 + m_random.below(3); n > 0; --n)
            if (const auto entry = m_document.history().undoTarget()) {
                m_findings.count("undo");
                m_document.visit(*entry);
            }
    }

    void redo()
    {
        for (std::size_t n = 1 + m_random.below(2); n > 0; --n)
            if (const auto entry = m_document.history().redoTarget()) {
                m_findings.count("redo");
                m_document.visit(*entry);
            }
    }

    void branch()
    {
        const History& history = m_document.history();
        const History::Entry entry = recentEntry();
        const HistoryRecord& record = history.record(entry);
        const HistoryRecord& before = history.record(record.parent);
        if (entry == 0 || history.beginsStart(entry) || record.step < before.step)
            return;
        m_findings.count("branch");
        m_document.branchAt(entry, before.step + m_random.below(record.step - before.step + 1));
    }

    void fillAgain()
    {
        m_findings.count("fill again");
        m_document.fillAgain(m_hand.number(0.85, 1.3) * m_document.now().bodies[0].aggregate->lattice.spacing);
    }

    void compare()
    {
        m_findings.count("compare");
        const FramePointer before = m_looked; // perhaps of another filling, or whole still
        m_document.draw();
        m_looked = m_document.framePointer();
        FilledModel content = m_document.content();
        content.bodies = m_looked->filled; // as the window has it
        const bool isOfThese = before && before->filled.size() == content.bodies.size() &&
                               !before->filled[0]->fillings.owner_before(content.bodies[0]->fillings) &&
                               !content.bodies[0]->fillings.owner_before(before->filled[0]->fillings);
        for (const FramePointer& shown : {m_looked, isOfThese ? before : m_looked})
            compare(content, *shown);
    }

    /// What is shown with the original, and places on it.
    void compare(const FilledModel& content, const Frame& shown)
    {
        const Comparison comparison = compareWithOriginal(content, shown, m_document.now(), TaskControl::none());
        measure(content, shown);
        for (const BodyComparison& body : comparison.bodies) {
            if (!std::isfinite(body.largestDistance) || !std::isfinite(body.now.volume) ||
                !std::isfinite(body.now.mass))
                m_findings.fault("a comparison has no numbers");
            if (std::abs(body.now.mass - body.rest.mass) > 1e-6 * body.rest.mass)
                m_findings.count("told: another mass than at rest");
            m_findings.atMost("volume", body.now.volume / body.rest.volume);
            m_findings.atMost("1 / volume", body.rest.volume / body.now.volume);
            m_document.note(std::bit_cast<std::uint64_t>(body.largestDistance));
            m_document.note(std::bit_cast<std::uint64_t>(body.now.volume));
        }
    }

    void measure(const FilledModel& content, const Frame& shown)
    {
        Measurement measurement{.kind = static_cast<MeasureKind>(m_random.below(9)), .places = {}};
        for (int pick = 0; pick < 3; ++pick) {
            const auto body = static_cast<BodyId>(m_random.below(content.bodies.size()));
            const auto triangle = m_random.below(content.bodies[body]->mesh.triangles.size());
            measurement.places.push_back({body, static_cast<std::uint32_t>(triangle), Vec3::Constant(1.0 / 3)});
        }
        for (const Reading& reading : measured(measurement, content, shown, m_document.now()).readings)
            if (!std::isfinite(reading.now))
                m_findings.fault("a measurement is no number");
    }

    void exportTriangles()
    {
        m_findings.count("export of triangles");
        constexpr std::array endings{"stl", "vtp", "3mf", "glb", "ply", "obj"};
        const std::string path = m_piece.folder + "/soak." + endings[m_random.below(endings.size())];
        const ExportReport report = exportFile(path, m_document.exportJob(), TaskControl::none());
        for (const PartExportReport& part : report.parts)
            if (!std::isfinite(part.volume) || (part.wasClosed && !part.closed))
                m_findings.fault("triangles of a closed part are not closed: " + report.file);
        std::ifstream file(path, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        m_document.note(checksumOf(std::as_bytes(std::span(bytes))));
    }

    void exportSmooth()
    {
        ExportJob job = m_document.exportJob();
        if (!m_piece.writesCad)
            return;
        m_findings.count("export");
        const std::string path = m_piece.folder + "/soak.step";
        job.options.tolerance = 1e-3 * m_document.content().box.diagonal().norm();
        try {
            checkFile(exportFile(path, std::move(job), TaskControl::none()));
        } catch (const WorkerCrashed& crash) {
            keep(path, std::string("the export crashed: ") + crash.what());
        }
    }

    void checkFile(const ExportReport& report)
    {
        m_findings.count(report.isSound() ? "export, sound" : "export, said not to be sound");
        const Model back = importInChild(report.file, {.heal = false}, TaskControl::none());
        std::size_t closed = 0;
        for (const PartExportReport& part : report.parts)
            closed += part.closed ? 1 : 0;
        if (back.parts.size() < report.parts.size())
            m_findings.fault("parts of an export are missing: " + std::to_string(back.parts.size()));
        if (back.parts.size() != report.parts.size())
            return;
        for (std::size_t i = 0; i < back.parts.size(); ++i)
            if (report.parts[i].isSound())
                checkPart(back.parts[i], report.parts[i], report.file);
    }

    /// Of a part that is said to be sound.
    void checkPart(const Part& part, const PartExportReport& report, const std::string& path)
    {
        if (part.watertight != report.wasClosed || !part.valid)
            keep(path, "a part that is said to be sound is not closed or not valid");
        if (part.volume <= 0 || std::abs(part.volume - report.volume) > 1e-3 * report.volume)
            keep(path, "a part that is said to be sound has another volume");
        // What reaches no deeper than the file is exact is sound: the net of what is read back has chords beside edges.
        const Crossings crossings = findCrossings(part.mesh);
        if (const double depth = depthOf(part.mesh, crossings); depth > report.tolerance)
            keep(path, "a part that is said to be sound passes through itself at " + std::to_string(crossings.count) +
                           " pairs of triangles, by " + std::to_string(1e3 * depth) + " mm of " +
                           std::to_string(1e3 * report.tolerance) + " mm");
    }

    /// How far triangles reach through each other at most: the lesser part beyond the plane of the other one [m]. The export finds that
    /// too (surface_flaws.cpp); it is not judged by its own code here.
    static double depthOf(const TriangleMesh& mesh, const Crossings& crossings)
    {
        const auto beyond = [&](const TriangleMesh::Triangle& plane, const TriangleMesh::Triangle& other) {
            const Vec3& origin = mesh.vertices[plane[0]];
            const Vec3 normal = (mesh.vertices[plane[1]] - origin).cross(mesh.vertices[plane[2]] - origin);
            double above = 0;
            double below = 0;
            for (const std::uint32_t corner : other) {
                const double height = normal.stableNormalized().dot(mesh.vertices[corner] - origin);
                above = std::max(above, height);
                below = std::max(below, -height);
            }
            return std::min(above, below);
        };
        double depth = 0;
        for (const auto& [a, b] : crossings.some)
            depth = std::max(depth, std::min(beyond(mesh.triangles[a], mesh.triangles[b]),
                                             beyond(mesh.triangles[b], mesh.triangles[a])));
        return depth;
    }

    /// A fault with a file to look at.
    void keep(const std::string& path, const std::string& fault)
    {
        const std::string kept =
            m_piece.folder + "/fault-" + std::to_string(m_piece.seed) + "-" + std::to_string(m_findings.faults.size());
        std::error_code error;
        std::filesystem::copy_file(path, kept + ".step", error);
        m_document.saveAndReopen(kept + ".knead");
        m_findings.fault(fault + " (" + kept + ")");
    }

    const Workshop& m_workshop;
    const Piece& m_piece;
    Findings& m_findings;
    fuzz::Random m_random;
    Document m_document;
    Hand m_hand;
    FramePointer m_looked; ///< at the last comparison
};

/// @throws nothing but what cannot begin
inline Outcome carryOut(const Workshop& workshop, const Piece& piece)
{
    Outcome outcome;
    Session session(workshop, piece, outcome.findings);
    session.run();
    outcome.digest = session.document().digest();
    outcome.simulated = session.document().simulated();
    outcome.entries = session.document().history().records().size();
    for (const HistoryRecord& record : session.document().history().records())
        outcome.commands += record.commands.size();
    return outcome;
}

} // namespace knead::soak
