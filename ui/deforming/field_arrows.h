#pragma once

#include "core/deformation/displacement_field.h"
#include "ui/interaction/view_overlay.h"

#include <memory>
#include <vector>

namespace knead {

/// Some nodes of a field, spread evenly: at most one in each cube of a grid over their box, about so many along its longest side.
DisplacementField thinned(const DisplacementField& field, int along);

/// Draws where a field takes some of its nodes, as arrows over a view.
class FieldArrows final : private OverlayDrawing {
public:
    explicit FieldArrows(ViewportWidget& view);

    /// @param scale of the ways
    void show(const std::shared_ptr<const DisplacementField>& field, double scale);
    void hide();

private:
    QRect overlayArea() const override;
    void drawOverlay(QPainter& painter) const override;

    ViewportWidget& m_view;
    ViewOverlay* m_overlay;                           ///< of the view
    std::shared_ptr<const DisplacementField> m_field; ///< that was thinned
    DisplacementField m_arrows;
    double m_scale = 1;
};

} // namespace knead
