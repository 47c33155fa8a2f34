#include "ui/measuring/warning_marks.h"

#include "ui/document/warning_watch.h"
#include "ui/viewport/view_grid.h"
#include "ui/viewport/viewport_widget.h"

namespace knead {

namespace {

constexpr QColor warningMarkColor(217, 119, 6); // amber: seen on light and dark grounds

} // namespace

WarningMarks::WarningMarks(const WarningWatch& watch, ViewGrid& views)
    : QObject(&views.active())
    , m_watch(watch)
    , m_view(views.active())
    , m_overlay(new MarksOverlay(m_view, [this](const Vec3& place) { return m_view.widgetPosition(place); }))
{
    m_overlay->setObjectName("warningMarks");
    connect(&views, &ViewGrid::sideAdded, this, &WarningMarks::addView);
    connect(&watch, &WarningWatch::changed, this, &WarningMarks::showMarks);
    connect(&m_view, &ViewportWidget::optionsChanged, this, &WarningMarks::showMarks);
    connect(&m_view, &ViewportBridge::renderRequested, this, &WarningMarks::showMarks);
}

void WarningMarks::addView(SideView& side)
{
    m_sides.emplace_back(new MarksOverlay(side, [&side](const Vec3& place) { return side.widgetPosition(place); }));
    showMarks();
}

void WarningMarks::showMarks()
{
    std::vector<OverlayMark> marks;
    const FramePointer& frame = m_view.shownFrame();
    if (frame && m_view.options().warnings && !m_view.isLookingBack())
        for (const PlaceWarning& warning : m_watch.warnings()) {
            if (m_view.options().hiddenParts.contains(frame->filled[warning.body]->part))
                continue;
            OverlayMark mark{.text = warning.text, .color = warningMarkColor};
            mark.mark.points = {warning.place};
            mark.mark.label = warning.place;
            marks.push_back(std::move(mark));
        }
    std::erase(m_sides, nullptr);
    if (marks.empty() && m_overlay->marks().empty()) // as nearly always: nothing is to be painted
        return;
    for (const QPointer<MarksOverlay>& side : m_sides)
        side->show(marks);
    m_overlay->show(std::move(marks));
}

} // namespace knead
