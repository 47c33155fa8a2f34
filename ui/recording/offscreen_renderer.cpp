#include "ui/recording/offscreen_renderer.h"

#include "ui/document/entry_names.h"
#include "ui/recording/sentence.h"
#include "ui/units.h"
#include "ui/viewport/color_legend.h"
#include "ui/viewport/view_cube.h"
#include "ui/viewport/viewport_bridge.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace knead {

namespace {

constexpr double textShare = 1.0 / 45; // height of text in heights of the picture
constexpr double shownForce = 1e-6;    // [N]
constexpr double dpi = 72;             // at which a line of one pixel is one pixel wide

[[noreturn]] void failForSize()
{
    failWith(QCoreApplication::translate("OffscreenRenderer",
                                         "The graphics card draws no pictures of this size. Choose a smaller one."));
}

/// As many per pixel as memory allows; a large picture is looked at from afar, where fewer do.
int samplesFor(const QSize& size)
{
    constexpr double room = 1 << 30; // [bytes]
    constexpr double sample = 8;     // color and depth [bytes]
    const double pixels = static_cast<double>(size.width()) * size.height();
    int samples = 8;
    while (samples > 2 && samples * sample * pixels > room)
        samples /= 2;
    return samples;
}

/// What is drawn alike on black and on white is opaque; what lets all of the difference through is not there.
QImage withoutGround(const QImage& onBlack, const QImage& onWhite)
{
    QImage result(onBlack.size(), QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < result.height(); ++y) {
        const uchar* black = onBlack.constScanLine(y);
        const uchar* white = onWhite.constScanLine(y);
        auto* out = reinterpret_cast<QRgb*>(result.scanLine(y));
        for (int x = 0; x < result.width(); ++x, black += 3, white += 3) {
            const int through = std::max({white[0] - black[0], white[1] - black[1], white[2] - black[2], 0});
            const int opacity = 255 - through;
            out[x] = qRgba(std::min<int>(black[0], opacity), std::min<int>(black[1], opacity),
                           std::min<int>(black[2], opacity), opacity);
        }
    }
    return result;
}

void drawText(QPainter& painter, const QPointF& topLeft, const QString& text)
{
    const int padding = painter.fontMetrics().height() / 3;
    QRectF box = painter.fontMetrics().boundingRect(text);
    box.moveTopLeft(topLeft + QPointF(padding, padding / 2.0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(255, 255, 255, 215));
    painter.drawRoundedRect(box.adjusted(-padding, -padding / 2.0, padding, padding / 2.0), padding, padding);
    painter.setPen(QColor(30, 34, 38));
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
}

} // namespace

/// The render window and Qt's context, in which it draws.
struct OffscreenRenderer::Room {
    Surface surface;
    QOpenGLContext context;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkNew<vtkCallbackCommand> observer;

    Room(const QSize& size, Surface drawnOn)
        : surface(std::move(drawnOn))
    {
        context.setFormat(ViewportBridge::surfaceFormat()); // the surface forgets that lines may be wide
        if (!context.create() || !context.makeCurrent(surface.get()))
            failWith(QCoreApplication::translate(
                "OffscreenRenderer", "The graphics card takes no more pictures. Close other programs and try again."));
        if (std::max(size.width(), size.height()) > largestSide())
            failForSize();
        observer->SetCallback(&Room::answer);
        observer->SetClientData(this);
        window->AddObserver(vtkCommand::WindowMakeCurrentEvent, observer);
        window->AddObserver(vtkCommand::WindowIsCurrentEvent, observer);
        window->SetFrameBlitModeToNoBlit();
        window->SetMultiSamples(samplesFor(size));
        window->SetSize(size.width(), size.height());
        window->SetReadyForRendering(true);
        window->SetOwnContext(0);
        window->OpenGLInitContext();
    }

    ~Room()
    {
        context.makeCurrent(surface.get());
        window->Finalize();
        window->SetReadyForRendering(false);
        window->RemoveAllObservers();
        context.doneCurrent();
    }

    int largestSide()
    {
        GLint side = 0;
        context.functions()->glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &side);
        return side;
    }

    /// Whether all went well since it was asked last.
    bool isWell() { return context.functions()->glGetError() == GL_NO_ERROR; }

    static void answer(vtkObject* /*caller*/, unsigned long event, void* self, void* data)
    {
        auto& room = *static_cast<Room*>(self);
        if (event == vtkCommand::WindowIsCurrentEvent)
            *static_cast<bool*>(data) = QOpenGLContext::currentContext() == &room.context;
        else if (event == vtkCommand::WindowMakeCurrentEvent)
            room.context.makeCurrent(room.surface.get());
    }
};

OffscreenRenderer::Surface OffscreenRenderer::makeSurface()
{
    if (!QOpenGLContext::supportsThreadedOpenGL())
        failWith(QCoreApplication::translate(
            "OffscreenRenderer",
            "The graphics driver draws for the window only, so that nothing can be recorded. Start Knead with "
            "LIBGL_ALWAYS_SOFTWARE=1 in its environment to record without the driver."));
    Surface surface(new QOffscreenSurface, std::mem_fn(&QObject::deleteLater));
    surface->setFormat(ViewportBridge::surfaceFormat());
    surface->create();
    return surface;
}

