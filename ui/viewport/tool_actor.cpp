#include "ui/viewport/tool_actor.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCubeSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>

namespace knead {

namespace {

constexpr double smallestForceShown = 1e-9; // [N]
constexpr double shortestArrow = 0.25;      // of the longest
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

/// Where a ray from the center leaves the block.
double exitDistance(const ToolState& tool, const Vec3& direction)
{
    const Vec3 local = (tool.pose.rotation.conjugate() * direction).cwiseAbs();
    return (tool.size / 2).cwiseQuotient(local.cwiseMax(1e-12)).minCoeff();
}

} // namespace

struct ToolActor::Parts {
    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkCubeSource> cube;
    vtkNew<vtkArrowSource> arrow;
    vtkNew<vtkPolyDataMapper> cubeMapper;
    vtkNew<vtkPolyDataMapper> arrowMapper;
    vtkNew<vtkActor> cubeActor;
    vtkNew<vtkActor> outlineActor;
    vtkNew<vtkActor> arrowActor;
    Vec3 label = Vec3::Zero();
};

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
    p.cubeMapper->SetInputConnection(p.cube->GetOutputPort());
    p.arrowMapper->SetInputConnection(p.arrow->GetOutputPort());
    p.cubeActor->SetMapper(p.cubeMapper);
    p.outlineActor->SetMapper(p.cubeMapper);
    p.outlineActor->GetProperty()->SetRepresentationToWireframe();
    p.arrowActor->SetMapper(p.arrowMapper);
    // A little translucent: the dent under the block is what a person wants to see.
    p.cubeActor->GetProperty()->SetOpacity(0.82);
    p.cubeActor->GetProperty()->BackfaceCullingOn();
    p.cubeActor->GetProperty()->SetAmbient(0.4);
    p.cubeActor->GetProperty()->SetDiffuse(0.65);
    p.cubeMapper->SetResolveCoincidentTopologyToPolygonOffset();
    p.cubeMapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1);
    p.outlineActor->GetProperty()->LightingOff();
    p.arrowActor->GetProperty()->SetAmbient(0.35);
    for (vtkActor* actor : {p.cubeActor.Get(), p.outlineActor.Get(), p.arrowActor.Get()})
        renderer->AddActor(actor);
}

ToolActor::~ToolActor()
{
    for (vtkActor* actor : {m_parts->cubeActor.Get(), m_parts->outlineActor.Get(), m_parts->arrowActor.Get()})
        m_parts->renderer->RemoveActor(actor);
}

void ToolActor::show(const ToolState& tool, double longestArrow)
{
    const Mat3 rotation = tool.pose.rotation.toRotationMatrix();
    place(m_parts->cubeActor, rotation, tool.size, tool.pose.position);
    place(m_parts->outlineActor, rotation, tool.size, tool.pose.position);

    const double force = tool.force.norm();
    const bool hasForce = force > smallestForceShown;
    m_parts->arrowActor->SetVisibility(hasForce);
    if (!hasForce) {
        m_parts->label = tool.pose.position + Vec3(0, 0, exitDistance(tool, Vec3::UnitZ()));
        return;
    }
    const Vec3 direction = tool.force / force;
    const double share = tool.peakForce > 0 ? std::min(1.0, force / tool.peakForce) : 1;
    const double length = longestArrow * std::max(shortestArrow, share);
    const Vec3 tail = tool.pose.position + exitDistance(tool, direction) * direction;
    const Mat3 turn = Quaternion::FromTwoVectors(Vec3::UnitX(), direction).toRotationMatrix();
    const double thickness = longestArrow * std::max(thinnestArrow, share);
    place(m_parts->arrowActor, turn, Vec3(length, thickness, thickness), tail);
    m_parts->label = tail + length * direction;
}

void ToolActor::setStyle(const SceneStyle& style, bool selected, bool hovered)
{
    const Color& fill = selected || hovered ? style.selectedTool : style.tool;
    const Color& line = selected ? style.selectedEdge : style.edge;
    m_parts->cubeActor->GetProperty()->SetColor(fill.r, fill.g, fill.b);
    m_parts->outlineActor->GetProperty()->SetColor(line.r, line.g, line.b);
    m_parts->outlineActor->GetProperty()->SetLineWidth(selected ? 2.5F : 1.2F);
    m_parts->arrowActor->GetProperty()->SetColor(style.force.r, style.force.g, style.force.b);
}

Vec3 ToolActor::labelPlace() const
{
    return m_parts->label;
}

} // namespace knead
