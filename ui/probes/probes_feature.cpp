#include "ui/probes/probes_feature.h"

#include "ui/frame/docks.h"
#include "ui/frame/text_files.h"
#include "ui/measuring/measuring.h"
#include "ui/panels/probe_panel.h"
#include "ui/probes/probe_set.h"
#include "ui/project/project_keeper.h"
#include "ui/theme.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QMainWindow>
#include <QPointer>

#include <string>

namespace knead {

ProbesFeature::ProbesFeature(const Workbench& bench, Measuring& measuring, ProjectKeeper& keeper)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_probes(new ProbeSet(bench.document, &bench.window))
{
    auto* panel = new ProbePanel(*m_probes, newPlaceAction(measuring));
    bench.docks.add("probeDock", tr("Probes"), panel);
    connect(panel, &ProbePanel::csvWanted, this, [this] {
        askForTextFile(m_bench, tr("Write what the probes read"), "-probes.csv", {tr("Table (*.csv)")},
                       [this](const QString& path) { write(path); });
    });
    const QPointer<ProbeSet> probes = m_probes;
    keeper.keepPanel("probes", {.memory = [probes] { return probes ? probes->memory() : std::string(); },
                                .remember =
                                    [probes](const std::string& memory) {
                                        if (probes)
                                            probes->remember(memory);
                                    }});
    connect(m_probes, &ProbeSet::changed, &keeper, &ProjectKeeper::panelChanged);
    const auto mark = [this, &measuring] { measuring.setOtherMarks(probeMarks()); };
    connect(m_probes, &ProbeSet::changed, this, mark);
    connect(&bench.viewport, &ViewportBridge::renderRequested, this, [this, mark] {
        if (!m_probes->all().empty())
            mark();
    });
}

QAction* ProbesFeature::newPlaceAction(Measuring& measuring)
{
    auto* place = new QAction(icon("probe"), tr("Place probe"), &m_bench.window);
    place->setObjectName("placeProbe");
    place->setShortcut(QKeySequence(Qt::Key_P));
    place->setToolTip(tr("Click places of the part to plot what happens there over time"));
    m_bench.window.addAction(place);
    measuring.addPickAction(place, {PickWhat::place},
                            [this](const std::vector<SkinPlace>& places) { m_probes->add(places.front()); });
    connect(place, &QAction::toggled, this, [this](bool on) {
        if (on)
            m_bench.docks.show("probeDock");
    });
    return place;
}

std::vector<OverlayMark> ProbesFeature::probeMarks() const
{
    std::vector<OverlayMark> marks;
    const FramePointer& frame = m_bench.viewport.shownFrame();
    for (const Probe& probe : m_probes->all()) {
        const auto at =
            frame ? seenPlace(probe.place, m_bench.document.content(), *frame, m_bench.viewport.options().hiddenParts)
                  : std::nullopt;
        if (!at)
            continue;
        OverlayMark mark{.color = probe.color};
        mark.mark.points = {*at};
        mark.mark.label = *at;
        mark.text = QString::number(probe.number);
        marks.push_back(mark);
    }
    return marks;
}

void ProbesFeature::write(const QString& path)
{
    writeTextFile(m_bench, path, [probes = m_probes->all()] { return csvOf(probes).toUtf8(); });
}

} // namespace knead
