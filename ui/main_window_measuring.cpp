// Measuring and probes in the main window: their docks, their files, and the comparison with the original.
#include "ui/main_window.h"

#include "ui/actions.h"
#include "ui/dialogs/comparison_dialog.h"
#include "ui/dialogs/file_question.h"
#include "ui/measuring/comparison.h"
#include "ui/measuring/measuring.h"
#include "ui/panels/banner.h"
#include "ui/panels/log_panel.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/probe_panel.h"
#include "ui/viewport/view_grid.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QFileInfo>

#include <stdexcept>

namespace knead {

namespace {

/// @param path that is told to the person; `pathForNow` is written to
void write(const QByteArray& bytes, const std::string& pathForNow, const QString& path)
{
    QFile file(QFile::decodeName(pathForNow.c_str()));
    if (!file.open(QFile::WriteOnly) || file.write(bytes) != bytes.size() || !file.flush())
        throw std::runtime_error(
            MainWindow::tr("%1 cannot be written (%2). Choose another folder, or make room on the disk.")
                .arg(path, file.errorString())
                .toStdString());
}

} // namespace

void MainWindow::makeMeasuring()
{
    m_measuring = new Measuring(m_document, *m_viewport, *m_modes, this);
    connect(m_views, &ViewGrid::sideAdded, m_measuring, &Measuring::addView);
    auto* dock = new QDockWidget(tr("Measurements"), this);
    dock->setObjectName("measureDock");
    dock->setWidget(&m_measuring->panel());
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable |
                      QDockWidget::DockWidgetFloatable);
    addDockWidget(Qt::BottomDockWidgetArea, dock);
    auto* log = findChild<QDockWidget*>("logDock");
    tabifyDockWidget(log, dock);
    log->raise();
    connect(&m_measuring->tool(), &PickTool::begun, this, [this, dock] {
        dock->show();
        dock->raise();
    });
    connect(m_measuring, &Measuring::promptChanged, this, &MainWindow::showHint);
    const auto refused = std::make_shared<QString>();
    connect(m_measuring, &Measuring::refused, this, [this, refused](const QString& sentence) {
        *refused = sentence;
        showProblem(sentence);
    });
    connect(&m_measuring->list(), &MeasurementList::changed, this, [this, refused] {
        if (m_measuring->tool().isPicking() && m_banner->sentence() == *refused) // forgotten; what others said stays
            m_banner->hide();
    });
    connect(&m_measuring->panel(), &MeasurePanel::csvWanted, this, &MainWindow::askForMeasurementFile);
    connect(&m_measuring->panel(), &MeasurePanel::comparisonWanted, m_measuring->compareAction(), &QAction::trigger);
    connect(m_measuring->compareAction(), &QAction::triggered, this, &MainWindow::compareWithOriginal);
}

void MainWindow::makeProbes()
{
    m_probes = new ProbeSet(m_document, this);
    auto* place = new QAction(icon("probe"), tr("Place probe"), this);
    place->setObjectName("placeProbe");
    place->setShortcut(QKeySequence(Qt::Key_P));
    place->setToolTip(tr("Click places of the part to plot what happens there over time (P)"));
    addAction(place);
    m_measuring->addPickAction(place, {PickWhat::place},
                               [this](const std::vector<SkinPlace>& places) { m_probes->add(places.front()); });
    place->setEnabled(false);
    auto* panel = new ProbePanel(*m_probes, place);
    auto* dock = new QDockWidget(tr("Probes"), this);
    dock->setObjectName("probeDock");
    dock->setWidget(panel);
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable |
                      QDockWidget::DockWidgetFloatable);
    addDockWidget(Qt::BottomDockWidgetArea, dock);
    tabifyDockWidget(findChild<QDockWidget*>("measureDock"), dock);
    findChild<QDockWidget*>("logDock")->raise();
    connect(place, &QAction::toggled, dock, [dock](bool on) {
        if (!on)
            return;
        dock->show();
        dock->raise();
    });
    connect(panel, &ProbePanel::csvWanted, this, [this] {
        askForTextFile(tr("Write what the probes read"), "-probes.csv", {tr("Table (*.csv)")},
                       [this](const QString& path) { writeProbes(path); });
    });
    const auto mark = [this] { m_measuring->setOtherMarks(probeMarks()); };
    connect(m_probes, &ProbeSet::changed, this, mark);
    connect(m_viewport, &ViewportBridge::renderRequested, this, [this, mark] {
        if (!m_probes->all().empty())
            mark();
    });
}

