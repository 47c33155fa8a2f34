#pragma once

#include "ui/selection/selection_model.h"
#include "ui/viewport/region_view.h"

#include <QObject>

#include <optional>

namespace knead {

/// How the left button selects more than one thing at a time.
enum class RegionShape { Rectangle, Lasso, Brush };

/// The left mouse button where it selects: a click takes what is under the cursor, a drag what lies in a box, a lasso or under a
/// brush. Ctrl adds (a click also takes away), Shift takes away. A box that is drawn to the right takes what lies in it as a
/// whole, one to the left also what it touches.
class RegionTool final : public QObject {
    Q_OBJECT
public:
    RegionTool(Document& document, ScenePicker& picker, QObject* parent = nullptr);

    RegionView& fields() { return m_fields; }
    RegionShape shape() const { return m_shape; }
    void setShape(RegionShape shape);
    double brushRadius() const { return m_brushRadius; } ///< [pixels]
    void setBrushRadius(double radius);

    void press(const Pixel& pixel, Qt::KeyboardModifiers modifiers);
    void drag(const Pixel& pixel);
    void release();
    /// Gives up what is being drawn. @return whether anything was
    bool cancel();
    bool isPressed() const { return m_press.has_value(); }
    bool isDrawing() const { return m_press && m_press->isDrawing; }

    void hover(const Pixel& pixel);
    void leave();
    const Region& hovered() const { return m_hovered; }

    /// What is being drawn on the screen; empty when nothing is.
    const ScreenShape& drawn() const { return m_drawn; }
    /// Whether the box takes what it touches.
    bool isTouching() const;
    /// Where the brush is, while it is the shape to select with.
    std::optional<Pixel> brush() const;

signals:
    void hoverChanged();
    void drawnChanged();

private:
    struct Press {
        Pixel start;
        Pixel last;
        Qt::KeyboardModifiers modifiers;
        bool isDrawing = false;
        bool canDraw = true;
        Region before; ///< selected when the button went down
    };

    void setHovered(Region region);
    void giveUp();
    void paint(const Pixel& from, const Pixel& to);
    void select(const Region& region);
    RegionView::Query query() const;

    Document& m_document;
    RegionView m_fields;
    RegionShape m_shape = RegionShape::Rectangle;
    double m_brushRadius = 24; // [pixels]
    std::optional<Press> m_press;
    std::optional<Pixel> m_cursor;
    ScreenShape m_drawn;
    Region m_hovered;
};

} // namespace knead
