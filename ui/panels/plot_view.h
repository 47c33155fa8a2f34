#pragma once

#include "ui/units.h"

#include <QColor>
#include <QPointF>
#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QPainter;

namespace knead {

/// A line in a plot.
struct PlotLine {
    QString name;
    QColor color;
    std::vector<QPointF> points; ///< SI, by ascending x; a y that is not a number interrupts the line
};

/// Draws lines over time with axes, units and a legend, in the colors of the theme. Under the mouse it says the values there.
class PlotView final : public QWidget {
    Q_OBJECT
public:
    explicit PlotView(QWidget* parent = nullptr);

    /// @param quantity of the y axis
    /// @param title of the y axis, without unit
    void show(std::vector<PlotLine> lines, Quantity quantity, const QString& title);
    /// What is said instead while there is nothing to draw.
    void setHint(const QString& hint);
    const QString& hint() const { return m_hint; }
    const std::vector<PlotLine>& lines() const { return m_lines; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    struct Axis {
        double begin = 0;
        double end = 1;
        double step = 1; ///< between labels
    };

    Axis fitted(double lowest, double highest, double labels) const;
    void fitAxes();
    QRectF area() const;
    QPointF pixelOf(const QPointF& value) const;
    void paintGrid(QPainter& painter) const;
    void paintLines(QPainter& painter) const;
    void paintLegend(QPainter& painter) const;
    void paintCursor(QPainter& painter) const;

    std::vector<PlotLine> m_lines;
    Quantity m_quantity = Quantity::Number;
    QString m_title;
    QString m_hint;
    Axis m_x;
    Axis m_y;
    std::optional<double> m_cursor; ///< x of the mouse [pixels]
};

/// A round number of 1, 2 or 5 times a power of ten, not below `least`. @pre least > 0
double roundStep(double least);

} // namespace knead
