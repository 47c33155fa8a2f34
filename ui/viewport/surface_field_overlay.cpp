#include "ui/viewport/surface_field_overlay.h"

#include "ui/viewport/cap_actor.h"
#include "ui/viewport/color_legend.h"
#include "ui/viewport/section_handles.h"
#include "ui/viewport/viewport_widget.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr int inset = 12;        // of the legend from the corner of the view [pixels]
constexpr double keyStep = 0.01; // of the size of the content

/// How far along a line (through `place`) the point next to a ray is [m]; empty when they run side by side.
std::optional<double> alongLine(const Vec3& place, const Vec3& direction, const Ray& ray)
{
    const double slope = direction.dot(ray.direction);
    const double spread = 1 - slope * slope;
    if (spread < 1e-6)
        return std::nullopt;
    const Vec3 from = ray.origin - place;
    return (from.dot(direction) - slope * from.dot(ray.direction)) / spread;
}

} // namespace

std::pair<double, double> reachAlong(const Vec3& normal, const Box& box)
{
    const double middle = normal.dot(box.center());
    const double half = normal.cwiseAbs().dot(box.sizes()) / 2;
    return {middle - half, middle + half};
}

SurfaceFieldOverlay::SurfaceFieldOverlay(ViewportWidget& view)
    : QObject(&view)
    , m_view(view)
    , m_legend(new ColorLegend(&view))
    , m_divider(new DividerHandle(&view))
    , m_knob(new SectionKnob(&view))
{
    connect(m_divider, &DividerHandle::dragged, &m_view, &ViewportWidget::moveDivider);
    connect(m_knob, &SectionKnob::grabbed, this, [this](const QPointF& at) {
        if (const std::optional<CutPlane>& plane = m_view.options().section.plane) {
            m_way = m_knobPlace - plane->normal.dot(m_knobPlace) * plane->normal;
            m_grabbed = offsetAt(at) - plane->offset;
        }
    });
    // Another part may come, and the plane go, under the hand.
    connect(m_knob, &SectionKnob::dragged, this, [this](const QPointF& to) {
        if (m_view.options().section.plane)
            moveSection(offsetAt(to) - m_grabbed);
    });
    connect(m_knob, &SectionKnob::stepped, this, [this](int steps) {
        if (const std::optional<CutPlane>& plane = m_view.options().section.plane)
            moveSection(plane->offset + steps * keyStep * m_box.sizes().maxCoeff());
    });
}

void SurfaceFieldOverlay::place(const std::optional<ColorScale>& scale, const Box& box)
{
    m_box = box;
    const SceneOptions& options = m_view.options();
    const bool tellsBend = !scale && options.shading == Shading::curvature && !box.isEmpty();
    if (scale)
        m_legend->show(*scale, m_isPast);
    else if (tellsBend)
        m_legend->showCurvature();
    else
        m_legend->hide();
    const bool isThere = scale || tellsBend;
    if (isThere)
        m_legend->move(m_view.width() - m_legend->width() - inset, m_view.height() - m_legend->height() - inset);
    m_view.keepFree(m_legend, {.right = isThere ? m_legend->width() + inset : 0.0});
    m_divider->setVisible(options.divider.has_value());
    if (options.divider)
        m_divider->placeAt(*options.divider);
    m_knob->setVisible(options.section.plane.has_value() && options.section.hasFrame);
    if (options.section.plane)
        placeKnob();
}

/// At the highest corner of the plane's rectangle, out of the way of the part.
void SurfaceFieldOverlay::placeKnob()
{
    const CutPlane& plane = *m_view.options().section.plane;
    std::optional<QPointF> highest;
    for (const Vec3& corner : frameCorners(plane, m_box))
        if (const std::optional<QPointF> seen = m_view.widgetPosition(corner);
            seen && (!highest || seen->y() < highest->y() - 0.5)) {
            highest = seen;
            m_knobPlace = corner;
        }
    if (!highest) {
        m_knob->hide();
        return;
    }
    const std::optional<QPointF> ahead =
        m_view.widgetPosition(m_knobPlace + 0.05 * m_box.sizes().maxCoeff() * plane.normal);
    const QPointF direction = ahead ? *ahead - *highest : QPointF(0, -1);
    const QRect inside = m_view.rect().adjusted(inset + 4, inset + 4, -inset - 4, -inset - 4);
    const QPointF center(std::clamp(highest->x(), double(inside.left()), double(inside.right())),
                         std::clamp(highest->y(), double(inside.top()), double(inside.bottom())));
    m_knob->placeAt(center, std::hypot(direction.x(), direction.y()) > 0.5 ? direction : QPointF(0, -1));
}

/// Where the plane would be with the mouse on its knob. Seen along the normal, up and down moves it.
double SurfaceFieldOverlay::offsetAt(const QPointF& position) const
{
    const Vec3& normal = m_view.options().section.plane->normal;
    if (const std::optional<double> along = alongLine(m_way, normal, m_view.rayAt(position)))
        return *along;
    return (m_view.height() / 2.0 - position.y()) * m_view.camera().viewHeight() / std::max(1, m_view.height());
}

void SurfaceFieldOverlay::moveSection(double offset)
{
    SceneOptions options = m_view.options();
    CutPlane& plane = *options.section.plane;
    const auto [least, most] = reachAlong(plane.normal, m_view.materialBox());
    plane.offset = std::clamp(offset, least, most);
    m_view.setOptions(options);
}

} // namespace knead
