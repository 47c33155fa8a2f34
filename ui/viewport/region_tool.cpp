#include "ui/viewport/region_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr double dragDistance = 5;   // before a click becomes a shape [pixels]
constexpr double lassoStep = 3;      // [pixels]
constexpr double smallestBrush = 4;  // [pixels]
constexpr double largestBrush = 200; // [pixels]

double distance(const Pixel& a, const Pixel& b)
{
    return std::hypot(a.x - b.x, a.y - b.y);
}

} // namespace

RegionTool::RegionTool(Document& document, ScenePicker& picker, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_fields(document, picker)
{
    connect(&document, &Document::changed, this, [this](Document::Change what) {
        if (what != Document::Change::Model)
            return;
        m_fields.forget();
        giveUp(); // what was selected before is not there any more
        setHovered({});
    });
    connect(&document.selected(), &SelectionModel::levelChanged, this, [this] {
        cancel();
        setHovered({});
    });
}

void RegionTool::setShape(RegionShape shape)
{
    cancel();
    m_shape = shape;
    emit drawnChanged();
}

void RegionTool::setBrushRadius(double radius)
{
    m_brushRadius = std::clamp(radius, smallestBrush, largestBrush);
    emit drawnChanged();
}

void RegionTool::press(const Pixel& pixel, Qt::KeyboardModifiers modifiers)
{
    const SelectionModel& selected = m_document.selected();
    m_press = Press{.start = pixel, .last = pixel, .modifiers = modifiers, .before = selected.region()};
    // On a part a drag may mean to move it.
    m_press->canDraw = selected.level() != Level::Part || m_fields.at(Level::Part, pixel).isEmpty();
    if (m_shape == RegionShape::Brush && selected.level() != Level::Part) {
        m_press->isDrawing = true;
        m_cursor = pixel;
        setHovered({});
        if (!(modifiers & (Qt::ControlModifier | Qt::ShiftModifier)))
            m_document.selected().clear();
        paint(pixel, pixel);
    }
}

void RegionTool::drag(const Pixel& pixel)
{
    if (!m_press)
        return;
    m_cursor = pixel;
    if (m_shape == RegionShape::Brush && m_press->isDrawing) {
        paint(std::exchange(m_press->last, pixel), pixel);
        emit drawnChanged();
        return;
    }
    if (!m_press->canDraw || (!m_press->isDrawing && distance(m_press->start, pixel) < dragDistance))
        return;
    if (!std::exchange(m_press->isDrawing, true)) {
        setHovered({});
        m_drawn = {m_press->start};
    }
    m_press->last = pixel;
    if (m_shape != RegionShape::Lasso)
        m_drawn = boxShape(m_press->start, pixel);
    else if (distance(m_drawn.back(), pixel) >= lassoStep)
        m_drawn.push_back(pixel);
    emit drawnChanged();
}

void RegionTool::release()
{
    if (!m_press)
        return;
    if (m_shape == RegionShape::Brush && m_press->isDrawing) {
        m_press.reset();
        emit drawnChanged();
        return;
    }
    if (m_press->isDrawing) {
        const ScreenShape shape = std::exchange(m_drawn, {});
        select(m_fields.within(shape, query()));
    } else {
        select(m_fields.at(m_document.selected().level(), m_press->start));
    }
    m_press.reset();
    emit drawnChanged();
    emit hoverChanged();
}

bool RegionTool::cancel()
{
    if (!m_press)
        return false;
    const bool wasDrawing = m_press->isDrawing;
    if (wasDrawing && m_shape == RegionShape::Brush)
        m_document.selected().select(m_press->before);
    giveUp();
    return wasDrawing;
}

void RegionTool::giveUp()
{
    m_press.reset();
    m_drawn.clear();
    emit drawnChanged();
}

/// A stroke of the brush adds, or takes away, as it goes: all that it swept over at a time.
void RegionTool::paint(const Pixel& from, const Pixel& to)
{
    using How = SelectionModel::How;
    const RegionView::Query wanted = query();
    Region found = m_fields.within(strokeShape(from, to, m_brushRadius), wanted);
    if (wanted.level == Level::Face) // one that is wider than the brush has no corner under it
        found = united(found, m_fields.along(wanted.level, from, to, m_brushRadius));
    if (!found.isEmpty())
        m_document.selected().select(found, m_press->modifiers & Qt::ShiftModifier ? How::Remove : How::Add);
}

void RegionTool::select(const Region& region)
{
    using How = SelectionModel::How;
    const bool isClick = !m_press->isDrawing;
    const How how = m_press->modifiers & Qt::ShiftModifier     ? How::Remove
                    : m_press->modifiers & Qt::ControlModifier ? (isClick ? How::Toggle : How::Add)
                                                               : How::Replace;
    const bool isBesideAll = isClick && region.isEmpty(); // which leaves the tool that one drives
    if (isBesideAll && m_document.selection().kind == Selection::Kind::Tool)
        return;
    if (!region.isEmpty() || how == How::Replace)
        m_document.selected().select(region, how);
}

RegionView::Query RegionTool::query() const
{
    const SelectionModel& selected = m_document.selected();
    return {.level = selected.level(),
            .isWhole = m_shape == RegionShape::Rectangle && m_press && !isTouching(),
            .isThrough = selected.isThrough()};
}

bool RegionTool::isTouching() const
{
    return m_press && m_press->last.x < m_press->start.x;
}

void RegionTool::hover(const Pixel& pixel)
{
    m_cursor = pixel;
    if (brush())
        emit drawnChanged();
    setHovered(brush() ? Region{} : m_fields.at(m_document.selected().level(), pixel));
}

void RegionTool::leave()
{
    m_cursor.reset();
    setHovered({});
    emit drawnChanged();
}

void RegionTool::setHovered(Region region)
{
    if (region.isEmpty())
        region = {};
    if (region == m_hovered)
        return;
    m_hovered = std::move(region);
    emit hoverChanged();
}

std::optional<Pixel> RegionTool::brush() const
{
    return m_shape == RegionShape::Brush && m_document.selected().level() != Level::Part ? m_cursor : std::nullopt;
}

} // namespace knead
