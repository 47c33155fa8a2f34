#include "ui/viewport/region_overlay.h"

#include <QPainter>

namespace knead {

RegionOverlay::RegionOverlay(const RegionTool& tool, QWidget* parent)
    : QWidget(parent)
    , m_tool(tool)
{
    setObjectName("regionOverlay");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    hide();
    connect(&tool, &RegionTool::drawnChanged, this, [this] {
        setVisible(m_tool.isDrawing() || m_tool.brush());
        update();
    });
}

void RegionOverlay::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor fill = palette().color(QPalette::Highlight);
    QPen line(fill, 1.5);
    fill.setAlphaF(0.14F);
    painter.setBrush(fill);
    if (m_tool.isTouching() || m_tool.shape() == RegionShape::Lasso)
        line.setStyle(Qt::DashLine);
    painter.setPen(line);
    QPolygonF polygon;
    for (const Pixel& corner : m_tool.drawn())
        polygon << QPointF(corner.x, corner.y);
    if (polygon.size() > 1)
        painter.drawPolygon(polygon);
    if (const std::optional<Pixel> brush = m_tool.brush()) {
        line.setStyle(Qt::SolidLine);
        painter.setPen(line);
        painter.drawEllipse(QPointF(brush->x, brush->y), m_tool.brushRadius(), m_tool.brushRadius());
    }
}

} // namespace knead
