#include "ui/viewport/viewport_bridge.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>

#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <utility>

namespace knead {

namespace {

constexpr int stillAfter = 150; // [ms], so that a person does not wait for the full picture

} // namespace

/// The render window and what it asks of Qt.
struct ViewportBridge::Window {
    vtkNew<vtkGenericOpenGLRenderWindow> render;
    vtkNew<vtkCallbackCommand> observer;
    QOpenGLContext* context = nullptr;
    QSurface* surface = nullptr;
    QMetaObject::Connection contextLost;

    static void answer(vtkObject* /*caller*/, unsigned long event, void* self, void* data)
    {
        auto& window = *static_cast<Window*>(self);
        if (event == vtkCommand::WindowIsCurrentEvent)
            *static_cast<bool*>(data) = window.context != nullptr && QOpenGLContext::currentContext() == window.context;
        else if (event == vtkCommand::WindowMakeCurrentEvent && window.context != nullptr)
            // Not the widget's makeCurrent(): that one binds Qt's framebuffer behind the back of VTK's state cache.
            window.context->makeCurrent(window.surface);
    }
};

ViewportBridge::ViewportBridge(QWidget* parent)
    : QOpenGLWidget(parent)
    , m_window(std::make_unique<Window>())
{
    setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
    m_window->observer->SetCallback(&Window::answer);
    m_window->observer->SetClientData(m_window.get());
    m_window->render->AddObserver(vtkCommand::WindowMakeCurrentEvent, m_window->observer);
    m_window->render->AddObserver(vtkCommand::WindowIsCurrentEvent, m_window->observer);
    m_window->render->SetFrameBlitModeToNoBlit();
    connect(this, &QOpenGLWidget::resized, this, &ViewportBridge::updateSize);
    connect(this, &QOpenGLWidget::frameSwapped, this, [this] {
        if (std::exchange(m_isTimed, false))
            m_fullSeconds = 1e-9 * static_cast<double>(m_clock.nsecsElapsed());
    });
    m_still.setSingleShot(true);
    m_still.setInterval(stillAfter);
    connect(&m_still, &QTimer::timeout, this, [this] {
        if (isMoving())
            m_still.start();
        else if (m_isSketch)
            becameStill();
    });
}

ViewportBridge::~ViewportBridge()
{
    // The context goes after this object does; it must not call back then.
    disconnect(m_window->contextLost);
    releaseContext();
}

void ViewportBridge::setSamples(int samples)
{
    m_samples = samples > 1 ? samples : 0;
    requestRender();
}

vtkRenderWindow* ViewportBridge::renderWindow() const
{
    return m_window->render;
}

QSurfaceFormat ViewportBridge::surfaceFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setVersion(3, 2);
    format.setOption(QSurfaceFormat::DeprecatedFunctions); // without it Mesa draws every line one pixel wide
    format.setDepthBufferSize(24);
    format.setAlphaBufferSize(8);
    format.setSamples(0); // multisampling belongs to VTK
    return format;
}

void ViewportBridge::requestRender()
{
    m_isDirty = true;
    update();
    emit renderRequested();
}

void ViewportBridge::requestSketch()
{
    m_still.start();
    requestRender();
}

void ViewportBridge::updateSize()
{
    const QSize pixels = size() * devicePixelRatioF();
    m_window->render->SetSize(pixels.width(), pixels.height());
    m_window->render->SetDPI(static_cast<int>(72 * devicePixelRatioF()));
    requestRender();
}

/// Runs again after the widget moved to another window.
void ViewportBridge::initializeGL()
{
    m_window->context = context();
    m_window->surface = context()->surface();
    m_window->contextLost =
        connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ViewportBridge::releaseContext);
    vtkOpenGLState* state = m_window->render->GetState();
    state->Reset();
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglEnable(GL_DEPTH_TEST);
    m_window->render->SetReadyForRendering(true);
    m_window->render->SetOwnContext(0);
    m_window->render->OpenGLInitContext();
    updateSize();
}

void ViewportBridge::releaseContext()
{
    if (m_window->context == nullptr)
        return;
    m_window->context->makeCurrent(m_window->surface);
    m_window->render->Finalize();
    m_window->render->SetReadyForRendering(false);
    m_window->context = nullptr;
}

void ViewportBridge::paintEvent(QPaintEvent* event)
{
    m_isPainting = true;
    QOpenGLWidget::paintEvent(event);
    m_isPainting = false;
}

/// Without smoothing a picture takes half the time on a machine that has no graphics card.
void ViewportBridge::draw(bool asSketch)
{
    m_isDirty = false;
    m_isSketch = asSketch;
    m_isTimed = m_isPainting && !asSketch;
    m_clock.start();
    m_window->render->SetMultiSamples(asSketch ? 0 : m_samples);
    aboutToRender();
    m_window->render->Render();
    m_renderSeconds = 1e-9 * static_cast<double>(m_clock.nsecsElapsed());
}

void ViewportBridge::paintGL()
{
    vtkOpenGLState* state = m_window->render->GetState();
    state->Reset(); // Qt drew in between
    state->Push();
    if (m_isDirty || (m_isSketch && !m_isPainting)) {
        const bool isSlow = m_samples > 0 && m_fullSeconds > m_longestFull;
        draw(m_isPainting && m_still.isActive() && isSlow);
    }
    const QSize pixels = size() * devicePixelRatioF();
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    m_window->render->BlitDisplayFramebuffer(0, 0, 0, pixels.width(), pixels.height(), 0, 0, pixels.width(),
                                             pixels.height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
    // The window behind must not shine through where the scene is translucent.
    QOpenGLFunctions* gl = context()->functions();
    gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gl->glClearColor(0, 0, 0, 1);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->Pop();
}

} // namespace knead
