#include "ui/measuring/fold_marks.h"

#include "ui/document/fold_watch.h"
#include "ui/viewport/viewport_widget.h"

#include <QLineF>
#include <QPainter>

#include <algorithm>

namespace knead {

namespace {

constexpr double ringRadius = 7;  // of a ring [pixels]
constexpr double ringsApart = 18; // rings are, at least [pixels]
constexpr double ringWidth = 2;   // [pixels]
constexpr QColor ringColor(255, 214, 0);
constexpr QColor ringEdgeColor(0, 0, 0, 170);

} // namespace

FoldMarks::FoldMarks(const FoldWatch& folds, ViewportWidget& view)
    : QObject(&view)
    , m_folds(folds)
    , m_view(view)
    , m_overlay(new ViewOverlay(view, *this, "foldMarks"))
{
    connect(&folds, &FoldWatch::changed, m_overlay, &ViewOverlay::refresh);
}

std::vector<QPointF> FoldMarks::places() const
{
    std::vector<QPointF> rings;
    if (m_view.isLookingBack() || !m_view.options().warnings)
        return rings;
    for (const Fold& fold : m_folds.folds())
        for (const Vec3& place : m_folds.placesOf(fold)) {
            const std::optional<QPointF> seen = m_view.widgetPosition(place);
            const auto isNear = [&](const QPointF& ring) { return QLineF(ring, *seen).length() < ringsApart; };
            if (seen && std::ranges::none_of(rings, isNear))
                rings.push_back(*seen);
        }
    return rings;
}

QRect FoldMarks::overlayArea() const
{
    QRectF area;
    const QPointF reach(ringRadius + ringWidth, ringRadius + ringWidth);
    for (const QPointF& ring : places())
        area |= QRectF(ring - reach, ring + reach);
    return area.toAlignedRect();
}

void FoldMarks::drawOverlay(QPainter& painter) const
{
    painter.setBrush(Qt::NoBrush);
    for (const QPointF& ring : places()) {
        painter.setPen(QPen(ringEdgeColor, ringWidth + 2));
        painter.drawEllipse(ring, ringRadius, ringRadius);
        painter.setPen(QPen(ringColor, ringWidth));
        painter.drawEllipse(ring, ringRadius, ringRadius);
    }
}

} // namespace knead
