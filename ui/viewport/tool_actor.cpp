#include "ui/viewport/tool_actor.h"

#include "core/geometry/turn.h"
#include "ui/viewport/picker.h"
#include "ui/viewport/stroke_actor.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkFeatureEdges.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>

namespace knead {

namespace {

constexpr double smallestForceShown = 1e-9; // [N]
constexpr double shortestArrow = 0.25;      // of the longest
constexpr double edgeAngle = 30;            // [degrees]; rounder than this is drawn without a line
constexpr double thinnestArrow = 0.4;       // of the thickest

/// x -> rotation * scale * x + position
void place(vtkActor* actor, const Mat3& rotation, const Vec3& scale, const Vec3& position)
{
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            matrix->SetElement(row, column, rotation(row, column) * scale[column]);
        matrix->SetElement(row, 3, position[row]);
    }
    actor->SetUserMatrix(matrix);
}

/// Where the surface lies in a direction from the center: found from outside, as a hollow part has nothing in its middle.
double exitDistance(const ToolState& tool, const Vec3& direction)
{
    const double outside = tool.size.norm();
    const Ray inwards{tool.pose.position + outside * direction, -direction};
    return outside - pickTool(inwards, {tool.kind, tool.size, tool.part}, tool.pose).value_or(outside);
}

void fill(vtkPolyData* data, const TriangleMesh& mesh)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& vertex : mesh.vertices)
        points->InsertNextPoint(vertex.data());
    vtkNew<vtkCellArray> triangles;
    for (const TriangleMesh::Triangle& t : mesh.triangles)
        triangles->InsertNextCell({t[0], t[1], t[2]});
    data->SetPoints(points);
    data->SetPolys(triangles);
}

} // namespace

struct ToolActor::Parts {
    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkPolyData> surface;
    vtkNew<vtkPolyDataNormals> shading;
    vtkNew<vtkFeatureEdges> outline;
    vtkNew<vtkArrowSource> arrow;
    vtkNew<vtkPolyDataMapper> surfaceMapper;
    vtkNew<vtkPolyDataMapper> outlineMapper;
    vtkNew<vtkPolyDataMapper> arrowMapper;
    vtkNew<vtkActor> surfaceActor;
    vtkNew<StrokeActor> outlineActor;
    vtkNew<vtkActor> arrowActor;
    ToolShape shape{.size = Vec3::Zero()}; ///< as drawn
    Vec3 label = Vec3::Zero();

    void draw(const ToolShape& wanted);
};

/// The surface is made anew only when the tool has another form.
void ToolActor::Parts::draw(const ToolShape& wanted)
{
    if (wanted.kind == shape.kind && wanted.size == shape.size && wanted.part == shape.part)
        return;
    shape = wanted;
    fill(surface, meshOf(wanted));
    surface->Modified();
}

ToolActor::ToolActor(vtkRenderer* renderer)
    : m_parts(std::make_unique<Parts>())
{
    Parts& p = *m_parts;
    p.renderer = renderer;
    p.arrow->SetTipLength(0.32);
    p.arrow->SetTipRadius(0.11);
    p.arrow->SetShaftRadius(0.045);
    p.arrow->SetTipResolution(32);
    p.arrow->SetShaftResolution(32);
    p.shading->SetInputData(p.surface);
    p.shading->SetFeatureAngle(edgeAngle);
    p.surfaceMapper->SetInputConnection(p.shading->GetOutputPort());
    p.outline->SetInputData(p.surface);
    p.outline->SetFeatureAngle(edgeAngle);
    p.outline->ColoringOff();
    p.outlineMapper->SetInputConnection(p.outline->GetOutputPort());
    p.arrowMapper->SetInputConnection(p.arrow->GetOutputPort());
    p.surfaceActor->SetMapper(p.surfaceMapper);
    p.outlineActor->SetMapper(p.outlineMapper);
    p.arrowActor->SetMapper(p.arrowMapper);
    // A little translucent: the dent under the tool is what a person wants to see.
    p.surfaceActor->GetProperty()->SetOpacity(0.82);
    p.surfaceActor->GetProperty()->BackfaceCullingOn();
    p.surfaceActor->GetProperty()->SetAmbient(0.4);
    p.surfaceActor->GetProperty()->SetDiffuse(0.65);
    p.surfaceMapper->SetResolveCoincidentTopologyToPolygonOffset();
    p.surfaceMapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1);
    p.outlineActor->GetProperty()->LightingOff();
    p.arrowActor->GetProperty()->SetAmbient(0.35);
    for (vtkActor* actor : {p.surfaceActor.Get(), static_cast<vtkActor*>(p.outlineActor), p.arrowActor.Get()})
        renderer->AddActor(actor);
}

ToolActor::~ToolActor()
{
    for (vtkActor* actor :
         {m_parts->surfaceActor.Get(), static_cast<vtkActor*>(m_parts->outlineActor), m_parts->arrowActor.Get()})
        m_parts->renderer->RemoveActor(actor);
}

void ToolActor::show(const ToolState& tool, double longestArrow)
{
    const Mat3 rotation = tool.pose.rotation.toRotationMatrix();
    m_parts->draw({tool.kind, tool.size, tool.part});
    place(m_parts->surfaceActor, rotation, Vec3::Ones(), tool.pose.position);
    place(m_parts->outlineActor, rotation, Vec3::Ones(), tool.pose.position);

    const double force = tool.force.norm();
    const bool hasForce = force > smallestForceShown && longestArrow > 0;
    m_parts->arrowActor->SetVisibility(hasForce);
    if (!hasForce) {
        m_parts->label = tool.pose.position + Vec3(0, 0, exitDistance(tool, Vec3::UnitZ()));
        return;
    }
    const Vec3 direction = tool.force / force;
    const double share = tool.peakForce > 0 ? std::min(1.0, force / tool.peakForce) : 1;
    const double length = longestArrow * std::max(shortestArrow, share);
    const Vec3 tail = tool.pose.position + exitDistance(tool, direction) * direction;
    const Mat3 turn = turnOnto(Vec3::UnitX(), direction).toRotationMatrix();
    const double thickness = longestArrow * std::max(thinnestArrow, share);
    place(m_parts->arrowActor, turn, Vec3(length, thickness, thickness), tail);
    m_parts->label = tail + length * direction;
}

void ToolActor::setStyle(const SceneStyle& style, bool selected, bool hovered)
{
    const Color& fill = selected || hovered ? style.selectedTool : style.tool;
    const Color& line = selected ? style.selectedEdge : style.edge;
    m_parts->surfaceActor->GetProperty()->SetColor(fill.r, fill.g, fill.b);
    m_parts->outlineActor->GetProperty()->SetColor(line.r, line.g, line.b);
    m_parts->outlineActor->setLineWidth(selected ? 2.5F : 1.2F);
    m_parts->arrowActor->GetProperty()->SetColor(style.force.r, style.force.g, style.force.b);
}

Vec3 ToolActor::labelPlace() const
{
    return m_parts->label;
}

} // namespace knead
