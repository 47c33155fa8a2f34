#include "ui/viewport/object_actor.h"

#include "ui/viewport/drawn_points.h"

#include <vtkActor.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPlaneCollection.h>
#include <vtkProperty.h>

namespace knead {

struct ObjectActor::Parts : DrawnPoints<vtkOpenGLSphereMapper, vtkActor> {
    using DrawnPoints::DrawnPoints;
};

ObjectActor::ObjectActor(vtkRenderer* renderer, const Color& color, double radius)
    : m_parts(std::make_unique<Parts>(renderer))
{
    m_parts->mapper->SetRadius(static_cast<float>(radius));
    m_parts->actor->GetProperty()->SetColor(color.r, color.g, color.b);
    m_parts->actor->GetProperty()->SetAmbient(0.15);
}

ObjectActor::~ObjectActor() = default;

void ObjectActor::show(std::span<const Vec3> positions, std::span<const std::uint32_t> chosen)
{
    const std::size_t count = chosen.empty() ? positions.size() : chosen.size();
    if (static_cast<std::size_t>(m_parts->points->GetNumberOfPoints()) != count) {
        m_parts->points->SetNumberOfPoints(static_cast<vtkIdType>(count));
        m_parts->joinNothing(count);
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
