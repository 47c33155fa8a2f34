#pragma once

#include <QPolygonF>

class QPainter;

namespace knead {

/// Of the points of a line [pixels], by ascending x, those that can be told apart: of each column the lowest and the highest.
QPolygonF thinned(const QPolygonF& line);

/// Strokes a line with the pen of the painter, in pieces, since Qt takes a time that grows with the square of a line's points.
/// Dashes go on from piece to piece. A single point is a dot.
void strokeInPieces(QPainter& painter, const QPolygonF& line);

} // namespace knead
