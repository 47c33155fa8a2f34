#include "ui/interaction/spring_line.h"

#include <QPainter>
#include <QPalette>
#include <QPolygonF>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr int turns = 9;
constexpr double widest = 9;      // half of the coil's width [pixels]
constexpr double endShare = 0.12; // of the length that is straight, at both ends
constexpr int margin = 14;        // [pixels]

QPolygonF coil(const QPointF& from, const QPointF& to)
{
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    const QPointF along = way / std::max(length, 1.0);
    const QPointF across(-along.y(), along.x());
    // A wire of one length: the further it is drawn, the narrower it gets.
    const double width = widest / std::sqrt(1 + length / 160);
    QPolygonF line({from});
    for (int i = 0; i <= 2 * turns; ++i) {
        const double share = endShare + (1 - 2 * endShare) * i / (2 * turns);
        const double side = i == 0 || i == 2 * turns ? 0 : (i % 2 == 0 ? -width : width);
        line << from + share * way + side * across;
    }
    return line << to;
}

} // namespace

QRect springArea(const QPointF& from, const QPointF& to)
{
    return QRectF(from, to).normalized().toAlignedRect().adjusted(-margin, -margin, margin, margin);
}

void drawSpring(QPainter& painter, const QPointF& from, const QPointF& to, const QPalette& palette)
{
    const QColor color = palette.color(QPalette::Highlight);
    for (const auto& [pen, width] : {std::pair(QColor(255, 255, 255, 170), 4.6), std::pair(color, 2.2)}) {
        painter.setPen(QPen(pen, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(coil(from, to));
    }
    painter.setPen(QPen(Qt::white, 1.5));
    painter.setBrush(color);
    painter.drawEllipse(from, 5, 5);
    painter.drawEllipse(to, 4, 4);
}

} // namespace knead
