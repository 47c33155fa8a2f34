#pragma once

#include "ui/document/document.h"
#include "ui/interaction/hand_settings.h"
#include "ui/interaction/key_bindings.h"
#include "ui/interaction/view_hand.h"
#include "ui/interaction/view_overlay.h"

#include <array>
#include <set>

namespace knead {

/// Drives up to three tools with the keyboard, each with keys of its own, as the paper does: so many steps per second while a
/// key is held, one step for a press while time stands still. What each key does is shown over the view; those that are pressed
/// are lit. Never faster than a tool's speed limit. The mouse is free for another tool meanwhile.
class KeyHand final : public ViewHand, private OverlayDrawing {
    Q_OBJECT
public:
    KeyHand(Document& document, ViewportWidget& view, const HandSettings& settings);

    void setOn(bool on);
    bool isOn() const { return m_isOn; }
    const std::set<int>& pressed() const { return m_pressed; }
    /// The tool that the keys of a place drive; null: there are not so many.
    const ToolState* tool(std::size_t place) const;

protected:
    bool wantsKey(const QKeyEvent& event) const override;
    bool keyPressed(QKeyEvent& event) override;
    bool keyReleased(QKeyEvent& event) override;
    void keyboardLost() override;

private:
    void letGo();
    void drive(std::size_t place);
    void step(const BoundKey& key);
    double slowness() const;

    QRect overlayArea() const override;
    void drawOverlay(QPainter& painter) const override;

    const HandSettings& m_settings;
    ViewOverlay* m_overlay;
    bool m_isOn = false;
    bool m_isSlow = false; ///< Shift is held
    std::set<int> m_pressed;
    std::array<std::optional<ToolId>, drivenTools> m_driven; ///< told to move
};

} // namespace knead
