#include "ui/measuring/measuring_feature.h"

#include "ui/frame/docks.h"
#include "ui/frame/notices.h"
#include "ui/frame/text_files.h"
#include "ui/language/retranslation.h"
#include "ui/measuring/measuring.h"
#include "ui/panels/measure_panel.h"
#include "ui/viewport/view_grid.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>

#include <memory>

namespace knead {

MeasuringFeature::MeasuringFeature(const Workbench& bench, Modes& modes)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_measuring(new Measuring(bench, modes))
    , m_menu(new QMenu(tr("&Measure"), &bench.window))
{
    connect(&bench.views, &ViewGrid::sideAdded, m_measuring, &Measuring::addView);
    bench.docks.add("measureDock", tr("Measurements"), &m_measuring->panel());
    connect(&m_measuring->tool(), &PickTool::begun, this, [this] { m_bench.docks.show("measureDock"); });
    connect(&m_measuring->panel(), &MeasurePanel::placeWanted, this, &MeasuringFeature::placeWanted);
    connect(&m_measuring->panel(), &MeasurePanel::csvWanted, this, &MeasuringFeature::askForFile);
    forgetRefusals();
}

/// What could not be measured is said until something else is tried.
void MeasuringFeature::forgetRefusals()
{
    const auto refused = std::make_shared<QString>();
    connect(m_measuring, &Measuring::refused, this, [this, refused](const QString& sentence) {
        *refused = sentence;
        m_bench.notices.problem(sentence);
    });
    connect(&m_measuring->list(), &MeasurementList::changed, this, [this, refused] {
        if (m_measuring->tool().isPicking() && m_bench.notices.shown() == saidAnew(*refused)) // what others said stays
            m_bench.notices.hide();
    });
}

void MeasuringFeature::askForFile()
{
    askForTextFile(m_bench, tr("Write what was measured"), "-measured.csv", {tr("Table (*.csv)")},
                   [this](const QString& path) { write(path); });
}

void MeasuringFeature::write(const QString& path)
{
    writeTextFile(m_bench, path, [list = m_measuring->list().all(), results = m_measuring->panel().results()] {
        return csvOf(list, results).toUtf8();
    });
}

} // namespace knead
