#pragma once

#include <QPointF>
#include <QWidget>

namespace knead {

/// The line between before and after, which is dragged sideways over the view. The arrow keys move it too.
class DividerHandle final : public QWidget {
    Q_OBJECT
public:
    explicit DividerHandle(QWidget* parent);

    /// @param share of the width of the parent, 0 .. 1
    void placeAt(double share);

signals:
    void dragged(double share);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void moveTo(double share);

    double m_share = 0.5;
    double m_grabbed = 0; ///< of the mouse from the line [pixels]
};

/// The knob on a section plane: dragged along the arrow it shows, it moves the plane. The arrow keys move it too.
class SectionKnob final : public QWidget {
    Q_OBJECT
public:
    explicit SectionKnob(QWidget* parent);

    /// @param center in the parent
    /// @param direction in the parent, of the way in which the plane moves
    void placeAt(const QPointF& center, const QPointF& direction);

signals:
    void grabbed(const QPointF& at); ///< in the parent
    void dragged(const QPointF& to); ///< in the parent
    void stepped(int steps);         ///< by keys

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QPointF m_direction{0, -1};
};

} // namespace knead
