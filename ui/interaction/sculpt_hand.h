#pragma once

#include "core/message/message.h"
#include "core/session/sculpting.h"
#include "ui/document/document.h"
#include "ui/interaction/hand_settings.h"
#include "ui/interaction/view_hand.h"
#include "ui/interaction/view_overlay.h"
#include "ui/viewport/scene_picker.h"

#include <QElapsedTimer>
#include <QPointF>

#include <optional>
#include <string>
#include <vector>

namespace knead {

/// Works the material under the cursor with a brush as long as the mouse button is held: each stroke is a row of commands, see
/// SculptStroke, and one entry of the history. Time runs during it. A ring shows where the brush would take hold, and those across the
/// planes of symmetry; during a stroke it is around the finger, with a spring to the cursor where that is ahead.
/// Window thread only.
class SculptHand final : public ViewHand, private OverlayDrawing {
    Q_OBJECT
public:
    SculptHand(Document& document, ViewportWidget& view, HandSettings& settings);

    /// @param brush none: the hand does nothing
    void setBrush(std::optional<SculptBrush> brush);
    std::optional<SculptBrush> brush() const { return m_brush; }
    bool isStroking() const { return m_stroke && !m_stroke->isReleased(); }
    double force() const;  ///< of the hand, now [N]
    double radius() const; ///< of the brush, as chosen or as it suits the part [m]

    void changeRadius(double factor);
    void changeStrength(double factor); ///< during a stroke: of its force, too

signals:
    void refused(const QString& sentence); ///< why a place cannot be worked

protected:
    bool mousePressed(QMouseEvent& event) override;
    bool mouseMoved(QMouseEvent& event) override;
    bool mouseReleased(QMouseEvent& event) override;
    bool wheelTurned(QWheelEvent& event) override;
    bool wantsKey(const QKeyEvent& event) const override;
    bool keyPressed(QKeyEvent& event) override;
    void mouseLeft() override;

private:
    /// The surface under the cursor where no button is pressed.
    struct Hover {
        BodyId body = 0;
        SurfaceSpot spot;
    };

    void documentChanged(Document::Change what);
    QString whyNot(BodyId body) const;
    SculptChoice choice() const;
    Vec3 middle() const;
    SurfaceSpot spotAt(const PickHit& hit, const Frame& frame) const;
    void begin(const PickHit& hit);
    void follow();
    void end();
    void finish();
    void letGo();
    void post(const std::vector<Command>& commands, const Message& name = {});
    void hover();

    QRect overlayArea() const override;
    void drawOverlay(QPainter& painter) const override;
    std::vector<QPolygonF> rings() const;
    std::optional<QPointF> springBegin() const;
    QString note() const;

    HandSettings& m_settings;
    ViewOverlay* m_overlay;
    std::optional<SculptBrush> m_brush;
    std::optional<SculptStroke> m_stroke;
    ScenePicker m_still;         ///< the surface as it was when the stroke began
    FramePointer m_startFrame;   ///< the same
    BodyId m_body = 0;           ///< that is worked
    Vec3 m_start = Vec3::Zero(); ///< the place that was taken [m]
    std::uint64_t m_request = 0; ///< by which the simulation has what began the stroke
    bool m_makesTimeRun = false; ///< it stood still before
    std::optional<Hover> m_hover;
    QPointF m_cursor;
    QElapsedTimer m_changed; ///< radius or strength, which are told for a while
};

/// What an entry of the history says of a stroke.
Message strokeName(SculptBrush brush, const std::string& body);

} // namespace knead
