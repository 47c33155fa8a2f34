#pragma once

#include "core/aggregate/fill.h"
#include "core/model/export_job.h"
#include "io/export/exporter.h"
#include "io/importer.h"
#include "support/space_maps.h"

#include <QFile>
#include <QTemporaryDir>

#include <functional>
#include <memory>

/// Jobs for exporters, and what they give.
namespace knead::export_jobs {

inline Model example(const char* name)
{
    return importFile(std::string(KNEAD_RESOURCES) + "/examples/" + name);
}

/// All closed parts of a model, their objects where a map takes them.
inline ExportJob jobOf(const Model& model, const SmoothMap* map, double cells = 24)
{
    ExportJob job;
    job.tree = model.tree;
    job.options.unit = "mm";
    for (const Part& part : model.parts) {
        PartToExport out{.part = part};
        out.density = 1000;
        if (map != nullptr) {
            out.aggregate = std::make_shared<const Aggregate>(
                fill(part.mesh, {.spacing = spacingForCellsAcross(part.mesh, cells)}));
            for (ObjectIndex i = 0; i < out.aggregate->size(); ++i) {
                const Vec3 at = out.aggregate->lattice.position(i);
                out.displacements.push_back(map->at(at) - at);
            }
        }
        job.parts.push_back(std::move(out));
    }
    return job;
}

inline Box boxOf(const Model& model)
{
    Box box;
    for (const Part& part : model.parts)
        box.extend(part.box);
    return box;
}

inline Model readBack(const ExportedFile& file, const char* ending)
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QString("out.") + ending);
    QFile out(path);
    out.open(QIODevice::WriteOnly);
    out.write(file.bytes.data(), static_cast<qint64>(file.bytes.size()));
    out.close();
    return importFile(path.toStdString(), {.heal = false});
}

/// Breaks all connections between objects on the two sides of a plane.
inline std::shared_ptr<const std::vector<BrokenConnection>> brokenAcross(const Aggregate& aggregate,
                                                                         const std::function<double(const Vec3&)>& side)
{
    auto broken = std::make_shared<std::vector<BrokenConnection>>();
    const Lattice& lattice = aggregate.lattice;
    for (std::uint32_t d = 0; d < Lattice::isotropicCount; ++d)
        for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
            if (aggregate.weight[d][i] <= 0)
                continue;
            const Vec3 here = lattice.position(i);
            if (side(here) != side(here + lattice.direction(static_cast<int>(d))))
                broken->push_back({d, i});
        }
    return broken;
}

} // namespace knead::export_jobs
