#pragma once

#include <QPointF>
#include <QRect>

class QPainter;
class QPalette;

namespace knead {

/// A coil from the material to the hand: drawn out the further it reaches.
QRect springArea(const QPointF& from, const QPointF& to);
void drawSpring(QPainter& painter, const QPointF& from, const QPointF& to, const QPalette& palette);

} // namespace knead
