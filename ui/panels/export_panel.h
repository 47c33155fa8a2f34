#pragma once

#include "core/model/export_report.h"
#include "ui/panels/place_rows.h"

#include <QWidget>

#include <functional>
#include <vector>

class QLabel;
class QTreeWidget;

namespace knead {

/// What was found when exported files were read back: a row for each part, with what a person must know before relying on it.
class ExportPanel final : public QWidget {
    Q_OBJECT
public:
    /// Where an exported part is; nothing: not known.
    using PlaceOf = std::function<std::optional<ReportPlace>(const PartExportReport&)>;

    explicit ExportPanel(QWidget* parent = nullptr);

    void show(const std::vector<ExportReport>& reports, const PlaceOf& placeOf = {});

    /// For when they are in a part that is no longer open.
    void forgetPlaces();

    /// A sentence. @param sound parts of all `parts`
    static QString verdict(std::size_t sound, std::size_t parts);

signals:
    void placeWanted(const knead::ReportPlace& place);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fitColumns();

    std::vector<ExportReport> m_reports; ///< that are shown
    QLabel* m_summary;
    QTreeWidget* m_parts;
    PlaceRows* m_places;
    PlaceOf m_placeOf; ///< of the parts that are shown
};

} // namespace knead
