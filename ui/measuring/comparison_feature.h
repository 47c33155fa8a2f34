#pragma once

#include "ui/frame/workbench.h"
#include "ui/panels/place_rows.h"

#include <QObject>

class QAction;

namespace knead {

struct Comparison;
struct ComparisonReport;
class Measuring;

/// The part beside what it was when it was opened, and the report of that. Window thread only.
class ComparisonFeature final : public QObject {
    Q_OBJECT
public:
    ComparisonFeature(const Workbench& bench, Measuring& measuring);

    QAction* action() const { return m_action; }

    /// Writes a report as PDF or HTML in the background; the ending decides.
    void write(const QString& path, const Comparison& comparison);

signals:
    void placeWanted(const knead::ReportPlace& place); ///< of a row of the comparison

private:
    void compareWithOriginal();
    ComparisonReport newReport() const;
    void showComparison(const ComparisonReport& report);
    void writeReport(const QString& path, const ComparisonReport& report);

    Workbench m_bench;
    const Measuring& m_measuring;
    QAction* m_action;
};

} // namespace knead
