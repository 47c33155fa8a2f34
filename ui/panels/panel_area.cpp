#include "ui/panels/panel_area.h"

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>

namespace knead {

namespace {

class PanelArea final : public QScrollArea {
public:
    QSize minimumSizeHint() const override
    {
        const int bar = verticalScrollBar()->sizeHint().width();
        return {widget()->minimumSizeHint().width() + bar, QScrollArea::minimumSizeHint().height()};
    }

protected:
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::LayoutRequest)
            updateGeometry();
        return QScrollArea::event(event);
    }
};

} // namespace

QScrollArea* scrolled(QWidget* panel)
{
    auto* area = new PanelArea;
    area->setWidget(panel);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus); // it would be a stop of Tab at which nothing is seen
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return area;
}

} // namespace knead