OffscreenRenderer::OffscreenRenderer(SceneLook look, const QSize& size, Surface surface)
    : m_look(std::move(look))
    , m_size(size)
    , m_sights(m_look.content.bodies)
    , m_room(std::make_unique<Room>(size, std::move(surface)))
    , m_scene(std::make_unique<SceneView>(m_room->window))
{
    m_scene->setStyle(m_look.style);
    m_scene->setModel(m_look.content);
    m_scene->setOptions(m_look.options);
    m_scene->setMarks(m_look.marks);
    m_scene->setAppearance(m_look.looks);
    m_scene->setMaterials(m_look.materials);
    vtkRendererCollection* renderers = m_room->window->GetRenderers();
    renderers->InitTraversal();
    while (vtkRenderer* renderer = renderers->GetNextItem())
        renderer->SetDraw(renderer->GetLayer() == 0); // without the cube
    m_room->context.doneCurrent();
}

OffscreenRenderer::~OffscreenRenderer()
{
    m_room->context.makeCurrent(m_room->surface.get());
    m_scene.reset();
}

QImage OffscreenRenderer::draw(const FramePointer& frame, std::optional<double> at)
{
    show(frame);
    QImage picture = shot();
    m_room->context.doneCurrent();
    drawLegend(picture);
    if (at)
        writeReadings(picture, *at);
    return picture;
}

/// From two pictures, since what the card keeps of opacity differs where things are drawn over each other.
QImage OffscreenRenderer::drawClear(const FramePointer& frame)
{
    show(frame);
    vtkRenderer* scene = m_room->window->GetRenderers()->GetFirstRenderer(); // that of layer 0
    const auto on = [&](double level) {
        scene->SetBackground(level, level, level);
        return shot();
    };
    scene->GradientBackgroundOff();
    const QImage onBlack = on(0);
    QImage picture = withoutGround(onBlack, on(1));
    scene->GradientBackgroundOn();
    scene->SetBackground(m_look.style.bottom.r, m_look.style.bottom.g, m_look.style.bottom.b);
    m_room->context.doneCurrent();
    drawLegend(picture);
    return picture;
}

void OffscreenRenderer::setScale(double scale)
{
    m_room->window->SetDPI(static_cast<int>(std::lround(dpi * scale)));
    m_scene->cube().setWindow({m_size.width() / scale, m_size.height() / scale});
}

void OffscreenRenderer::showCube(bool on)
{
    m_scene->cube().setDrawn(on);
}

/// The context stays current.
void OffscreenRenderer::show(const FramePointer& frame)
{
    const SurfaceFieldsRequest request = requestOf(m_look.options);
    m_room->context.makeCurrent(m_room->surface.get());
    m_scene->showFrame(frame);
    m_scene->setSurfaceFields(request.isEmpty() ? nullptr : m_sights.make(frame, request));
    m_scene->setCamera(m_look.camera);
}

QImage OffscreenRenderer::shot()
{
    m_room->isWell();
    m_room->window->Render();
    QImage picture = pixels();
    if (!m_room->isWell())
        failForSize();
    return picture;
}

QImage OffscreenRenderer::pixels() const
{
    constexpr int back = 0;
    constexpr int leftEye = 0;
    vtkNew<vtkUnsignedCharArray> pixels;
    m_room->window->GetPixelData(0, 0, m_size.width() - 1, m_size.height() - 1, back, pixels, leftEye);
    const QImage upsideDown(pixels->GetPointer(0), m_size.width(), m_size.height(), 3 * m_size.width(),
                            QImage::Format_RGB888);
    return upsideDown.mirrored();
}

/// In the lower right corner, as in the view.
void OffscreenRenderer::drawLegend(QImage& picture) const
{
    const std::optional<ColorScale> values = m_scene->scale();
    const bool tellsBend = !values && m_look.options.shading == Shading::curvature;
    if (!tellsBend && (!values || !values->isKnown))
        return;
    const ColorScale scale = values.value_or(curvatureScale());
    QPainter painter(&picture);
    QFont font;
    font.setPixelSize(std::max(9, static_cast<int>(textShare * m_size.height())));
    painter.setFont(font);
    const ScaleText text = tellsBend ? curvatureText() : textOf(scale);
    const int inset = painter.fontMetrics().height();
    QRect place(QPoint(), legendSize(painter.fontMetrics(), text, {}));
    place.moveBottomRight(QPoint(m_size.width() - inset, m_size.height() - inset));
    paintLegend(painter, place, scale, text, {},
                {QColor(255, 255, 255, 215), QColor(30, 34, 38), QColor(150, 156, 162)});
}

/// As the view has them.
void OffscreenRenderer::writeReadings(QImage& picture, double at) const
{
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font;
    font.setPixelSize(std::max(9, static_cast<int>(textShare * m_size.height())));
    painter.setFont(font);
    const int lineHeight = painter.fontMetrics().height();
    drawText(painter, QPointF(lineHeight, m_size.height() - 2.5 * lineHeight), timeText(at));
    const WindowSize window{static_cast<double>(m_size.width()), static_cast<double>(m_size.height())};
    for (const SceneLabel& label : m_scene->labels())
        if (const auto place = m_look.camera.project(label.place, window); place && label.force >= shownForce)
            drawText(painter, QPointF(place->x + 0.5 * lineHeight, place->y - 0.5 * lineHeight),
                     formatReading(label.force, Quantity::Force));
}

} // namespace knead
