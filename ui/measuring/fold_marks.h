#pragma once

#include "ui/interaction/view_overlay.h"

#include <QObject>
#include <QPointF>

#include <vector>

namespace knead {

class FoldWatch;
class ViewportWidget;

/// Shows in a view where bodies are folded over themselves: a ring around each place, in front of everything.
class FoldMarks final : public QObject, private OverlayDrawing {
    Q_OBJECT
public:
    /// @param folds outlives the marks
    FoldMarks(const FoldWatch& folds, ViewportWidget& view);

    std::vector<QPointF> places() const; ///< of the rings, in the view's coordinates

private:
    QRect overlayArea() const override;
    void drawOverlay(QPainter& painter) const override;

    const FoldWatch& m_folds;
    ViewportWidget& m_view;
    ViewOverlay* m_overlay;
};

} // namespace knead
