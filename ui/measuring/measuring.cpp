#include "ui/measuring/measuring.h"

#include "ui/commands/availability.h"
#include "ui/document/document.h"
#include "ui/language/said.h"
#include "ui/measuring/measurement_words.h"
#include "ui/modes.h"
#include "ui/panels/measure_panel.h"
#include "ui/theme.h"
#include "ui/units.h"
#include "ui/viewport/side_view.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QMainWindow>
#include <QMenu>
#include <QTimer>

#include <algorithm>

namespace knead {

namespace {

constexpr int updateTime = 33;    // [ms]
constexpr int restPerRefresh = 4; // times as long as a refresh takes, the window does something else

QString text(const char* source)
{
    return QCoreApplication::translate("Measurement", source);
}

} // namespace

Measuring::Measuring(const Workbench& bench, Modes& modes)
    : QObject(&bench.window)
    , m_document(bench.document)
    , m_view(bench.viewport)
    , m_availability(bench.availability)
    , m_modes(modes)
    , m_list(new MeasurementList(m_document, this))
    , m_tool(new PickTool(m_document, m_view, this))
    , m_overlay(new MarksOverlay(m_view, [this](const Vec3& place) { return m_view.widgetPosition(place); }))
    , m_soon(new QTimer(this))
{
    makeActions(bench.window);
    m_panel = new MeasurePanel(*m_list, m_actions, &bench.window); // only those that measure, as yet
    m_soon->setSingleShot(true);
    m_soon->setInterval(updateTime);
    connect(m_soon, &QTimer::timeout, this, &Measuring::refresh);
    connect(&m_document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Model)
            m_frame = nullptr;
        soon();
    });
    connect(&m_view, &ViewportBridge::renderRequested, this, [this] {
        if (m_view.shownFrame() != m_frame)
            soon();
    });
    connect(&m_view, &ViewportWidget::optionsChanged, this, &Measuring::showMarks); // parts were hidden
    connect(m_list, &MeasurementList::changed, this, &Measuring::refresh);
    connect(m_panel, &MeasurePanel::selectionChanged, this, &Measuring::showMarks);
    connect(m_tool, &PickTool::refused, this, &Measuring::refused);
    connect(m_tool, &PickTool::changed, this, [this] {
        m_overlay->setPrompt(m_tool->prompt());
        showMarks();
        emit promptChanged();
    });
    connect(m_tool, &PickTool::stopped, this, [this] {
        m_view.setMode({});
        m_picking->setChecked(false);
    });
}

Measuring::~Measuring() = default;

void Measuring::makeActions(QWidget& window)
{
    for (const MeasureLook& look : measureLooks()) {
        auto* action = new QAction(icon(look.icon), text(look.text), &window);
        action->setObjectName(look.name);
        action->setToolTip(text(look.tip));
        if (look.kind == MeasureKind::distance)
            action->setShortcut(QKeySequence(Qt::Key_M));
        window.addAction(action);
        addPickAction(action, look.picks,
                      [this, kind = look.kind](const std::vector<SkinPlace>& places) { m_list->add(kind, places); });
    }
}

QAction* Measuring::action(MeasureKind kind) const
{
    return m_actions[static_cast<int>(kind)];
}

void Measuring::fillMenu(QMenu* menu) const
{
    menu->setObjectName("measureMenu");
    menu->setToolTipsVisible(true);
    for (QAction* action : m_actions) {
        if (m_actions.indexOf(action) == static_cast<int>(measureLooks().size()))
            menu->addSeparator(); // what others pick
        menu->addAction(action);
    }
}

void Measuring::addPickAction(QAction* action, std::vector<PickWhat> picks, PickTool::Done done)
{
    action->setCheckable(true);
    m_actions.append(action);
    m_modes.add(action);
    m_availability.needBodies({action});
    connect(action, &QAction::toggled, this, [this, action, picks = std::move(picks), done = std::move(done)](bool on) {
        if (!on)
            return m_tool->stop();
        m_picking = action;
        m_view.setMode(Qt::CrossCursor);
        m_tool->begin(action->text(), picks, done);
    });
    connect(action, &QAction::changed, this, [this, action] {
        if (m_picking == action && m_tool->isPicking())
            m_tool->setTitle(action->text()); // in another language
    });
}

void Measuring::setOtherMarks(std::vector<OverlayMark> marks)
{
    m_others = std::move(marks);
    showMarks();
}

