#include "ui/viewport/stroke_actor.h"

#include <vtkObjectFactory.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace knead {

namespace {

constexpr float usualDpi = 72;

} // namespace

void StrokeActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
    const float scale = static_cast<float>(renderer->GetRenderWindow()->GetDPI()) / usualDpi;
    GetProperty()->SetLineWidth(scale * m_lineWidth);
    GetProperty()->SetPointSize(scale * m_dotSize);
    vtkOpenGLActor::Render(renderer, mapper);
}

vtkStandardNewMacro(StrokeActor)

} // namespace knead
