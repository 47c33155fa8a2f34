// Measuring and probes in the main window: their docks, their files, and the comparison with the original.
#include "ui/main_window.h"

#include "ui/actions.h"
#include "ui/dialogs/comparison_dialog.h"
#include "ui/measuring/comparison.h"
#include "ui/measuring/measuring.h"
#include "ui/panels/banner.h"
#include "ui/panels/log_panel.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/probe_panel.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include <stdexcept>

namespace knead {

void MainWindow::makeMeasuring()
{
    m_measuring = new Measuring(m_document, *m_viewport, *m_modes, this);
    auto* dock = new QDockWidget(tr("Measurements"), this);
    dock->setObjectName("measureDock");
    dock->setWidget(&m_measuring->panel());
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    addDockWidget(Qt::BottomDockWidgetArea, dock);
    auto* log = findChild<QDockWidget*>("logDock");
    tabifyDockWidget(log, dock);
    log->raise();
    connect(&m_measuring->tool(), &PickTool::begun, this, [this, dock] {
        dock->show();
        dock->raise();
    });
    connect(m_measuring, &Measuring::promptChanged, this, &MainWindow::showHint);
    connect(m_measuring, &Measuring::refused, this, [this](const QString& sentence) { showProblem(sentence); });
    connect(&m_measuring->list(), &MeasurementList::changed, this, [this] {
        if (m_measuring->tool().isPicking()) // what was refused before is forgotten
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
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
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
        const QString path = askForTextFile(tr("Write what the probes read"), "-probes.csv", tr("Table (*.csv)"));
        if (!path.isEmpty())
            writeProbes(path);
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
        if (!frame || probe.place.body >= frame->bodies.size())
            continue;
        const Vec3 at = placeOf(probe.place, *m_document.content().bodies[probe.place.body],
                                frame->bodies[probe.place.body]->places);
        OverlayMark mark{.color = probe.color};
        mark.mark.points = {at};
        mark.mark.label = at;
        mark.mark.text = QString::number(probe.number);
        marks.push_back(mark);
    }
    return marks;
}

void MainWindow::writeProbes(const QString& path)
{
    writeTextFile(path, csvOf(m_probes->all()));
}

QString MainWindow::askForTextFile(const QString& title, const QString& ending, const QString& filters)
{
    QSettings settings;
    const QString stem = QFileInfo(QString::fromStdString(m_document.content().model->file)).completeBaseName();
    const QDir folder(settings.value("exportFolder", settings.value("folder")).toString());
    QString path = QFileDialog::getSaveFileName(this, title, folder.filePath(stem + ending), filters);
    if (path.isEmpty())
        return {};
    settings.setValue("exportFolder", QFileInfo(path).absolutePath());
    if (QFileInfo(path).suffix().isEmpty())
        path += '.' + QFileInfo(ending).suffix();
    return path;
}

void MainWindow::askForMeasurementFile()
{
    const QString path = askForTextFile(tr("Write what was measured"), "-measured.csv", tr("Table (*.csv)"));
    if (!path.isEmpty())
        writeMeasurements(path);
}

void MainWindow::writeMeasurements(const QString& path)
{
    writeTextFile(path, csvOf(m_measuring->list().all(), m_measuring->panel().results()));
}

/// Whole or not at all, in the background.
void MainWindow::writeTextFile(const QString& path, const QString& text)
{
    if (isBusy())
        return;
    m_banner->hide();
    const auto work = [services = m_services, path, bytes = text.toUtf8()](TaskControl&) {
        services.writeSafely(QFile::encodeName(path).toStdString(), [&](const std::string& pathForNow) {
            QFile file(QFile::decodeName(pathForNow.c_str()));
            if (!file.open(QFile::WriteOnly) || file.write(bytes) != bytes.size() || !file.flush())
                throw std::runtime_error(path.toStdString() + " cannot be written (" +
                                         file.errorString().toStdString() + "). Choose another folder.");
        });
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
    const auto work = [content = m_document.content(), shown = m_viewport->shownFrame(),
                       present = m_document.frame()->snapshot](TaskControl& control) {
        return knead::compareWithOriginal(content, *shown, *present, control);
    };
    m_tasks.run<Comparison>(tr("Comparing with the original"), work,
                            [this](const Comparison& comparison) { showComparison(comparison); });
}

void MainWindow::showComparison(const Comparison& comparison)
{
    auto* dialog = new ComparisonDialog(comparison, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ComparisonDialog::reportWanted, this, [this, comparison] {
        const QString path = askForTextFile(tr("Write a report"), "-report.pdf",
                                            tr("PDF (*.pdf)") + ";;" + tr("Web page (*.html *.htm)"));
        if (!path.isEmpty())
            writeComparison(path, comparison);
    });
    dialog->show();
}

void MainWindow::writeComparison(const QString& path, const Comparison& comparison)
{
    if (isBusy())
        return;
    m_banner->hide();
    const ComparisonReport report{.part =
                                      QFileInfo(QString::fromStdString(m_document.content().model->file)).fileName(),
                                  .when = QDateTime::currentDateTime(),
                                  .comparison = comparison,
                                  .picture = m_viewport->grab().toImage(),
                                  .measurements = m_measuring->html()};
    const auto work = [services = m_services, path, report](TaskControl&) {
        services.writeSafely(QFile::encodeName(path).toStdString(),
                             [&](const std::string& pathForNow) { writeReport(report, pathForNow, path); });
        return true;
    };
    m_tasks.run<bool>(tr("Writing %1").arg(QFileInfo(path).fileName()), work,
                      [this, path](bool) { m_log->add(tr("Written: %1.").arg(path)); });
}

} // namespace knead
