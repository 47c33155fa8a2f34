#include "ui/viewport/navigation.h"

#include "ui/viewport/pixel_of.h"

#include <QCoreApplication>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QWheelEvent>

#include <algorithm>
#include <array>

namespace knead {

namespace {

constexpr double wheelPerPixel = 6;     // of a drag that zooms: 20 pixels are a notch [eighths of a degree / pixel]
constexpr double pixelsPerTurned = 0.5; // where a touchpad tells turns only: a notch is 60 pixels
constexpr double smallestPinch = 0.1;   // scale of one event

/// Fingers on a touchpad begin and end a scroll and tell pixels, or are named as such; a wheel is neither.
bool isOfTouchpad(const QWheelEvent& event)
{
    const QPointingDevice* device = event.pointingDevice();
    return (event.phase() != Qt::NoScrollPhase && !event.pixelDelta().isNull()) ||
           (device != nullptr && device->type() == QInputDevice::DeviceType::TouchPad);
}

QString wordOfNavigation(const char* text)
{
    return QCoreApplication::translate("Navigation", text);
}

QString nameOfButtons(Qt::MouseButtons buttons)
{
    if (buttons == (Qt::MiddleButton | Qt::LeftButton))
        return wordOfNavigation(QT_TRANSLATE_NOOP("Navigation", "middle+left"));
    return buttons == Qt::RightButton ? wordOfNavigation(QT_TRANSLATE_NOOP("Navigation", "right"))
                                      : wordOfNavigation(QT_TRANSLATE_NOOP("Navigation", "middle"));
}

} // namespace

const NavigationGesture* NavigationPreset::gesture(Qt::MouseButtons held, Qt::KeyboardModifiers modifiers) const
{
    const Qt::KeyboardModifiers counting = modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
    const auto found = std::ranges::find_if(gestures, [&](const NavigationGesture& one) {
        return one.modifiers == counting && (held & one.buttons) == one.buttons;
    });
    return found == gestures.end() ? nullptr : &*found;
}

std::optional<NavigationMotion> NavigationPreset::motion(Qt::MouseButtons held, Qt::KeyboardModifiers modifiers) const
{
    const NavigationGesture* found = gesture(held, modifiers);
    return found != nullptr ? std::optional(found->motion) : std::nullopt;
}

bool NavigationPreset::uses(Qt::MouseButtons held) const
{
    return std::ranges::any_of(gestures,
                               [held](const NavigationGesture& one) { return (held & one.buttons) == one.buttons; });
}

bool NavigationPreset::usesLeft(Qt::MouseButtons held, Qt::KeyboardModifiers modifiers) const
{
    const NavigationGesture* found = gesture(held, modifiers);
    return found != nullptr && found->buttons.testFlag(Qt::LeftButton);
}

QString NavigationPreset::nameOf(NavigationMotion wanted) const
{
    const auto found = std::ranges::find(gestures, wanted, &NavigationGesture::motion);
    QString text = nameOfButtons(found->buttons);
    if (found->modifiers.testFlag(Qt::ShiftModifier))
        text.prepend(wordOfNavigation(QT_TRANSLATE_NOOP("Navigation", "Shift+")));
    if (found->modifiers.testFlag(Qt::ControlModifier))
        text.prepend(wordOfNavigation(QT_TRANSLATE_NOOP("Navigation", "Ctrl+")));
    text.front() = text.front().toUpper();
    return text;
}

std::span<const NavigationPreset> navigationPresets()
{
    using enum NavigationMotion;
    constexpr Qt::KeyboardModifiers none = Qt::NoModifier;
    constexpr Qt::KeyboardModifiers shift = Qt::ShiftModifier;
    constexpr Qt::KeyboardModifiers ctrl = Qt::ControlModifier;
    constexpr Qt::MouseButtons left = Qt::LeftButton;
    constexpr Qt::MouseButtons middle = Qt::MiddleButton;
    constexpr Qt::MouseButtons right = Qt::RightButton;
    static const std::array<NavigationPreset, 7> presets{{
        {"knead",
         "Knead",
         {{middle, none, orbit}, {middle, shift, pan}, {middle, ctrl, pan}, {middle, shift | ctrl, pan}}},
        {"blender", "Blender", {{middle, none, orbit}, {middle, shift, pan}, {middle, ctrl, zoom}}},
        {"freecad", // its style "CAD"
         "FreeCAD",
         {{middle | left, none, orbit},
          {middle | right, none, orbit},
          {right, shift, orbit},
          {middle, none, pan},
          {right, ctrl, pan},
          {right, shift | ctrl, zoom}}},
        {"fusion", "Fusion", {{middle, shift, orbit}, {middle, none, pan}}},
        {"onshape", "Onshape", {{right, none, orbit}, {middle, none, pan}, {right, ctrl, pan}}},
        {"solidworks", "SolidWorks", {{middle, none, orbit}, {middle, ctrl, pan}, {middle, shift, zoom}}},
        {"twoButtons",
         QT_TRANSLATE_NOOP("Navigation", "Two buttons / touchpad"),
         {{right, none, orbit}, {right, shift, pan}, {right, ctrl, zoom}},
         true},
    }};
    return presets;
}

const NavigationPreset& navigationPreset(const QString& name)
{
    const std::span<const NavigationPreset> presets = navigationPresets();
    const auto found =
        std::ranges::find_if(presets, [&](const NavigationPreset& one) { return name == QLatin1String(one.name); });
    return found == presets.end() ? presets.front() : *found;
}

Camera cameraAfterDrag(Camera camera, NavigationMotion motion, const QPointF& step, const Pixel& start,
                       const WindowSize& window)
{
    using enum NavigationMotion;
    switch (motion) {
    case orbit:
        camera.orbit(step.x(), step.y());
        break;
    case pan:
        camera.pan(step.x(), step.y(), window);
        break;
    case zoom: // upwards comes nearer
        camera.zoomByWheel(-wheelPerPixel * step.y(), start, window);
        break;
    }
    return camera;
}

Camera cameraAfterScroll(Camera camera, const NavigationPreset& preset, const QWheelEvent& event,
                         const WindowSize& window)
{
    if (preset.scrollPans && isOfTouchpad(event) && !(event.modifiers() & Qt::ControlModifier)) {
        const QPointF step =
            event.pixelDelta().isNull() ? pixelsPerTurned * QPointF(event.angleDelta()) : QPointF(event.pixelDelta());
        camera.pan(step.x(), step.y(), window);
    } else {
        camera.zoomByWheel(event.angleDelta().y(), pixelOf(event.position()), window);
    }
    return camera;
}

Camera cameraAfterPinch(Camera camera, const QNativeGestureEvent& event, const QPointF& at, const WindowSize& window)
{
    camera.zoom(1 / std::max(1 + event.value(), smallestPinch), pixelOf(at), window);
    return camera;
}

} // namespace knead
