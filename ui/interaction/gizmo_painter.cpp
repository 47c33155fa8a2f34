#include "ui/interaction/gizmo_painter.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>

namespace knead {

namespace {

constexpr double lineWidth = 2.6; // [pixels]
constexpr double litWidth = 4;    // [pixels]
constexpr double haloWidth = 2.4; // on top of a line's own [pixels]
constexpr double headLength = 15; // of an arrow [pixels]
constexpr double headWidth = 5.5; // half of it [pixels]
constexpr double aroundRing = 12; // [pixels]
constexpr double fadedOpacity = 0.28;

const std::array<QColor, 3> axisColors = {QColor(0xe5, 0x48, 0x4d), QColor(0x3a, 0xa8, 0x52), QColor(0x3b, 0x7d, 0xf0)};
const QColor litColor(0xff, 0xc5, 0x2e);
const QColor haloColor(0, 0, 0, 90);

QPointF point(const Pixel& pixel)
{
    return {pixel.x, pixel.y};
}

/// One drawing of a gizmo.
class Drawer {
public:
    Drawer(QPainter& painter, const Gizmo& gizmo, GizmoPart lit, bool inUse)
        : m_painter(painter)
        , m_gizmo(gizmo)
        , m_lit(lit)
        , m_inUse(inUse)
    {
    }

    void draw(GizmoPart part)
    {
        if (!m_gizmo.isUsable(part))
            return;
        m_painter.setOpacity(m_inUse && part != m_lit ? fadedOpacity : 1);
        const int axis = axisOf(part);
        const QColor color = part == m_lit ? litColor : axisColors[static_cast<std::size_t>(axis)];
        const double width = part == m_lit ? litWidth : lineWidth;
        switch (motionOf(part)) {
        case GizmoMotion::turn:
            drawRing(axis, color, width);
            break;
        case GizmoMotion::plane:
            drawPlane(axis, color, part == m_lit);
            break;
        case GizmoMotion::move:
            drawArrow(axis, color, width);
            break;
        case GizmoMotion::free:
            drawMiddle(part == m_lit);
            break;
        case GizmoMotion::none:
            break;
        }
    }

private:
    void strokeTwice(const QPolygonF& line, const QColor& color, double width)
    {
        for (const auto& [penColor, penWidth] : {std::pair(haloColor, width + haloWidth), std::pair(color, width)}) {
            m_painter.setPen(QPen(penColor, penWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            m_painter.setBrush(Qt::NoBrush);
            m_painter.drawPolyline(line);
        }
    }

    void drawRing(int axis, const QColor& color, double width)
    {
        QPolygonF line;
        for (const Pixel& pixel : m_gizmo.ringLine(axis))
            line << point(pixel);
        strokeTwice(line, color, width);
    }

    void drawArrow(int axis, const QColor& color, double width)
    {
        const QPointF begin = point(m_gizmo.pixelOf(Gizmo::shaftBegin * Vec3::Unit(axis)));
        const QPointF tip = point(m_gizmo.pixelOf(Gizmo::shaftEnd * Vec3::Unit(axis)));
        const QPointF way = tip - begin;
        const double length = std::hypot(way.x(), way.y());
        const QPointF along = way / std::max(length, 1.0);
        const QPointF across(-along.y(), along.x());
        const QPointF neck = tip - std::min(headLength, length) * along;
        strokeTwice(QPolygonF({begin, neck}), color, width);
        m_painter.setPen(QPen(haloColor, haloWidth / 2));
        m_painter.setBrush(color);
        m_painter.drawPolygon(QPolygonF({tip, neck + headWidth * across, neck - headWidth * across}));
    }

    void drawPlane(int axis, QColor color, bool isLit)
    {
        QPolygonF square;
        for (const Pixel& corner : m_gizmo.planeCorners(axis))
            square << point(corner);
        m_painter.setPen(QPen(color, 1.5));
        color.setAlphaF(isLit ? 0.85F : 0.45F);
        m_painter.setBrush(color);
        m_painter.drawPolygon(square);
    }

    void drawMiddle(bool isLit)
    {
        m_painter.setPen(QPen(haloColor, 1.5));
        m_painter.setBrush(isLit ? litColor : QColor(255, 255, 255, 210));
        m_painter.drawEllipse(point(m_gizmo.middlePixel()), Gizmo::middle - 3, Gizmo::middle - 3);
    }

    QPainter& m_painter;
    const Gizmo& m_gizmo;
    GizmoPart m_lit;
    bool m_inUse;
};

} // namespace

QRect gizmoArea(const Gizmo& gizmo)
{
    if (!gizmo.isVisible())
        return {};
    const QPointF middle = point(gizmo.middlePixel());
    // Perspective makes what is nearer to the eye larger.
    const double reach = 1.35 * Gizmo::ring + aroundRing;
    return QRectF(middle - QPointF(reach, reach), QSizeF(2 * reach, 2 * reach)).toAlignedRect();
}

void drawGizmo(QPainter& painter, const Gizmo& gizmo, GizmoPart lit, bool inUse)
{
    Drawer drawer(painter, gizmo, lit, inUse);
    // Rings at the back, the handle in use in front.
    for (const GizmoMotion motion : {GizmoMotion::turn, GizmoMotion::plane, GizmoMotion::move, GizmoMotion::free})
        for (const GizmoPart part : allGizmoParts)
            if (motionOf(part) == motion && part != lit)
                drawer.draw(part);
    drawer.draw(lit);
    painter.setOpacity(1);
}

} // namespace knead
