#pragma once

#include <QOpenGLWidget>

#include <memory>

class vtkRenderWindow;

namespace knead {

/// Shows what a VTK render window draws in a Qt widget. VTK draws into its own framebuffer with Qt's context; the
/// result is copied
/// into the widget's. Made by us because Debian builds VTK's own bridge with Qt 5.
class ViewportBridge : public QOpenGLWidget {
    Q_OBJECT
public:
    explicit ViewportBridge(QWidget* parent = nullptr);
    ~ViewportBridge() override;

    vtkRenderWindow* renderWindow() const;

    /// The scene changed: draws it at the next opportunity, once, however often this is called.
    void requestRender();

    /// @param samples of a pixel: 1 draws jagged edges
    void setSamples(int samples);

    /// Wall time of the last drawing [s].
    double renderSeconds() const { return m_renderSeconds; }

    /// The surface format the application must set before it is created.
    static QSurfaceFormat surfaceFormat();

signals:
    void renderRequested(); ///< what is painted over the scene goes with it

protected:
    void initializeGL() override;
    void paintGL() override;

    /// Called before every drawing.
    virtual void aboutToRender() {}

private:
    struct Window;

    void updateSize();
    void releaseContext();

    std::unique_ptr<Window> m_window;
    bool m_isDirty = true;
    double m_renderSeconds = 0;
};

} // namespace knead
