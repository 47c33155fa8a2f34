#pragma once

#include "ui/document/force_record.h"

#include <QWidget>

#include <set>
#include <utility>

namespace knead {

/// Forces over time as lines: one for each tool, dashed for fixtures. A click on a name hides its line; beside the cursor stand the
/// numbers of its time. Painted by Qt: sharp at any scale and in the colors of the theme.
class ForcePlot final : public QWidget {
    Q_OBJECT
public:
    explicit ForcePlot(QWidget* parent = nullptr);

    void show(ForceRecord record);
    void show(ForceComponent component);
    const ForceRecord& record() const { return m_record; }
    /// Where a force at a time is drawn; for tests.
    QPointF placeOf(double time, double force) const;
    /// The name in the legend; empty for one that is not there.
    QRect legendArea(std::size_t curve) const;
    bool isHidden(std::size_t curve) const;

    QSize sizeHint() const override { return {480, 200}; }
    QSize minimumSizeHint() const override { return {200, 90}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    /// Numbers at an axis: first and last are its ends.
    struct Scale {
        double low = 0, high = 1, step = 1;
    };

    void fitScales();
    QRectF plotArea() const;
    void drawAxes(QPainter& painter) const;
    void drawCurve(QPainter& painter, std::size_t curve) const;
    void drawLegend(QPainter& painter) const;
    void drawReadings(QPainter& painter) const;
    QColor colorOf(std::size_t curve) const;
    std::size_t sampleNear(double x) const;
    static Scale niceScale(double low, double high, int ticks);

    ForceRecord m_record;
    ForceComponent m_component = ForceComponent::magnitude;
    std::set<std::pair<bool, std::uint32_t>> m_hidden; ///< curves by what they are of
    Scale m_forces;
    Scale m_times;
    double m_unit = 1; ///< of the numbers at the axis [N]
    QString m_unitName = QStringLiteral("N");
    double m_cursor = -1; ///< x of the mouse; < 0: elsewhere
};

} // namespace knead
