#pragma once

#include "ui/document/document.h"
#include "ui/interaction/hand_settings.h"
#include "ui/interaction/space_motion.h"
#include "ui/viewport/camera.h"

#include <QObject>

#include <memory>
#include <optional>

namespace knead {

class ViewportWidget;

/// The camera that a 3D mouse leads to: the scene goes and turns as the cap is pushed and turned, as if it were held in the hand.
/// @param rate of full deflection, 1: usual
Camera movedBy(const Camera& camera, const SpaceMotion& motion, double rate);

/// How a tool goes when the cap is pushed and turned: with its speed limit at full deflection, as seen by the camera.
DriveAt toolMotion(const ToolState& tool, const Camera& camera, const SpaceMotion& motion, double rate);

/// Drives the camera, or the selected tool, with a 3D mouse. Its first button fits the view, its second one changes between both.
class SpaceHand final : public QObject {
    Q_OBJECT
public:
    SpaceHand(Document& document, ViewportWidget& view, HandSettings& settings);
    ~SpaceHand() override;

    /// @param listen may be empty: there is no 3D mouse
    void listen(const ListenToSpaceMouse& listen);
    bool isConnected() const { return m_isConnected; }

signals:
    void connectionChanged(bool isConnected);

private:
    void take(const SpaceEvent& event);
    void move(const SpaceMotion& motion);
    void moveTool(const ToolState& tool, const SpaceMotion& motion);
    void press(int button);
    void stop();
    const ToolState* selectedTool() const;

    Document& m_document;
    ViewportWidget& m_view;
    HandSettings& m_settings;
    bool m_isConnected = false;
    std::optional<ToolId> m_driven; ///< told to move
    std::shared_ptr<void> m_listening;
};

} // namespace knead
