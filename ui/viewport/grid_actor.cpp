#include "ui/viewport/grid_actor.h"

#include "ui/round_number.h"
#include "ui/viewport/stroke_actor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr int halfLines = 20;        // grid lines on each side of the middle
constexpr int piecesPerLine = 40;    // a line fades along its length
constexpr double opacity = 0.55;     // of ordinary lines at the middle
constexpr double majorOpacity = 0.9; // of every fifth line
constexpr double sunk = 5e-3;        // below the floor, in steps: edges of parts that stand there on a line are whole

/// Blended like glass, but drawn with what one cannot see through: glass takes VTK a pass of its own over the whole view, which
/// without a graphics card costs as much as the skin of a large part. Lines on the ground need no sorting.
class GroundLines final : public StrokeActor {
public:
    static GroundLines* New();

    /// So that they hide nothing that comes later.
    bool IsRenderingTranslucentPolygonalGeometry() override { return true; }
};

vtkStandardNewMacro(GroundLines)

} // namespace

struct GridActor::Parts {
    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkSmartPointer<StrokeActor> actor = vtkSmartPointer<GroundLines>::New();
};

GridActor::GridActor(vtkRenderer* renderer)
    : m_parts(std::make_unique<Parts>())
{
    m_parts->renderer = renderer;
    m_parts->actor->SetMapper(m_parts->mapper);
    m_parts->actor->GetProperty()->LightingOff();
    m_parts->actor->setLineWidth(1);
    m_parts->actor->ForceOpaqueOn();
    m_parts->actor->UseBoundsOff(); // the view is fitted to parts, not to the ground
    renderer->AddActor(m_parts->actor);
}

GridActor::~GridActor()
{
    m_parts->renderer->RemoveActor(m_parts->actor);
}

void GridActor::lay(const Box& box, double height, const Color& color)
{
    const double step = 1 / roundUp(5 / box.sizes().maxCoeff()); // 1, 2 or 5 times a power of ten, not above a fifth
    const double reach = step * halfLines;
    const Vec3 middle(step * std::round(box.center().x() / step), step * std::round(box.center().y() / step),
                      height - sunk * step);

    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(4);
    const auto addLine = [&](int number, bool alongX) {
        const long index = std::lround((alongX ? middle.y() : middle.x()) / step) + number;
        const double strength = index % 5 == 0 ? majorOpacity : opacity;
        lines->InsertNextCell(piecesPerLine + 1);
        for (int piece = 0; piece <= piecesPerLine; ++piece) {
            const double along = reach * (2.0 * piece / piecesPerLine - 1);
            const double across = step * number;
            const Vec3 place = middle + (alongX ? Vec3(along, across, 0) : Vec3(across, along, 0));
            lines->InsertCellPoint(points->InsertNextPoint(place.data()));
            const double fade = std::max(0.0, 1 - std::hypot(along, across) / reach);
            const double rgba[] = {255.0 * color.r, 255.0 * color.g, 255.0 * color.b, 255 * strength * fade * fade};
            colors->InsertNextTuple(rgba);
        }
    };
    for (int number = -halfLines; number <= halfLines; ++number) {
        addLine(number, true);
        addLine(number, false);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetLines(lines);
    data->GetPointData()->SetScalars(colors);
    m_parts->mapper->SetInputData(data);
}

void GridActor::setVisible(bool visible)
{
    m_parts->actor->SetVisibility(visible);
}

void GridActor::comeLast(bool isInFront)
{
    m_parts->actor->SetForceOpaque(!isInFront);
    m_parts->actor->SetForceTranslucent(isInFront);
    if (m_parts->renderer->GetViewProps()->GetLastProp() == m_parts->actor)
        return;
    m_parts->renderer->RemoveActor(m_parts->actor);
    m_parts->renderer->AddActor(m_parts->actor);
}

} // namespace knead
