#include "ui/measuring/comparison_feature.h"

#include "ui/commands/availability.h"
#include "ui/commands/make_action.h"
#include "ui/dialogs/comparison_dialog.h"
#include "ui/frame/notices.h"
#include "ui/frame/text_files.h"
#include "ui/measuring/comparison_report.h"
#include "ui/measuring/measuring.h"
#include "ui/panels/measure_panel.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QDateTime>
#include <QFileInfo>
#include <QMainWindow>

#include <memory>

namespace knead {

ComparisonFeature::ComparisonFeature(const Workbench& bench, Measuring& measuring)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_measuring(measuring)
    , m_action(makeAction(
          bench.window,
          {"compareWithOriginal", QT_TRANSLATE_NOOP("Measuring", "Compare with original..."), "compare-two", "Shift+M",
           QT_TRANSLATE_NOOP("Measuring",
                             "Largest and mean distance, volume and mass beside the original, and a report")},
          "Measuring"))
{
    bench.availability.needBodies({m_action});
    connect(m_action, &QAction::triggered, this, &ComparisonFeature::compareWithOriginal);
    connect(&measuring.panel(), &MeasurePanel::comparisonWanted, m_action, &QAction::trigger);
}

void ComparisonFeature::compareWithOriginal()
{
    if (m_bench.document.content().bodies.empty() || m_bench.isBusy())
        return;
    m_bench.notices.hide();
    const auto report = std::make_shared<ComparisonReport>(newReport()); // of the moment that is compared
    const auto work = [content = m_bench.document.content(), shown = m_bench.viewport.shownFrame(),
                       present = m_bench.document.frame()->snapshot](TaskControl& control) {
        return knead::compareWithOriginal(content, *shown, *present, control);
    };
    m_bench.tasks.run<Comparison>(tr("Comparing with the original"), work,
                                  [this, report](const Comparison& comparison) {
                                      report->comparison = comparison;
                                      showComparison(*report);
                                  });
}

/// What belongs into a report beside the comparison, as it is now.
ComparisonReport ComparisonFeature::newReport() const
{
    return {.part = QFileInfo(QString::fromStdString(m_bench.document.content().model->file)).fileName(),
            .when = QDateTime::currentDateTime(),
            .comparison = {},
            .picture = m_bench.viewport.grab().toImage(),
            .measurements = m_measuring.html()};
}

/// For as long as the part is open that was compared.
void ComparisonFeature::showComparison(const ComparisonReport& report)
{
    auto* dialog = new ComparisonDialog(report.comparison, &m_bench.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(&m_bench.document, &Document::changed, dialog, [dialog](Document::Change what) {
        if (what == Document::Change::Model)
            dialog->close();
    });
    connect(dialog, &ComparisonDialog::placeWanted, this, &ComparisonFeature::placeWanted);
    connect(dialog, &ComparisonDialog::reportWanted, this, [this, report] {
        askForTextFile(m_bench, tr("Write a report"), "-report.pdf", {tr("PDF (*.pdf)"), tr("Web page (*.html *.htm)")},
                       [this, report](const QString& path) { writeReport(path, report); });
    });
    dialog->show();
    dialog->activateWindow(); // keys are its own, Esc for one
}

void ComparisonFeature::write(const QString& path, const Comparison& comparison)
{
    ComparisonReport report = newReport();
    report.comparison = comparison;
    writeReport(path, report);
}

void ComparisonFeature::writeReport(const QString& path, const ComparisonReport& report)
{
    writeTextFile(m_bench, path, [report, path] { return bytesOf(report, path); });
}

} // namespace knead
