#pragma once

#include "ui/panels/plot_axis.h"
#include "ui/units.h"

#include <QColor>
#include <QPointF>
#include <QString>
#include <QWidget>

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

class QPainter;

namespace knead {

/// A line in a plot.
struct PlotLine {
    QString name;
    QColor color;
    std::vector<QPointF> points; ///< SI, by ascending x; a y that is not a number interrupts the line
    std::uint64_t id = 0;        ///< by which it stays hidden when it is shown anew
    Qt::PenStyle style = Qt::SolidLine;
};

/// Along the x axis, SI.
struct PlotRange {
    double begin = 0;
    double end = 0;
};

/// Draws lines over time with axes, units and a legend, in the colors of the theme. Under the mouse it says the values there; a
/// click on a name hides its line.
class PlotView final : public QWidget {
    Q_OBJECT
public:
    explicit PlotView(QWidget* parent = nullptr);

    /// @param quantity of the y axis
    /// @param title of the y axis, without unit
    /// @param least that is shown, whatever the lines are
    void show(std::vector<PlotLine> lines, Quantity quantity, const QString& title,
              const std::optional<PlotRange>& least = {});
    /// What is said instead while there is nothing to draw.
    void setHint(const QString& hint);
    const QString& hint() const { return m_hint; }
    const std::vector<PlotLine>& lines() const { return m_lines; }
    bool isHidden(const PlotLine& line) const { return m_hidden.contains(line.id); }
    /// Where a value is drawn, and a name in the legend; for tests.
    QPointF placeOf(const QPointF& value) const;
    QRectF legendArea(std::size_t line) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void fitAxes();
    QRectF area() const;
    QFont titleFont() const;
    void paintGrid(QPainter& painter) const;
    void paintLines(QPainter& painter) const;
    void paintLegend(QPainter& painter) const;
    void paintCursor(QPainter& painter) const;
    QString spoken() const;

    std::vector<PlotLine> m_lines;
    Quantity m_quantity = Quantity::Number;
    QString m_title;
    QString m_hint;
    std::optional<PlotRange> m_least;
    PlotAxis m_x;
    PlotAxis m_y;
    std::set<std::uint64_t> m_hidden; ///< ids of lines
    std::optional<double> m_cursor;   ///< x of the mouse [pixels]
};

} // namespace knead
