#include "ui/viewport/graphics_check.h"

#include "ui/viewport/viewport_bridge.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

namespace knead {

namespace {

constexpr std::pair leastVersion(3, 2); // of OpenGL, for VTK

struct GraphicsWords {
    Q_DECLARE_TR_FUNCTIONS(Graphics)
};

} // namespace

QString graphicsProblem()
{
    QOffscreenSurface surface;
    surface.setFormat(ViewportBridge::surfaceFormat());
    surface.create();
    QOpenGLContext context;
    context.setFormat(ViewportBridge::surfaceFormat());
    const bool isThere = surface.isValid() && context.create() && context.makeCurrent(&surface);
    if (isThere && context.format().version() >= leastVersion)
        return {};
    const QString what =
        isThere ? QStringLiteral("%1.%2").arg(context.format().majorVersion()).arg(context.format().minorVersion())
                : GraphicsWords::tr("none");
    return GraphicsWords::tr(
               "The window needs OpenGL 3.2 or later to draw, and here is %1. Install or update the driver of "
               "the graphics card, or Mesa (libgl1-mesa-dri), which draws without such a card. The commands "
               "that knead --help lists need no window.")
        .arg(what);
}

} // namespace knead
