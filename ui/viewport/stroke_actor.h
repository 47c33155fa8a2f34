#pragma once

#include <vtkOpenGLActor.h>

namespace knead {

/// Lines and dots as wide on a screen of fine pixels as on any other: their widths are in pixels of the desktop. What a
/// pixel of the desktop is, the window says by its DPI, of which there are 72 where it is one of the screen.
class StrokeActor : public vtkOpenGLActor {
public:
    static StrokeActor* New();

    /// @param width of lines [pixels of the desktop]
    void setLineWidth(float width) { m_lineWidth = width; }
    /// @param size of points [pixels of the desktop]
    void setDotSize(float size) { m_dotSize = size; }

    void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

private:
    float m_lineWidth = 1;
    float m_dotSize = 1;
};

} // namespace knead
