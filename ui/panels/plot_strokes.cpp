#include "ui/panels/plot_strokes.h"

#include <QLineF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr int pieceLength = 8; // points that Qt strokes at once

} // namespace

QPolygonF thinned(const QPolygonF& line)
{
    QPolygonF few;
    for (qsizetype i = 0; i < line.size();) {
        QPointF first = line[i];
        QPointF second = line[i];
        const double column = std::floor(first.x());
        for (; i < line.size() && std::floor(line[i].x()) == column; ++i) {
            first = line[i].y() < first.y() ? line[i] : first;
            second = line[i].y() > second.y() ? line[i] : second;
        }
        if (!few.isEmpty() && std::abs(second.y() - few.back().y()) < std::abs(first.y() - few.back().y()))
            std::swap(first, second);
        few << first;
        if (second != first)
            few << second;
    }
    return few;
}

void strokeInPieces(QPainter& painter, const QPolygonF& line)
{
    QPen pen = painter.pen();
    const QPen whole = pen;
    for (qsizetype begin = 0; begin + 1 < line.size(); begin += pieceLength) {
        const qsizetype end = std::min(begin + pieceLength, line.size() - 1);
        painter.setPen(pen);
        painter.drawPolyline(line.constData() + begin, static_cast<int>(end - begin + 1));
        for (qsizetype i = begin; i < end; ++i)
            pen.setDashOffset(pen.dashOffset() + QLineF(line[i], line[i + 1]).length() / pen.widthF());
    }
    painter.setPen(whole);
    if (line.size() == 1)
        painter.drawPoint(line.front());
}

} // namespace knead
