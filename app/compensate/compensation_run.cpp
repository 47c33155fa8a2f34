#include "app/compensate/compensation_run.h"

#include "app/cad_process.h"
#include "app/compensate/round_files.h"
#include "app/compensate/round_tables.h"
#include "app/export_file.h"
#include "core/deformation/deformation.h"
#include "core/message/message.h"
#include "core/model/field_formats.h"
#include "core/model/number_words.h"
#include "io/files/safe_file.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

// Shares of the progress of a round.
constexpr double preparedShare = 0.3;
constexpr double ranShare = 0.8;

constexpr double farOff = 0.3; // of the size of a part, between its box and that of the nodes of its field

Box boxOf(const std::vector<Vec3>& places)
{
    Box box;
    for (const Vec3& place : places)
        box.extend(place);
    return box;
}

std::string wordsOf(const Box& box)
{
    const auto place = [](const Vec3& at) {
        return "(" + lengthWords(at.x()) + ", " + lengthWords(at.y()) + ", " + lengthWords(at.z()) + ")";
    };
    return place(box.min()) + " to " + place(box.max());
}

/// A field in other units, or of another place, would compensate nonsense.
void checkPlace(const FieldFile& field, const TargetPoints& points, const CompensationRound& round)
{
    std::vector<Vec3> shape = points.places;
    for (std::size_t i = 0; i < shape.size(); ++i)
        shape[i] += round.compensation[i];
    const Box part = boxOf(shape);
    const Box nodes = boxOf(field.field.nodes);
    const double off =
        std::max((part.min() - nodes.min()).cwiseAbs().maxCoeff(), (part.max() - nodes.max()).cwiseAbs().maxCoeff());
    if (!(off <= farOff * part.diagonal().norm()))
        throw std::runtime_error("Round " + std::to_string(round.number) + ": the nodes of " + field.path +
                                 " reach from " + wordsOf(nodes) + ", and the part from " + wordsOf(part) +
                                 "; say its unit in \"field\", or let the command leave the part where it is.");
}

/// Rounds one after the other.
class Compensator {
public:
    Compensator(const CompensationStudy& study, const CompensationFolder& folder, const RoundEngine& engine,
                const ReadField& read, const std::function<void(const std::string&)>& say, const Model& target,
                CompensationResult& result)
        : m_study(study)
        , m_folder(folder)
        , m_engine(engine)
        , m_read(read)
        , m_say(say)
        , m_files(study, target, result.points)
        , m_result(result)
    {
    }

    /// @return why there are no more
    CompensationEnd run(TaskControl& control)
    {
        std::optional<CompensationEnd> end;
        while (!(end = m_result.rounds.empty() ? std::nullopt : stateAfter(m_result.rounds, m_study.method).end)) {
            const std::size_t done = m_result.rounds.size();
            TaskPortion portion =
                TaskPortion::ofItem(control, done, std::max(done + 1, static_cast<std::size_t>(m_study.method.rounds)));
            carryOut(portion);
        }
        return *end;
    }

    ExportReport writeBest(const std::string& path, TaskControl& control) const
    {
        return m_files.writePart(path, m_result.rounds[m_result.best], control);
    }

    void writeTables() const
    {
        writeFileSafely(m_folder.pathOf("rounds.csv"), tableOf(m_result.points, m_result.rounds));
        writeFileSafely(m_folder.pathOf("rounds.svg"), plotOf(m_result.rounds, m_study.method.tolerance));
    }

private:
    void carryOut(TaskControl& control)
    {
        CompensationRound round = nextRound(m_result.points, m_result.rounds, m_study.method);
        const std::string folder = m_folder.folderOf(round.number);
        const RoundCommand command = m_files.command(round.number, folder);
        const std::string name = "round " + std::to_string(round.number);
        TaskPortion preparing(control, 0, preparedShare);
        preparing.report(0, name + ": writing the part");
        if (!isAtWork(command, m_engine))
            m_files.prepare(round, command, preparing);
        control.report(preparedShare, name + ": the command runs");
        runCommand(command, m_engine, control);
        TaskPortion reading(control, ranShare, 1);
        takeUp(round, command, reading);
        tell(round);
    }

    /// What came out of a round.
    void takeUp(CompensationRound& round, const RoundCommand& command, TaskControl& control)
    {
        const std::string path = (std::filesystem::path(command.folder) / command.field).string();
        const TriangleMesh shape = isScanFile(path) ? m_files.surface(round, control) : TriangleMesh();
        const FieldFile field = m_read(path, m_study.choice, shape, control);
        for (const Message& warning : field.warnings)
            if (m_warned.insert(warning.english()).second) // each round would say the same
                m_say("warning: round " + std::to_string(round.number) + ": " + warning.english());
        checkPlace(field, m_result.points, round);
        const auto map =
            mapOf(FieldDeformation{.field = std::make_shared<const DisplacementField>(field.field)}, control);
        measureRound(m_result.points, *map, m_study.method.fitsBest, round, control);
        for (const char* name : {"deviations.csv", "deviations.vtu"})
            writeDeviations((std::filesystem::path(command.folder) / name).string(), m_result.points, round);
        m_folder.keep(round);
        m_result.rounds.push_back(round);
        writeTables();
    }

    void tell(const CompensationRound& round) const
    {
        m_say("round " + std::to_string(round.number) + ": largest deviation " + lengthWords(round.largest) +
              ", mean " + lengthWords(round.mean));
        const CompensationState state = stateAfter(m_result.rounds, m_study.method);
        if (state.isHalved && !state.end)
            m_say("that is no better than round " + std::to_string(m_result.rounds[state.best].number) +
                  ", from which it goes on with half the factor");
    }

    const CompensationStudy& m_study;
    const CompensationFolder& m_folder;
    const RoundEngine& m_engine;
    const ReadField& m_read;
    const std::function<void(const std::string&)>& m_say;
    RoundFiles m_files;
    CompensationResult& m_result;
    std::set<std::string> m_warned;
};

/// With exact faces only: what comes out is to be smooth.
Model readTarget(const std::string& path, TaskControl& control)
{
    Model target = importInChild(path, {}, control);
    for (const Part& part : target.parts)
        if (!part.exact)
            throw std::runtime_error(
                path + ": " + part.name +
                " has no smooth faces that could be carried along; take a STEP, IGES or BREP file.");
    return target;
}

} // namespace

CompensationResult compensate(const CompensationStudy& study, const CompensationFolder& folder,
                              const RoundEngine& engine, const ReadField& read,
                              const std::function<void(const std::string&)>& say, TaskControl& control)
{
    constexpr double reading = 0.05;
    constexpr double writing = 0.95;
    TaskPortion beginning(control, 0, reading);
    const Model target = readTarget(study.part, beginning);
    CompensationResult result;
    result.points = targetPoints(target, study.faces, study.spacing, beginning);
    folder.begin(factsOf(study));
    result.rounds = folder.rounds(result.points);
    result.finishedBefore = result.rounds.size();

    Compensator compensator(study, folder, engine, read, say, target, result);
    TaskPortion rounds(control, reading, writing);
    result.end = compensator.run(rounds);
    result.best = stateAfter(result.rounds, study.method).best;
    compensator.writeTables();
    TaskPortion last(control, writing, 1);
    last.report(0, "writing compensated.step");
    result.written = compensator.writeBest(folder.pathOf("compensated.step"), last);
    writeReportBeside(result.written);
    return result;
}

} // namespace knead
