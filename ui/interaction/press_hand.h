#pragma once

#include "core/session/press_pose.h"
#include "ui/document/document.h"
#include "ui/interaction/view_hand.h"
#include "ui/interaction/view_overlay.h"
#include "ui/viewport/scene_picker.h"

#include <QPointF>

#include <cstdint>
#include <optional>
#include <string>

namespace knead {

/// Presses a tool onto a place of the material as long as the mouse button is held: it comes along the normal of the surface, goes in
/// until its force limit holds it up, and is lifted when the button is let go. The tool is the one that is selected, else a thumb, a
/// ball whose limit goes by the material. What happens is a row of commands and one entry of the history. Time runs while it is
/// pressed.
class PressHand final : public ViewHand, private OverlayDrawing {
    Q_OBJECT
public:
    PressHand(Document& document, ViewportWidget& view);

    void setOn(bool on);
    bool isOn() const { return m_isOn; }
    bool isPressing() const { return m_press && !m_press->isLeaving; }
    double force() const; ///< of the material on the tool, now [N]

signals:
    void refused(const QString& sentence); ///< why a place cannot be pressed

protected:
    bool mousePressed(QMouseEvent& event) override;
    bool mouseMoved(QMouseEvent& event) override;
    bool mouseReleased(QMouseEvent& event) override;
    bool wantsKey(const QKeyEvent& event) const override;
    bool keyPressed(QKeyEvent& event) override;

private:
    struct Press {
        std::string tool;          ///< its name; its number is what the simulation says
        std::uint64_t request = 0; ///< by which the simulation has it, if it ever does
        bool isNew = false;        ///< it is not told yet where to go
        PressPoses poses;
        double limit = 0;          ///< [N]
        bool makesTimeRun = false; ///< it stood still before
        bool isLeaving = false;    ///< it is lifted
        bool isTold = false;       ///< to leave
        double leaveBy = 0;        ///< simulated; it is left where it is then [s]
    };

    void documentChanged(Document::Change what);
    QString whyNotPressed(BodyId body) const;
    void begin(const PickHit& hit, bool makesTimeRun);
    void follow();
    void lift();
    void goAway();
    void finish();
    void letGo();
    const ToolState* toolToTake() const;
    const ToolState* toolNow() const;

    QRect overlayArea() const override;
    void drawOverlay(QPainter& painter) const override;
    QString note() const;

    ViewOverlay* m_overlay;
    bool m_isOn = false;
    std::optional<Press> m_press;
    std::string m_thumb; ///< that was added last
    QPointF m_cursor;
};

} // namespace knead
