#include "ui/viewport/object_actor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPlaneCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <numeric>
#include <vector>

namespace knead {

struct ObjectActor::Parts {
    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkPoints> points;
    vtkNew<vtkPolyData> data;
    vtkNew<vtkOpenGLSphereMapper> mapper;
    vtkNew<vtkActor> actor;
};

ObjectActor::ObjectActor(vtkRenderer* renderer, const Color& color, double radius)
    : m_parts(std::make_unique<Parts>())
{
    m_parts->renderer = renderer;
    m_parts->points->SetDataTypeToFloat();
    m_parts->data->SetPoints(m_parts->points);
    m_parts->mapper->SetInputData(m_parts->data);
    m_parts->mapper->SetRadius(static_cast<float>(radius));
    m_parts->actor->SetMapper(m_parts->mapper);
    m_parts->actor->GetProperty()->SetColor(color.r, color.g, color.b);
    m_parts->actor->GetProperty()->SetAmbient(0.15);
    renderer->AddActor(m_parts->actor);
}

ObjectActor::~ObjectActor()
{
    m_parts->renderer->RemoveActor(m_parts->actor);
}

void ObjectActor::show(std::span<const Vec3> positions, std::span<const std::uint32_t> chosen)
{
    const std::size_t count = chosen.empty() ? positions.size() : chosen.size();
    if (static_cast<std::size_t>(m_parts->points->GetNumberOfPoints()) != count) {
        std::vector<vtkIdType> ids(count);
        std::iota(ids.begin(), ids.end(), 0);
        vtkNew<vtkCellArray> vertices;
        vertices->InsertNextCell(static_cast<vtkIdType>(count), ids.data());
        m_parts->points->SetNumberOfPoints(static_cast<vtkIdType>(count));
        m_parts->data->SetVerts(vertices);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3& place = positions[chosen.empty() ? i : chosen[i]];
        m_parts->points->SetPoint(static_cast<vtkIdType>(i), place.data());
    }
    m_parts->points->Modified();
    m_parts->data->Modified();
}

void ObjectActor::setClipping(vtkPlaneCollection* planes)
{
    m_parts->mapper->SetClippingPlanes(planes);
}

} // namespace knead
