#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>

#include <memory>

class vtkRenderWindow;

namespace knead {

/// Shows what a VTK render window draws in a Qt widget. VTK draws into its own framebuffer with Qt's context; the
/// result is copied
/// into the widget's. Made by us because Debian builds VTK's own bridge with Qt 5.
///
/// Where smoothing takes long, as without a graphics card, pictures of what moves are sketches: they are not smoothed. As
/// soon as it is still it is drawn once more, in full. Who grabs a picture always gets a full one.
class ViewportBridge : public QOpenGLWidget {
    Q_OBJECT
public:
    explicit ViewportBridge(QWidget* parent = nullptr);
    ~ViewportBridge() override;

    vtkRenderWindow* renderWindow() const;

    /// The scene changed: draws it at the next opportunity, once, however often this is called.
    void requestRender();
    /// The same where the next change is expected to follow at once, as while the view is turned: a sketch will do.
    void requestSketch();
    /// A sketch was asked for a moment ago, and another may be.
    bool isInMotion() const { return m_still.isActive(); }
    /// What is seen is a sketch, which will be drawn in full.
    bool isSketch() const { return m_isSketch; }
    /// Whether sketches are drawn is found out by how long a full picture takes; for tests, it may be said. [s]
    void setLongestFull(double seconds) { m_longestFull = seconds; }

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
    void paintEvent(QPaintEvent* event) override;

    /// Nothing asked for a sketch for a while: it is to be drawn in full. By default at the next opportunity.
    virtual void becameStill() { requestRender(); }
    /// Things go on moving, though no sketch was asked for.
    virtual bool isMoving() const { return false; }

    /// Called before every drawing.
    virtual void aboutToRender() {}

private:
    struct Window;

    void updateSize();
    void releaseContext();
    void draw(bool asSketch);

    std::unique_ptr<Window> m_window;
    int m_samples = 4;
    bool m_isDirty = true;
    bool m_isPainting = false; ///< for the screen, and not for who grabs a picture
    bool m_isSketch = false;
    bool m_isTimed = false;      ///< a full picture is on its way to the screen
    QTimer m_still;              ///< runs while sketches are wanted
    QElapsedTimer m_clock;       ///< since a full picture was begun
    double m_fullSeconds = 0;    ///< wall time of a full picture until it was seen
    double m_longestFull = 0.03; ///< that is smoothed while things move, too [s]
    double m_renderSeconds = 0;
};

} // namespace knead
