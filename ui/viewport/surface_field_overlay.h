#pragma once

#include "ui/viewport/scene_view.h"

#include <QObject>
#include <QPointF>

#include <utility>

namespace knead {

class ColorLegend;
class DividerHandle;
class SectionKnob;
class ViewportWidget;

/// What lies over the view and belongs to what is seen: the legend of the colors, the divider between before and after, and the
/// knob of the section plane. Dragging them changes the options of the view.
class SurfaceFieldOverlay final : public QObject {
    Q_OBJECT
public:
    explicit SurfaceFieldOverlay(ViewportWidget& view);

    /// To where they belong now; before each drawing.
    /// @param box of the content at rest [m]
    void place(const std::optional<ColorScale>& scale, const Box& box);

    void setPast(bool isPast) { m_isPast = isPast; } ///< another moment than the present is shown

private:
    void placeKnob();
    double offsetAt(const QPointF& position) const;
    void moveSection(double offset);

    ViewportWidget& m_view;
    ColorLegend* m_legend;
    DividerHandle* m_divider;
    SectionKnob* m_knob;
    Vec3 m_knobPlace = Vec3::Zero(); ///< [m]
    Vec3 m_way = Vec3::Zero();       ///< where the line along which the knob is dragged is next to the origin [m]
    double m_grabbed = 0;            ///< of the mouse along that line from the plane [m]
    Box m_box;                       ///< of the content at rest [m]
    bool m_isPast = false;
};

/// Offsets of planes with a normal that meet a box: least and most [m].
std::pair<double, double> reachAlong(const Vec3& normal, const Box& box);

} // namespace knead
