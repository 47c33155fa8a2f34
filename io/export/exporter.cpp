#include "io/export/exporter.h"

#include "io/cad_reader.h"
#include "io/exact_shapes.h"
#include "io/export/exact_part.h"
#include "io/export/export_check.h"
#include "io/occt_session.h"
#include "io/worker/child_process.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <stdexcept>

namespace knead {

namespace {

constexpr double checkDeflection = 1.0 / 300; // of the size of the smallest part

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
            throw std::runtime_error("The exact shapes of the parts are not complete; import the file again.");
        return found->second[part.exact->number];
    }

private:
    std::map<const std::string*, std::vector<TopoDS_Shape>> m_shapes;
};

std::vector<ReadyPart> makeAllReady(const ExportJob& job, TaskControl& control)
{
    ShapeStore shapes;
    std::vector<ReadyPart> ready;
    const auto count = static_cast<double>(job.parts.size());
    for (const PartToExport& part : job.parts) {
        const auto done = static_cast<double>(ready.size());
        TaskPortion portion(control, done / count, (done + 1) / count);
        ready.push_back(makeReady(part, shapes.of(part.part), job.options, portion));
    }
    return ready;
}

/// With triangles for the smallest part, not finer and finer ones until these hold the volume, which is integrated exactly: a
/// surface that passes through itself has none that they could approach.
Model readBack(FormatKind kind, const std::string& bytes, const ExportJob& job, TaskControl& control)
{
    double smallest = job.parts.front().part.box.diagonal().norm();
    for (const PartToExport& part : job.parts)
        smallest = std::min(smallest, part.part.box.diagonal().norm());
    NamelessFile file;
    file.write(bytes);
    return readCad("/proc/self/fd/" + std::to_string(file.descriptor()), kind,
                   {.linearDeflection = checkDeflection * smallest, .heal = false}, control);
}

} // namespace

ExportedFile exportCad(FormatKind kind, const ExportJob& job, TaskControl& control)
{
    if (job.parts.empty())
        throw std::runtime_error("There is nothing to export.");
    const auto start = std::chrono::steady_clock::now();
    ExportedFile file;
    std::vector<ReadyPart> ready;
    {
        const OcctSession session;
        TaskPortion making(control, 0, 0.5);
        ready = makeAllReady(job, making);
        std::vector<CadPartToWrite> out;
        for (const ReadyPart& part : ready)
            out.push_back(part.out);
        TaskPortion writing(control, 0.5, 0.65);
        file.bytes = writeCad(kind, out, job.tree, job.options, writing);
    }
    TaskPortion reading(control, 0.65, 0.9);
    const Model back = readBack(kind, file.bytes, job, reading);
    {
        const OcctSession session;
        TaskPortion comparing(control, 0.9, 1);
        file.report.warnings = checkWritten(ready, back, comparing);
    }
    file.report.format = back.format;
    file.report.unit = back.unit;
    file.report.bytes = file.bytes.size();
    for (ReadyPart& part : ready)
        file.report.parts.push_back(std::move(part.report));
    file.report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return file;
}

} // namespace knead
