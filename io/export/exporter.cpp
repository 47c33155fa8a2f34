#include "io/export/exporter.h"

#include "core/message/message.h"
#include "io/brep/exact_shapes.h"
#include "io/brep/occt_session.h"
#include "io/export/exact_part.h"
#include "io/export/export_check.h"
#include "io/files/nameless_file.h"
#include "io/formats/cad_reader.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>

namespace knead {

namespace {

constexpr double checkDeflection = 1.0 / 300; // of the size of the smallest part
constexpr double otherTriangles[] = {0.8, 1.2, 0.6, 0.45, 0.36};

/// The exact shape of a part; none for a mesh.
class ShapeStore {
public:
    TopoDS_Shape of(const Part& part)
    {
        if (!part.exact)
            return {};
        auto [found, isNew] = m_shapes.try_emplace(part.exact->bytes.get());
        if (isNew)
            found->second = shapesFromBytes(*part.exact->bytes);
        if (part.exact->number >= found->second.size())
            throw Problem(Message("Export", "The exact shapes of the parts are not complete; import the file again."));
        return found->second[part.exact->number];
    }

private:
    std::map<const std::string*, std::vector<TopoDS_Shape>> m_shapes;
};

/// Per part, see makeReady().
using Choices = std::vector<FaceChoice>;

std::vector<ReadyPart> makeAllReady(const ExportJob& job, const Choices& choices, TaskControl& control)
{
    ShapeStore shapes;
    std::vector<ReadyPart> ready;
    const auto count = static_cast<double>(job.parts.size());
    for (const PartToExport& part : job.parts) {
        const auto done = static_cast<double>(ready.size());
        TaskPortion portion(control, done / count, (done + 1) / count);
        ready.push_back(makeReady(part, shapes.of(part.part), job.options, choices[ready.size()], portion));
    }
    return ready;
}

/// With triangles for the smallest part, not finer and finer ones until these hold the volume, which is integrated exactly: a
/// surface that passes through itself has none that they could approach.
/// @param fineness of the triangles, 1 as a rule, less for finer ones
Model readBack(FormatKind kind, const std::string& bytes, const ExportJob& job, double fineness, TaskControl& control)
{
    double smallest = job.parts.front().part.box.diagonal().norm();
    for (const PartToExport& part : job.parts)
        smallest = std::min(smallest, part.part.box.diagonal().norm());
    ImportOptions options{.linearDeflection = fineness * checkDeflection * smallest, .heal = false};
    options.angularDeflection *= fineness;
    NamelessFile file(NamelessFile::Place::memory);
    file.write(bytes);
    return readCad(file.path(), kind, options, control);
}

/// Parts whose faces meet, but whose triangles leave holes.
std::ptrdiff_t partsWithHoles(const Model& model)
{
    return std::count_if(model.parts.begin(), model.parts.end(),
                         [](const Part& part) { return !part.watertight && part.openEdges.empty(); });
}

/// Now and then a face cannot be covered with triangles of just this size.
Model readBackWithoutHoles(FormatKind kind, const std::string& bytes, const ExportJob& job, TaskControl& control)
{
    TaskPortion reading(control, 0, 0.5);
    Model model = readBack(kind, bytes, job, 1, reading);
    for (double done = 0.5; const double fineness : otherTriangles) {
        if (partsWithHoles(model) == 0)
            break;
        constexpr double share = 0.5 / std::size(otherTriangles);
        TaskPortion again(control, done, done + share);
        Model other = readBack(kind, bytes, job, fineness, again);
        if (partsWithHoles(other) < partsWithHoles(model))
            model = std::move(other);
        done += share;
    }
    return model;
}

/// What to know of a part that did not come back sound.
struct Outcome {
    FaceManner manner;              ///< that was tried
    std::optional<FaceManner> next; ///< to try
    std::vector<std::uint32_t> misfits;
    bool cameBackInsideOut;
};

/// A file, and what became of its parts.
struct Attempt {
    ExportedFile file;
    std::vector<Outcome> outcomes; ///< per part
};

Attempt writeAndReadBack(FormatKind kind, const ExportJob& job, const Choices& choices, TaskControl& control)
{
    Attempt attempt;
    ExportedFile& file = attempt.file;
    std::vector<ReadyPart> ready;
    {
        const OcctSession session;
        TaskPortion making(control, 0, 0.5);
        ready = makeAllReady(job, choices, making);
        std::vector<CadPartToWrite> out;
        out.reserve(ready.size());
        for (const ReadyPart& part : ready)
            out.push_back(part.out);
        TaskPortion writing(control, 0.5, 0.65);
        file.bytes = writeCad(kind, out, job.tree, job.options, writing);
    }
    TaskPortion reading(control, 0.65, 0.9);
    const Model back = readBackWithoutHoles(kind, file.bytes, job, reading);
    {
        const OcctSession session;
        TaskPortion comparing(control, 0.9, 1);
        file.report.warnings = checkWritten(ready, back, comparing);
    }
    file.report.format = back.format;
    file.report.unit = back.unit;
    file.report.bytes = file.bytes.size();
    for (ReadyPart& part : ready) {
        file.report.parts.push_back(std::move(part.report));
        attempt.outcomes.push_back({part.manner, part.next, std::move(part.misfits), part.cameBackInsideOut});
    }
    return attempt;
}

// Faces that hold so much of the volume too much or too little are a shape of their own, as those that are far off are.
constexpr double roughVolume = 2e-3;

bool isRough(const PartExportReport& report)
{
    return report.largestDeviation > roughFaces * report.tolerance || std::abs(report.volumeError()) > roughVolume ||
           report.largestFlatDeviation > report.flatTolerance;
}

/// A sound part whose own faces were bent, and are no longer fit for who reads the file.
bool isSpoilt(const PartToExport& part, const PartExportReport& report)
{
    return part.part.valid && part.part.watertight && report.form == PartExportReport::Form::exact &&
           report.keptFaces < report.facesBefore && !report.isFit();
}

/// Why bent faces are not good enough.
/// @pre they are not fit
Message whyUnfit(const PartExportReport& report, const Outcome& outcome)
{
    const auto digits = [](const char* format, double number) {
        char text[32];
        std::snprintf(text, sizeof text, format, number);
        return std::string(text);
    };
    if (report.facesAfter == 0)
        return Message("Export", "its bent faces were not found again in the file when that was read back.");
    if (outcome.cameBackInsideOut)
        return Message("Export", "read back from the file, its bent faces are inside out.");
    if (!report.valid)
        return Message("Export", "read back from the file, its bent faces do not pass the geometry checks.");
    if (!report.closed || report.freeEdges > 0)
        return Message("Export", "read back from the file, its bent faces leave gaps.");
    if (report.largestFlatDeviation > report.flatTolerance)
        return Message("Export",
                       "read back from the file, its flat faces are up to %1 mm off the skin where %2 mm are allowed.")
            .with(digits("%.3g", 1e3 * report.largestFlatDeviation), digits("%.3g", 1e3 * report.flatTolerance));
    if (report.largestDeviation > report.tolerance)
        return Message("Export",
                       "read back from the file, its bent faces are up to %1 mm off the skin where %2 mm are allowed.")
            .with(digits("%.3g", 1e3 * report.largestDeviation), digits("%.3g", 1e3 * report.tolerance));
    return Message("Export", "read back from the file, its bent faces enclose a volume %1 % off that of the skin.")
        .with(digits("%.2g", 100 * std::abs(report.volumeError())));
}

/// Whether other faces would be better than those that came back: flat ones leave no gaps, and divided ones may meet where
/// own ones do not. Smooth faces that are a little off are named in the report instead.
bool areOthersBetter(const PartExportReport& report)
{
    return !report.valid || !report.closed || report.freeEdges > 0 || isRough(report);
}

/// Whether a part came back inside out and another of its faces can be written first, see withFaceFirst().
bool canTurn(const PartExportReport& report, const Outcome& outcome, const FaceChoice& choice)
{
    constexpr int mostTries = 3;
    return outcome.cameBackInsideOut && report.form == PartExportReport::Form::exact &&
           static_cast<int>(choice.firstFace) < std::min(mostTries, report.facesAfter - 1);
}

/// Chooses what is to be tried next. @return false when every part came back as well as it can
bool choose(const ExportJob& job, const Attempt& last, Choices& choices)
{
    bool isAny = false;
    for (std::size_t i = 0; i < job.parts.size(); ++i) {
        const PartExportReport& report = last.file.report.parts[i];
        const Outcome& outcome = last.outcomes[i];
        const std::size_t firstFace = choices[i].firstFace;
        if (canTurn(report, outcome, choices[i]))
            ++choices[i].firstFace;
        else if (!outcome.next || !isSpoilt(job.parts[i], report) || !areOthersBetter(report))
            continue;
        else if (*outcome.next == FaceManner::flat && !outcome.misfits.empty() && choices[i].flat.empty())
            choices[i] = {outcome.manner, whyUnfit(report, outcome), outcome.misfits, {}, firstFace};
        else
            choices[i] = {*outcome.next, whyUnfit(report, outcome), {}, outcome.misfits, firstFace};
        isAny = true;
    }
    return isAny;
}

} // namespace

ExportedFile exportCad(FormatKind kind, ExportJob job, TaskControl& control)
{
    if (job.parts.empty())
        throw Problem(Message("Export", "There is nothing to export."));
    const auto start = std::chrono::steady_clock::now();
    Choices choices(job.parts.size());
    TaskPortion mapping(control, 0, 0.1);
    makeMaps(job, mapping);
    TaskPortion first(control, 0.1, 0.8);
    Attempt attempt = writeAndReadBack(kind, job, choices, first);
    for (double done = 0.8; choose(job, attempt, choices); done = 0.5 * (1 + done)) {
        TaskPortion again(control, done, 0.5 * (1 + done));
        try {
            attempt = writeAndReadBack(kind, job, choices, again);
        } catch (const Cancelled&) {
            throw;
        } catch (const std::runtime_error& error) {
            // Too many flat faces: better what there is, with what is wrong with it.
            attempt.file.report.warnings.push_back(messageOf(error));
            break;
        }
    }
    attempt.file.report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::move(attempt.file);
}

} // namespace knead
