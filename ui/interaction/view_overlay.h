#pragma once

#include <QRect>
#include <QWidget>

class QPainter;

namespace knead {

class ViewportWidget;

/// Something drawn over a view, sharp at any scale and never behind anything.
class OverlayDrawing {
public:
    virtual ~OverlayDrawing() = default;
    virtual QRect overlayArea() const = 0; ///< in the view's coordinates; empty: there is nothing to see
    virtual void drawOverlay(QPainter& painter) const = 0; ///< in the view's coordinates
};

/// Shows such a drawing for as long as the view lives, anew with every picture of the view. It is no larger than what is drawn,
/// and lets the mouse through.
class ViewOverlay final : public QWidget {
    Q_OBJECT
public:
    /// @param drawing outlives the overlay
    ViewOverlay(ViewportWidget& view, const OverlayDrawing& drawing, const char* name);

    void refresh();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ViewportWidget& m_view;
    const OverlayDrawing& m_drawing;
};

/// A sentence or number in a small frame beside the cursor.
/// @return where it lies, within `inside`
QRect cursorNoteArea(const QString& text, const QPointF& cursor, const QRect& inside, const QFont& font);
void drawCursorNote(QPainter& painter, const QString& text, const QRect& area, const QPalette& palette);

} // namespace knead
