#pragma once

#include "ui/viewport/scene_picker.h"

#include <QObject>

#include <optional>
#include <set>

namespace knead {

/// What the left mouse button and the arrow keys do to the material: select, fix faces, drag blocks, drive blocks.
class Manipulation final : public QObject {
    Q_OBJECT
public:
    explicit Manipulation(Document& document, QObject* parent = nullptr);

    /// While on, faces are picked to be fixed or freed.
    void setFixing(bool on);
    bool isFixing() const { return m_isFixing; }
    /// Whether a face was just held or freed and the mouse is still on it: what became of it is to be seen.
    bool isJustToggled() const { return m_isJustToggled; }

    ScenePicker& picker() { return m_picker; }

    /// What is highlighted under the cursor.
    const PickHit& hovered() const { return m_hovered; }
    Qt::CursorShape cursor() const;

    /// What lies under the mouse, tools included.
    PickHit pick(const Ray& ray) { return m_picker.pick(ray); }
    void hover(const Ray& ray);
    void leave();
    void press(const Ray& ray);
    void drag(const Ray& ray, const Camera& camera);
    void release();
    /// Puts the dragged block back. @return whether one was dragged
    bool cancel();

    /// @param isSlow Shift is held
    /// @return false for keys that move nothing
    bool keyPressed(int key, bool isSlow, const Camera& camera);
    bool keyReleased(int key);
    /// Stops the driven block, as when the window loses the keyboard.
    void releaseKeys();

signals:
    void hoverChanged();

private:
    struct Drag {
        ToolId tool = 0;
        Vec3 grabbed = Vec3::Zero(); ///< place under the cursor when the block was at its start [m]
        Pose home;                   ///< of the block when the button went down
        Pose start;
        Pose target;
        std::optional<Camera> camera; ///< with which it was moved last
    };

    void setHovered(const PickHit& hit);
    void drive();
    void nudge(int key, bool isSlow);
    const ToolState* selectedTool() const;

    Document& m_document;
    ScenePicker m_picker;
    PickHit m_hovered;
    bool m_isFixing = false;
    bool m_isJustToggled = false;
    std::optional<Drag> m_drag;
    std::set<int> m_keys; ///< held
    bool m_isSlow = false;
    std::optional<ToolId> m_driven; ///< told to move by keys
    Camera m_camera;                ///< when the last key went down
};

/// The world axis a key moves along as seen by a camera: right, away from the eye and up for Right, Up and PgUp; zero
/// for other keys.
Vec3 keyDirection(int key, const Camera& camera);

} // namespace knead