void Measuring::addView(SideView& side)
{
    m_sides.emplace_back(new MarksOverlay(side, [&side](const Vec3& place) { return side.widgetPosition(place); }));
    connect(&side, &SideView::hovered, m_tool, [this, &side](const QPointF& position) {
        m_tool->hoverFrom({side.camera(), side.window()}, position);
    });
    connect(&side, &SideView::left, m_tool, &PickTool::leave);
}

void Measuring::soon()
{
    if (!m_soon->isActive() && (!m_list->all().empty() || m_tool->isPicking()))
        m_soon->start();
}

/// Leaves the window most of its time, however much there is to measure.
void Measuring::refresh()
{
    QElapsedTimer clock;
    clock.start();
    m_frame = m_view.shownFrame();
    std::vector<Measured> results;
    if (m_frame)
        for (const Measurement& measurement : m_list->all())
            results.push_back(measured(measurement, m_document.content(), *m_frame, *m_document.frame()->snapshot));
    m_panel->show(results);
    showMarks();
    m_soon->setInterval(std::max(updateTime, restPerRefresh * static_cast<int>(clock.elapsed())));
}

void Measuring::showMarks()
{
    std::vector<OverlayMark> marks = m_others;
    const std::vector<std::size_t> selected = m_panel->selected();
    const std::vector<Measured>& results = m_panel->results();
    const std::vector<Measurement>& all = m_list->all();
    for (std::size_t i = 0; i < std::min(all.size(), results.size()); ++i)
        if (isSeen(all[i]))
            marks.push_back(
                {results[i].mark, textOf(all[i], results[i]), std::count(selected.begin(), selected.end(), i) > 0, {}});
    std::vector<OverlayMark> making;
    if (m_tool->isPicking() && m_view.shownFrame())
        making.push_back(markInTheMaking());
    marks.insert(marks.end(), making.begin(), making.end());
    m_overlay->show(std::move(marks));
    std::erase(m_sides, nullptr);
    for (const QPointer<MarksOverlay>& side : m_sides)
        side->show(making);
}

/// What belongs to hidden parts is listed, not shown.
bool Measuring::isSeen(const Measurement& measurement) const
{
    const FramePointer& frame = m_view.shownFrame();
    return frame && std::all_of(measurement.places.begin(), measurement.places.end(), [&](const SkinPlace& place) {
               return seenPlace(place, m_document.content(), *frame, m_view.options().hiddenParts).has_value();
           });
}

/// What is picked already, with a line to the cursor.
OverlayMark Measuring::markInTheMaking() const
{
    const Frame& frame = *m_view.shownFrame();
    const auto placeNow = [&](const SkinPlace& place) {
        return seenPlace(place, m_document.content(), frame, m_view.options().hiddenParts);
    };
    OverlayMark making;
    making.isStrong = true;
    std::vector<Vec3> line;
    for (const SkinPlace& place : m_tool->picked())
        if (const auto at = placeNow(place))
            line.push_back(*at);
    const auto& hovered = m_tool->hovered();
    if (const auto at = hovered ? placeNow(hovered->place) : std::nullopt) {
        line.push_back(*at);
        making.mark.label = *at;
        if (hovered->isCorner)
            making.text = tr("Corner");
    }
    making.mark.points = line;
    making.mark.lines.push_back(std::move(line));
    return making;
}

QString Measuring::html() const
{
    if (m_list->all().empty())
        return {};
    QString table = QStringLiteral("<table border=\"1\" cellspacing=\"0\" cellpadding=\"5\"><tr>");
    for (const QString& heading : {tr("Measurement"), tr("Reading"), tr("Now"), tr("At rest")})
        table += "<th>" + heading.toHtmlEscaped() + "</th>";
    table += "</tr>";
    const std::vector<Measured>& results = m_panel->results();
    for (std::size_t i = 0; i < results.size(); ++i)
        for (const Reading& reading : results[i].readings) {
            table += "<tr>";
            for (const QString& cell :
                 {nameOf(m_list->all()[i]), said(reading.name), formatQuantity(reading.now, reading.quantity),
                  formatQuantity(reading.rest, reading.quantity)})
                table += "<td>" + cell.toHtmlEscaped() + "</td>";
            table += "</tr>";
        }
    return table + "</table>";
}

} // namespace knead
