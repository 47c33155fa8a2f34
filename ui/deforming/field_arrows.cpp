#include "ui/deforming/field_arrows.h"

#include "core/geometry/vec3.h"
#include "ui/viewport/viewport_widget.h"

#include <QLineF>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>
#include <vector>

namespace knead {

namespace {

constexpr int arrowsAlong = 14;     // the longest side of a field
constexpr double shortestArrow = 3; // [pixels]; what is shorter is a dot
constexpr double largestHead = 8;   // [pixels]
constexpr int edgeOfArrows = 12;    // around them [pixels]
const QColor arrowColor(0xe0, 0x50, 0x20);
const QColor arrowRim(255, 255, 255, 170);

void drawWay(QPainter& painter, const QPointF& from, const QPointF& to)
{
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (length < shortestArrow) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(arrowColor);
        painter.drawEllipse(from, 1.5, 1.5);
        return;
    }
    const QPointF along = way / length;
    const QPointF across(-along.y(), along.x());
    const double head = std::min(largestHead, 0.5 * length);
    const QPointF neck = to - head * along;
    for (const auto& [color, width] : {std::pair(arrowRim, 3.0), std::pair(arrowColor, 1.4)}) {
        painter.setPen(QPen(color, width));
        painter.drawLine(from, neck);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(arrowColor);
    painter.drawPolygon(QPolygonF({to, neck + 0.45 * head * across, neck - 0.45 * head * across}));
}

} // namespace

DisplacementField thinned(const DisplacementField& field, int along)
{
    DisplacementField few;
    Box box;
    for (const Vec3& node : field.nodes)
        box.extend(node);
    if (box.isEmpty())
        return few;
    const double cell = std::max(box.sizes().maxCoeff() / along, 1e-12);
    const int stride = along + 1;
    std::vector<bool> taken(static_cast<std::size_t>(stride) * stride *
                            stride); // quick: there may be millions of nodes
    for (std::size_t i = 0; i < field.nodes.size(); ++i) {
        const Eigen::Vector3i at = ((field.nodes[i] - box.min()) / cell).cast<int>().cwiseMin(along);
        const auto cube = static_cast<std::size_t>((at.z() * stride + at.y()) * stride + at.x());
        if (taken[cube])
            continue;
        taken[cube] = true;
        few.nodes.push_back(field.nodes[i]);
        few.displacements.push_back(field.displacements[i]);
    }
    return few;
}

FieldArrows::FieldArrows(ViewportWidget& view)
    : m_view(view)
    , m_overlay(new ViewOverlay(view, *this, "fieldArrows"))
{
}

void FieldArrows::show(const std::shared_ptr<const DisplacementField>& field, double scale)
{
    if (m_field != field)
        m_arrows = thinned(*field, arrowsAlong);
    m_field = field;
    m_scale = scale;
    m_overlay->refresh();
}

void FieldArrows::hide()
{
    m_field = nullptr;
    m_arrows = {};
    m_overlay->refresh();
}

QRect FieldArrows::overlayArea() const
{
    QPolygonF ends;
    for (std::size_t i = 0; i < m_arrows.nodes.size(); ++i)
        for (const double share : {0.0, m_scale})
            if (const auto seen = m_view.widgetPosition(m_arrows.nodes[i] + share * m_arrows.displacements[i]))
                ends << *seen;
    if (ends.isEmpty())
        return {};
    return ends.boundingRect().toAlignedRect().adjusted(-edgeOfArrows, -edgeOfArrows, edgeOfArrows, edgeOfArrows);
}

void FieldArrows::drawOverlay(QPainter& painter) const
{
    for (std::size_t i = 0; i < m_arrows.nodes.size(); ++i) {
        const auto from = m_view.widgetPosition(m_arrows.nodes[i]);
        const auto to = m_view.widgetPosition(m_arrows.nodes[i] + m_scale * m_arrows.displacements[i]);
        if (from && to)
            drawWay(painter, *from, *to);
    }
}

} // namespace knead
