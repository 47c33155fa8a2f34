#pragma once

#include "ui/viewport/color_scale.h"

#include <QWidget>

class QPainter;

namespace knead {

/// The bar beside the view that says which color stands for which number.
class ColorLegend final : public QWidget {
    Q_OBJECT
public:
    explicit ColorLegend(QWidget* parent);

    /// @param isPast whether the moment is one that is looked back at: then a quantity may not be known
    void show(const ColorScale& scale, bool isPast);
    void showCurvature(); ///< in words, see curvatureText()

    /// What a person reads, for tests.
    const ScaleText& text() const { return m_text; }
    QString remark() const { return m_remark; } ///< why there are no colors; empty when there are
    QSize sizeHint() const override;            ///< lower in a low view, so that the view cube stays free

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void say();

    ColorScale m_scale;
    bool m_isCurvature = false;
    ScaleText m_text;
    QString m_remark;
};

/// Draws it anywhere. The font of the painter decides the size; a lower place has a lower bar.
struct LegendColors {
    QColor ground;
    QColor text;
    QColor line;
};
QSize legendSize(const QFontMetrics& metrics, const ScaleText& text, const QString& remark);
void paintLegend(QPainter& painter, const QRect& place, const ColorScale& scale, const ScaleText& text,
                 const QString& remark, const LegendColors& colors);

} // namespace knead
