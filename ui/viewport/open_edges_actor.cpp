#include "ui/viewport/open_edges_actor.h"

#include "ui/viewport/stroke_actor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPlaneCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace knead {

namespace {

constexpr float width = 3.5F; // [pixels]

} // namespace

struct OpenEdgesActor::Parts {
    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<StrokeActor> actor;
};

OpenEdgesActor::OpenEdgesActor(vtkRenderer* renderer)
    : m_parts(std::make_unique<Parts>())
{
    m_parts->renderer = renderer;
    // In front of the feature edges that run along them.
    m_parts->mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_parts->mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -8);
    m_parts->actor->SetMapper(m_parts->mapper);
    m_parts->actor->GetProperty()->LightingOff();
    m_parts->actor->setLineWidth(width);
    m_parts->actor->UseBoundsOff();
    renderer->AddActor(m_parts->actor);
}

OpenEdgesActor::~OpenEdgesActor()
{
    m_parts->renderer->RemoveActor(m_parts->actor);
}

void OpenEdgesActor::show(const Model& model, const std::function<bool(std::size_t part)>& isHidden)
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (std::size_t part = 0; part < model.parts.size(); ++part)
        if (!isHidden(part))
            for (const std::vector<Vec3>& line : model.parts[part].openEdges) {
                lines->InsertNextCell(static_cast<int>(line.size()));
                for (const Vec3& place : line)
                    lines->InsertCellPoint(points->InsertNextPoint(place.data()));
            }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetLines(lines);
    m_parts->mapper->SetInputData(data);
}

void OpenEdgesActor::setVisible(bool visible)
{
    m_parts->actor->SetVisibility(visible);
}

void OpenEdgesActor::setColor(const Color& color)
{
    m_parts->actor->GetProperty()->SetColor(color.r, color.g, color.b);
}

void OpenEdgesActor::setClipping(vtkPlaneCollection* planes)
{
    m_parts->mapper->SetClippingPlanes(planes);
}

} // namespace knead
