#pragma once

#include "ui/viewport/camera.h"

#include <QPointF>
#include <QString>

#include <optional>
#include <span>
#include <vector>

class QNativeGestureEvent;
class QWheelEvent;

namespace knead {

/// How a drag moves the camera.
enum class NavigationMotion { orbit, pan, zoom };

/// Buttons that are held, with Shift and Ctrl just so; Alt and Meta are the desktop's and do not count.
struct NavigationGesture {
    Qt::MouseButtons buttons;
    Qt::KeyboardModifiers modifiers;
    NavigationMotion motion = NavigationMotion::orbit;
};

/// How the mouse moves the camera, as people know it from a program. The left button alone never does: it is for the material.
/// A mouse wheel zooms to the cursor, and so does a pinch, in all of them.
struct NavigationPreset {
    const char* name;                        ///< in the settings
    const char* title;                       ///< for people: that of a program, or to be translated as of "Navigation"
    std::vector<NavigationGesture> gestures; ///< more buttons before fewer: the first that fits is meant
    bool scrollPans = false;                 ///< two fingers on a touchpad pan; with Ctrl they zoom

    /// @param held more may be held than a gesture has: the left button works the material meanwhile
    std::optional<NavigationMotion> motion(Qt::MouseButtons held, Qt::KeyboardModifiers modifiers) const;
    /// Whether there is a gesture with these buttons, with whatever keys.
    bool uses(Qt::MouseButtons held) const;
    /// Whether the left button is one of those of the gesture.
    bool usesLeft(Qt::MouseButtons held, Qt::KeyboardModifiers modifiers) const;
    /// What to hold for a motion, as a hint has it: "Shift+middle". @pre there is a drag for it
    QString nameOf(NavigationMotion wanted) const;

private:
    const NavigationGesture* gesture(Qt::MouseButtons held, Qt::KeyboardModifiers modifiers) const;
};

/// The first is what comes where nothing was chosen.
std::span<const NavigationPreset> navigationPresets();
/// @param name in the settings; of none: the first
const NavigationPreset& navigationPreset(const QString& name);

/// By a drag. @param step of the mouse [pixels] @param start where the drag began: zooming keeps what lies there
Camera cameraAfterDrag(Camera camera, NavigationMotion motion, const QPointF& step, const Pixel& start,
                       const WindowSize& window);
/// By a wheel, or by two fingers on a touchpad.
Camera cameraAfterScroll(Camera camera, const NavigationPreset& preset, const QWheelEvent& event,
                         const WindowSize& window);
/// By a pinch. @param at where, in the view
Camera cameraAfterPinch(Camera camera, const QNativeGestureEvent& event, const QPointF& at, const WindowSize& window);

} // namespace knead
