#pragma once

#include "app/compensate/round_command.h"
#include "core/aggregate/cell_mesh.h"
#include "core/model/export_report.h"
#include "core/model/part.h"
#include "core/session/compensation.h"
#include "core/session/compensation_study.h"
#include "core/task/task_control.h"

#include <memory>
#include <string>

namespace knead {

/// Makes the folders of rounds: the part in the shape of the round, and what else its command needs. On one thread.
class RoundFiles {
public:
    /// All are to outlive it.
    RoundFiles(const CompensationStudy& study, const Model& target, const TargetPoints& points)
        : m_study(study)
        , m_target(target)
        , m_points(points)
    {
    }

    /// The command of a round, with its placeholders filled.
    RoundCommand command(int round, const std::string& folder) const;

    /// Makes the folder anew. @throws std::runtime_error, in a sentence. @throws Cancelled
    void prepare(const CompensationRound& round, const RoundCommand& command, TaskControl& control);

    /// Writes the target in the shape of a round. @throws std::runtime_error, in a sentence. @throws Cancelled
    ExportReport writePart(const std::string& path, const CompensationRound& round, TaskControl& control) const;

    /// The surface of the target in the shape of a round [m]. @throws as fieldMap()
    TriangleMesh surface(const CompensationRound& round, TaskControl& control) const;

private:
    std::string filled(std::string text, int round, const std::string& folder) const;
    bool wantsMesh() const;
    void writeMesh(const std::string& path, const CompensationRound& round, TaskControl& control);

    const CompensationStudy& m_study;
    const Model& m_target;
    const TargetPoints& m_points;
    std::unique_ptr<const CellMesh> m_mesh; ///< of the target, made when first wanted
};

} // namespace knead
