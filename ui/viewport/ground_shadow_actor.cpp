#include "ui/viewport/ground_shadow_actor.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLActor.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace knead {

namespace {

constexpr double deepest = 0.5; // opacity of the darkest place
constexpr double belowGround =
    0.25; // below the ground, in steps of the shadow: what stands there hides it, and the grid lies on it

/// Blended like glass, but drawn with what one cannot see through, as the lines of the grid are.
class GroundPatch final : public vtkOpenGLActor {
public:
    static GroundPatch* New();

    bool IsRenderingTranslucentPolygonalGeometry() override { return true; }
};

vtkStandardNewMacro(GroundPatch)

} // namespace

struct GroundShadowActor::Parts {
    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkPoints> points;
    vtkNew<vtkUnsignedCharArray> colors;
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkSmartPointer<vtkActor> actor = vtkSmartPointer<GroundPatch>::New();
    int side = 0;
};

GroundShadowActor::GroundShadowActor(vtkRenderer* renderer)
    : m_parts(std::make_unique<Parts>())
{
    Parts& p = *m_parts;
    p.renderer = renderer;
    p.colors->SetNumberOfComponents(4);
    p.data->SetPoints(p.points);
    p.data->GetPointData()->SetScalars(p.colors);
    p.mapper->SetInputData(p.data);
    p.actor->SetMapper(p.mapper);
    p.actor->GetProperty()->LightingOff();
    p.actor->ForceOpaqueOn();
    p.actor->UseBoundsOff(); // the view is fitted to parts, not to the ground
    p.actor->PickableOff();
    renderer->AddActor(p.actor);
}

GroundShadowActor::~GroundShadowActor()
{
    m_parts->renderer->RemoveActor(m_parts->actor);
}

void GroundShadowActor::lay(const GroundShadow& shadow, double height)
{
    Parts& p = *m_parts;
    const int side = shadow.step > 0 ? shadow.side : 0;
    if (side != p.side) {
        p.side = side;
        vtkNew<vtkCellArray> cells;
        for (int y = 0; y + 1 < side; ++y)
            for (int x = 0; x + 1 < side; ++x) {
                const vtkIdType i = static_cast<vtkIdType>(y) * side + x;
                const vtkIdType corners[] = {i, i + 1, i + side + 1, i + side};
                cells->InsertNextCell(4, corners);
            }
        p.data->SetPolys(cells);
        p.points->SetNumberOfPoints(static_cast<vtkIdType>(side) * side);
        p.colors->SetNumberOfTuples(static_cast<vtkIdType>(side) * side);
    }
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const vtkIdType i = static_cast<vtkIdType>(y) * side + x;
            p.points->SetPoint(i, shadow.low.x() + shadow.step * x, shadow.low.y() + shadow.step * y,
                               height - belowGround * shadow.step);
            unsigned char* color = p.colors->GetPointer(4 * i);
            color[0] = color[1] = color[2] = 0;
            color[3] = static_cast<unsigned char>(
                std::lround(255 * deepest * static_cast<double>(shadow.darkness[static_cast<std::size_t>(i)])));
        }
    p.points->Modified();
    p.colors->Modified();
    p.data->Modified();
}

void GroundShadowActor::setVisible(bool visible)
{
    m_parts->actor->SetVisibility(visible);
}

void GroundShadowActor::comeLast(bool isInFront)
{
    m_parts->actor->SetForceOpaque(!isInFront);
    m_parts->actor->SetForceTranslucent(isInFront);
    m_parts->renderer->RemoveActor(m_parts->actor);
    m_parts->renderer->AddActor(m_parts->actor);
}

} // namespace knead
