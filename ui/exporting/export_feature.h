#pragma once

#include "core/model/export_report.h"
#include "core/model/file_formats.h"
#include "core/session/export_request.h"
#include "ui/frame/workbench.h"
#include "ui/panels/place_rows.h"

#include <QObject>

#include <optional>
#include <string>
#include <vector>

class QAction;

namespace knead {

class ExportPanel;

/// The deformed parts as CAD and mesh files, and the report on them. Window thread only.
class ExportFeature final : public QObject {
    Q_OBJECT
public:
    explicit ExportFeature(const Workbench& bench);

    QAction* action() const { return m_action; }

    /// Writes the deformed parts in the background; the ending decides the format.
    void exportTo(const QString& path, const ExportRequest& request = {});

    /// The report on parts that were deformed, which were written and read again for that.
    void showDeformed(const ExportReport& report);

signals:
    void placeWanted(const knead::ReportPlace& place); ///< of a row of the report

private:
    struct PlannedFile {
        std::string path;
        ExportJob job;
    };

    void askForExport();
    void askForPlace(const ExportRequest& request, const FileFormat& format);
    std::vector<PlannedFile> planFiles(const QString& path, const ExportRequest& request) const;
    std::vector<bool> partsFor(ExportRequest::Which which) const;
    void showExport(const std::vector<ExportReport>& reports);
    std::optional<ReportPlace> placeOf(const PartExportReport& part) const;

    Workbench m_bench;
    QAction* m_action;
    std::shared_ptr<const Model> m_exported; ///< that the report is about
    ExportPanel* m_panel;
};

} // namespace knead
