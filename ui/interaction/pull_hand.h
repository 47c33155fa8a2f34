#pragma once

#include "ui/document/document.h"
#include "ui/interaction/hand_settings.h"
#include "core/session/pull_spring.h"
#include "ui/interaction/view_hand.h"
#include "ui/interaction/view_overlay.h"
#include "ui/viewport/scene_picker.h"

#include <QPointF>

#include <optional>
#include <string>
#include <vector>

namespace knead {

/// Pulls the material at a place with a spring, as long as the mouse button is held. The patch around the place becomes a grip
/// (a fixture that moves) that goes where spring and material are in balance; what happens is a row of commands, to be recorded,
/// repeated and exported as any other, and one entry of the history. Time runs while it is pulled.
class PullHand final : public ViewHand, private OverlayDrawing {
    Q_OBJECT
public:
    PullHand(Document& document, ViewportWidget& view, const HandSettings& settings);

    void setOn(bool on);
    bool isOn() const { return m_isOn; }
    bool isPulling() const { return m_pull.has_value(); }
    double force() const; ///< of the hand, now [N]

signals:
    void refused(const QString& sentence); ///< why a place cannot be pulled

protected:
    bool mousePressed(QMouseEvent& event) override;
    bool mouseMoved(QMouseEvent& event) override;
    bool mouseReleased(QMouseEvent& event) override;
    bool wantsKey(const QKeyEvent& event) const override;
    bool keyPressed(QKeyEvent& event) override;

private:
    struct Pull {
        BodyId body = 0;
        std::string grip;                 ///< its name; its number is what the simulation says
        std::vector<ObjectIndex> objects; ///< of the patch
        Vec3 patch = Vec3::Zero();        ///< their mean place when it began [m]
        Vec3 place = Vec3::Zero();        ///< that was taken, then [m]
        Vec3 hand = Vec3::Zero();         ///< where the mouse wants it [m]
        PullSpring spring;
        Vec3 material = Vec3::Zero(); ///< its force on the patch, smoothed [N]
        Vec3 velocity = Vec3::Zero(); ///< as told [m/s]
        std::optional<FixtureId> id;  ///< once the simulation has it
        bool makesTimeRun = false;    ///< it stood still before
    };

    void documentChanged(Document::Change what);
    void begin(const PickHit& hit);
    void follow();
    void end();
    void letGo();
    std::vector<ObjectIndex> patchAround(BodyId body, const Vec3& place, double radius) const;
    std::optional<std::size_t> gripNow() const;
    std::string freeName();
    Vec3 patchNow() const;
    Vec3 placeNow() const;

    QRect overlayArea() const override;
    void drawOverlay(QPainter& painter) const override;
    QString note() const;

    const HandSettings& m_settings;
    ViewOverlay* m_overlay;
    bool m_isOn = false;
    std::optional<Pull> m_pull;
    QPointF m_cursor;
    int m_count = 0; ///< of pulls so far
};

} // namespace knead
