// The lines between several views, which are dragged with the mouse, and what of the views is remembered.
#include "ui/viewport/view_grid.h"
#include "ui/viewport/view_name.h"

#include <QMouseEvent>
#include <QSettings>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knead {

namespace {

constexpr const char* arrangementNames[] = {"one", "two", "four"};
constexpr const char* slotNames[viewSlots] = {"free", "front", "top", "right"};
constexpr double middle = 0.5; // share on either side of a line

Qt::CursorShape cursorOf(const ViewCells::Lines& lines)
{
    if (lines.upright && lines.level)
        return Qt::SizeAllCursor;
    if (lines)
        return lines.upright ? Qt::SplitHCursor : Qt::SplitVCursor;
    return Qt::ArrowCursor;
}

/// Settings are files that anybody may have written.
double shareFrom(const QVariant& value)
{
    const double share = value.toDouble();
    return std::isfinite(share) ? std::clamp(share, 0.15, 0.85) : middle;
}

QVariantList turnOf(const Camera& camera)
{
    return {camera.yaw, camera.pitch, camera.perspective};
}

Camera turned(Camera camera, const QVariantList& turn)
{
    constexpr double pi = std::numbers::pi;
    if (turn.size() != 3 || !std::isfinite(turn[0].toDouble()) || !std::isfinite(turn[1].toDouble()))
        return camera;
    camera.yaw = std::remainder(turn[0].toDouble(), 2 * pi);
    camera.pitch = std::clamp(turn[1].toDouble(), -pi / 2, pi / 2);
    camera.perspective = turn[2].toBool();
    return camera;
}

} // namespace

void ViewGrid::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && !isSingle())
        m_dragged = m_cells.linesAt(event->position().toPoint(), rect());
}

void ViewGrid::mouseMoveEvent(QMouseEvent* event)
{
    const QPoint place = event->position().toPoint();
    if (!(event->buttons() & Qt::LeftButton))
        m_dragged = {};
    if (!m_dragged) {
        setCursor(cursorOf(isSingle() ? ViewCells::Lines() : m_cells.linesAt(place, rect())));
        return;
    }
    m_cells.move(m_dragged, place, rect());
    layOut();
}

void ViewGrid::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !m_dragged)
        return;
    m_dragged = {};
    remember();
}

/// To the middle again.
void ViewGrid::mouseDoubleClickEvent(QMouseEvent* event)
{
    const ViewCells::Lines lines =
        isSingle() ? ViewCells::Lines() : m_cells.linesAt(event->position().toPoint(), rect());
    if (event->button() != Qt::LeftButton || !lines)
        return;
    if (lines.upright)
        m_cells.column = middle;
    if (lines.level)
        m_cells.row = middle;
    layOut();
    remember();
}

void ViewGrid::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        showNames();
}

void ViewGrid::remember() const
{
    if (!m_remembers)
        return;
    QSettings settings;
    settings.setValue("views/arrangement", arrangementNames[static_cast<std::size_t>(arrangement())]);
    settings.setValue("views/linked", m_areLinked);
    settings.setValue("views/column", m_cells.column);
    settings.setValue("views/row", m_cells.row);
    settings.setValue("views/second", slotNames[indexOf(m_cells.second)]);
    for (const ViewSlot slot : {ViewSlot::front, ViewSlot::top, ViewSlot::right})
        settings.setValue(QStringLiteral("views/") + slotNames[indexOf(slot)], turnOf(camera(slot)));
}

void ViewGrid::restore()
{
    const QSettings settings;
    m_cells.column = shareFrom(settings.value("views/column", middle));
    m_cells.row = shareFrom(settings.value("views/row", middle));
    const QString second = settings.value("views/second").toString();
    for (const ViewSlot slot : {ViewSlot::front, ViewSlot::top, ViewSlot::right}) {
        const char* name = slotNames[indexOf(slot)];
        if (second == name)
            m_cells.second = slot;
        setCamera(slot, turned(camera(slot), settings.value(QStringLiteral("views/") + name).toList()));
    }
    m_areLinked = settings.value("views/linked", false).toBool();
    const auto at = std::find(std::begin(arrangementNames), std::end(arrangementNames),
                              settings.value("views/arrangement").toString());
    m_remembers = true;
    if (at != std::end(arrangementNames))
        m_cells.arrangement = static_cast<ViewArrangement>(at - std::begin(arrangementNames));
    layOut();
    emit changed();
}

} // namespace knead