std::vector<OverlayMark> MainWindow::probeMarks() const
{
    std::vector<OverlayMark> marks;
    const FramePointer& frame = m_viewport->shownFrame();
    for (const Probe& probe : m_probes->all()) {
        const auto at = frame ? seenPlace(probe.place, m_document.content(), *frame, m_viewport->options().hiddenParts)
                              : std::nullopt;
        if (!at)
            continue;
        OverlayMark mark{.color = probe.color};
        mark.mark.points = {*at};
        mark.mark.label = *at;
        mark.mark.text = QString::number(probe.number);
        marks.push_back(mark);
    }
    return marks;
}

void MainWindow::writeProbes(const QString& path)
{
    writeFile(path, [probes = m_probes->all()] { return csvOf(probes).toUtf8(); });
}

/// @param ending of the name that is proposed, after that of the part
void MainWindow::askForTextFile(const QString& title, const QString& ending, const QStringList& filters,
                                std::function<void(const QString& path)> then)
{
    const QString stem = QFileInfo(QString::fromStdString(m_document.content().model->file)).completeBaseName();
    const FileQuestion question{
        .name = "textFileDialog", .title = title, .filters = filters, .key = "exportFolder", .file = stem + ending};
    askForFileToWrite(*this, question, std::move(then));
}

void MainWindow::askForMeasurementFile()
{
    askForTextFile(tr("Write what was measured"), "-measured.csv", {tr("Table (*.csv)")},
                   [this](const QString& path) { writeMeasurements(path); });
}

void MainWindow::writeMeasurements(const QString& path)
{
    writeFile(path, [list = m_measuring->list().all(), results = m_measuring->panel().results()] {
        return csvOf(list, results).toUtf8();
    });
}

/// Whole or not at all, in the background.
/// @param bytes what is written; called there
void MainWindow::writeFile(const QString& path, std::function<QByteArray()> bytes)
{
    if (isBusy())
        return;
    m_banner->hide();
    const auto work = [services = m_services, path, bytes = std::move(bytes)](TaskControl&) {
        services.writeSafely(QFile::encodeName(path).toStdString(),
                             [&](const std::string& pathForNow) { write(bytes(), pathForNow, path); });
        return true;
    };
    m_tasks.run<bool>(tr("Writing %1").arg(QFileInfo(path).fileName()), work,
                      [this, path](bool) { m_log->add(tr("Written: %1.").arg(path)); });
}

void MainWindow::compareWithOriginal()
{
    if (m_document.content().bodies.empty() || isBusy())
        return;
    m_banner->hide();
    const auto report = std::make_shared<ComparisonReport>(newReport()); // of the moment that is compared
    const auto work = [content = m_document.content(), shown = m_viewport->shownFrame(),
                       present = m_document.frame()->snapshot](TaskControl& control) {
        return knead::compareWithOriginal(content, *shown, *present, control);
    };
    m_tasks.run<Comparison>(tr("Comparing with the original"), work, [this, report](const Comparison& comparison) {
        report->comparison = comparison;
        showComparison(*report);
    });
}

/// What belongs into a report beside the comparison, as it is now.
ComparisonReport MainWindow::newReport() const
{
    return {.part = QFileInfo(QString::fromStdString(m_document.content().model->file)).fileName(),
            .when = QDateTime::currentDateTime(),
            .comparison = {},
            .picture = m_viewport->grab().toImage(),
            .measurements = m_measuring->html()};
}

/// For as long as the part is open that was compared.
void MainWindow::showComparison(const ComparisonReport& report)
{
    auto* dialog = new ComparisonDialog(report.comparison, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(&m_document, &Document::changed, dialog, [dialog](Document::Change what) {
        if (what == Document::Change::Content)
            dialog->close();
    });
    connect(dialog, &ComparisonDialog::reportWanted, this, [this, report] {
        askForTextFile(tr("Write a report"), "-report.pdf", {tr("PDF (*.pdf)"), tr("Web page (*.html *.htm)")},
                       [this, report](const QString& path) { writeReport(path, report); });
    });
    dialog->show();
    dialog->activateWindow(); // keys are its own, Esc for one
}

void MainWindow::writeComparison(const QString& path, const Comparison& comparison)
{
    ComparisonReport report = newReport();
    report.comparison = comparison;
    writeReport(path, report);
}

void MainWindow::writeReport(const QString& path, const ComparisonReport& report)
{
    writeFile(path, [report, path] { return bytesOf(report, path); });
}

} // namespace knead
