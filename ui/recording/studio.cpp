#include "ui/recording/studio.h"

#include "ui/document/entry_names.h"
#include "ui/units.h"
#include "ui/viewport/color_legend.h"
#include "ui/viewport/viewport_bridge.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QPainter>

#include <chrono>
#include <exception>
#include <future>
#include <stdexcept>

namespace knead {

namespace {

constexpr double textShare = 1.0 / 45; // height of text in heights of the picture
constexpr double shownForce = 1e-6;    // [N]
constexpr auto patience = std::chrono::milliseconds(50);

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
struct Studio::Room {
    QOffscreenSurface surface;
    QOpenGLContext context;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkNew<vtkCallbackCommand> observer;

    explicit Room(const QSize& size)
    {
        surface.setFormat(ViewportBridge::surfaceFormat());
        surface.create();
        context.setFormat(surface.format());
        if (!context.create() || !context.makeCurrent(&surface))
            throw std::runtime_error("This computer cannot draw pictures that are not seen: OpenGL 3.2 is missing.");
        observer->SetCallback(&Room::answer);
        observer->SetClientData(this);
        window->AddObserver(vtkCommand::WindowMakeCurrentEvent, observer);
        window->AddObserver(vtkCommand::WindowIsCurrentEvent, observer);
        window->SetFrameBlitModeToNoBlit();
        window->SetMultiSamples(8);
        window->SetSize(size.width(), size.height());
        window->SetReadyForRendering(true);
        window->SetOwnContext(0);
        window->OpenGLInitContext();
    }

    ~Room()
    {
        context.makeCurrent(&surface);
        window->Finalize();
        window->SetReadyForRendering(false);
        window->RemoveAllObservers();
        context.doneCurrent();
    }

    static void answer(vtkObject* /*caller*/, unsigned long event, void* self, void* data)
    {
        auto& room = *static_cast<Room*>(self);
        if (event == vtkCommand::WindowIsCurrentEvent)
            *static_cast<bool*>(data) = QOpenGLContext::currentContext() == &room.context;
        else if (event == vtkCommand::WindowMakeCurrentEvent)
            room.context.makeCurrent(&room.surface);
    }
};

std::shared_ptr<Studio> Studio::make(SceneLook look, const QSize& size)
{
    return {new Studio(std::move(look), size), [](Studio* studio) { studio->deleteLater(); }};
}

Studio::Studio(SceneLook look, const QSize& size)
    : m_look(std::move(look))
    , m_size(size)
    , m_sights(m_look.content.bodies)
    , m_room(std::make_unique<Room>(size))
    , m_scene(std::make_unique<SceneView>(m_room->window))
{
    m_scene->setStyle(m_look.style);
    m_scene->setContent(m_look.content);
    m_scene->setOptions(m_look.options);
    m_scene->setMarks(m_look.marks);
    m_scene->setLooks(m_look.looks);
    vtkRendererCollection* renderers = m_room->window->GetRenderers();
    renderers->InitTraversal();
    while (vtkRenderer* renderer = renderers->GetNextItem())
        renderer->SetDraw(renderer->GetLayer() == 0); // without the cube
    m_room->context.doneCurrent();
}

Studio::~Studio()
{
    m_room->context.makeCurrent(&m_room->surface);
    m_scene.reset();
}

QImage Studio::draw(const FramePointer& frame, const SightPointer& sight)
{
    m_room->context.makeCurrent(&m_room->surface);
    m_scene->showFrame(frame);
    m_scene->setSight(sight);
    m_scene->setCamera(m_look.camera);
    m_room->window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    constexpr int back = 0;
    constexpr int leftEye = 0;
    m_room->window->GetPixelData(0, 0, m_size.width() - 1, m_size.height() - 1, back, pixels, leftEye);
    m_room->context.doneCurrent();
    if (pixels->GetNumberOfTuples() != vtkIdType{m_size.width()} * m_size.height())
        throw std::runtime_error("The picture could not be read back from the graphics card. Choose a smaller size.");
    const QImage upsideDown(pixels->GetPointer(0), m_size.width(), m_size.height(), 3 * m_size.width(),
                            QImage::Format_RGB888);
    QImage picture = upsideDown.mirrored();
    drawLegend(picture);
    return picture;
}

/// In the lower right corner, as in the view.
void Studio::drawLegend(QImage& picture) const
{
    const std::optional<ColorScale> scale = m_scene->scale();
    if (!scale || !scale->isKnown)
        return;
    QPainter painter(&picture);
    QFont font;
    font.setPixelSize(std::max(9, static_cast<int>(textShare * m_size.height())));
    painter.setFont(font);
    const ScaleText text = textOf(*scale);
    const int inset = painter.fontMetrics().height();
    QRect place(QPoint(), legendSize(painter.fontMetrics(), text, {}));
    place.moveBottomRight(QPoint(m_size.width() - inset, m_size.height() - inset));
    paintLegend(painter, place, *scale, text, {},
                {QColor(255, 255, 255, 215), QColor(30, 34, 38), QColor(150, 156, 162)});
}

QImage Studio::drawFor(const std::shared_ptr<Studio>& studio, const FramePointer& frame, std::optional<double> at,
                       TaskControl& control)
{
    const SightWish wish = wishOf(studio->m_look.options);
    const SightPointer sight = wish.isEmpty() ? nullptr : studio->m_sights.make(frame, wish);
    auto promise = std::make_shared<std::promise<QImage>>();
    std::future<QImage> drawn = promise->get_future();
    const auto work = [studio, promise, frame, sight, at] {
        try {
            QImage picture = studio->draw(frame, sight);
            if (at)
                studio->writeReadings(picture, *at);
            promise->set_value(std::move(picture));
        } catch (...) {
            promise->set_exception(std::current_exception());
        }
    };
    QMetaObject::invokeMethod(studio.get(), work, Qt::QueuedConnection);
    while (drawn.wait_for(patience) != std::future_status::ready)
        control.throwIfCancelled();
    return drawn.get();
}

/// As the view has them.
void Studio::writeReadings(QImage& picture, double at) const
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
