#include "ui/viewport/region_actor.h"

#include "core/session/region_contents.h"
#include "ui/viewport/drawn_points.h"
#include "ui/viewport/stroke_actor.h"

#include <vtkActor.h>
#include <vtkIdTypeArray.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace knead {

namespace {

constexpr float regionLineWidth = 4.5F; // [pixels]
constexpr double markRadius = 0.5;      // [a]

} // namespace

struct RegionActor::Parts {
    explicit Parts(vtkRenderer* renderer)
        : lines(renderer)
        , objects(renderer)
    {
    }

    DrawnPoints<vtkPolyDataMapper, StrokeActor> lines;
    DrawnPoints<vtkOpenGLSphereMapper, vtkActor> objects;
};

RegionActor::RegionActor(vtkRenderer* renderer)
    : m_parts(std::make_unique<Parts>(renderer))
{
    m_parts->lines.actor->setLineWidth(regionLineWidth);
    m_parts->lines.actor->GetProperty()->LightingOff();
    // Some drivers draw every line one pixel wide, which the skin's own edges cover; a shader draws tubes.
    m_parts->lines.actor->GetProperty()->RenderLinesAsTubesOn();
    m_parts->objects.actor->GetProperty()->SetAmbient(0.3);
    hide();
}

RegionActor::~RegionActor() = default;

void RegionActor::setColor(const Color& color)
{
    m_parts->lines.actor->GetProperty()->SetColor(color.r, color.g, color.b);
    m_parts->objects.actor->GetProperty()->SetColor(color.r, color.g, color.b);
}

void RegionActor::setClipping(vtkPlaneCollection* planes)
{
    m_parts->lines.mapper->SetClippingPlanes(planes);
    m_parts->objects.mapper->SetClippingPlanes(planes);
}

void RegionActor::hide()
{
    m_parts->lines.actor->VisibilityOff();
    m_parts->objects.actor->VisibilityOff();
}

bool RegionActor::isShown() const
{
    return m_parts->lines.actor->GetVisibility() != 0 || m_parts->objects.actor->GetVisibility() != 0;
}

void RegionActor::show(const Region& region, const FilledBodies& bodies, const Frame& frame, double scale)
{
    hide();
    if (region.isEmpty())
        return;
    if (region.level == Level::Edge || region.level == Level::Connection || region.level == Level::Face)
        addLines(region, bodies, frame);
    else if (region.level == Level::Object)
        addObjects(region, bodies, frame, scale);
}

void RegionActor::addLines(const Region& region, const FilledBodies& bodies, const Frame& frame)
{
    m_ends.clear();
    const auto add = [&](const Vec3& a, const Vec3& b) {
        for (const Vec3& end : {a, b})
            for (const double value : end)
                m_ends.push_back(static_cast<float>(value));
    };
    for (const auto& [id, items] : region.items) {
        const FilledBody& body = *bodies[id];
        const std::vector<Vec3>& skin = frame.bodies[id]->places;
        const std::vector<Vec3>& objects = frame.snapshot->bodies[id].positions;
        if (region.level == Level::Face) {
            for (const auto& [a, b] : outlineOf(id, bodies[id], items))
                add(skin[a], skin[b]);
            continue;
        }
        if (region.level == Level::Edge) {
            for (std::size_t e = 0; e < body.render.edges.size(); ++e)
                if (std::binary_search(items.begin(), items.end(), body.render.chainOfEdge[e]))
                    add(skin[body.render.source[body.render.edges[e][0]]],
                        skin[body.render.source[body.render.edges[e][1]]]);
            continue;
        }
        for (const Region::Item item : items) {
            const auto [lower, upper] = endsOf(*body.aggregate, connectionOf(item));
            add(objects[lower], objects[upper]);
        }
    }
    const auto count = static_cast<vtkIdType>(m_ends.size() / 3);
    m_parts->lines.points->SetNumberOfPoints(count);
    std::copy(m_ends.begin(), m_ends.end(), static_cast<float*>(m_parts->lines.points->GetVoidPointer(0)));
    m_parts->lines.points->Modified();
    vtkNew<vtkIdTypeArray> ids;
    ids->SetNumberOfValues(count);
    std::iota(ids->Begin(), ids->End(), vtkIdType{0});
    vtkNew<vtkCellArray> cells;
    cells->SetData(2, ids); // two points each
    m_parts->lines.data->SetLines(cells);
    m_parts->lines.data->Modified();
    m_parts->lines.actor->VisibilityOn();
}

/// Around faces that lie side by side there is one line.
const std::vector<std::array<std::uint32_t, 2>>&
RegionActor::outlineOf(BodyId id, const std::shared_ptr<const FilledBody>& body, const Region::Items& faces)
{
    Outline& outline = m_outlines[id];
    if (outline.body.lock() == body && outline.faces == faces)
        return outline.lines;
    outline = {body, faces, {}};
    const RenderMesh& mesh = body->render;
    std::vector<std::array<std::uint32_t, 2>> sides;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!std::binary_search(faces.begin(), faces.end(), Region::Item{mesh.faceOfTriangle[t]}))
            continue;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto [a, b] =
                std::minmax(mesh.source[mesh.triangles[t][corner]], mesh.source[mesh.triangles[t][(corner + 1) % 3]]);
            sides.push_back({a, b});
        }
    }
    std::sort(sides.begin(), sides.end());
    for (auto side = sides.begin(); side != sides.end();) {
        const auto next = std::find_if(side, sides.end(), [&](const auto& other) { return other != *side; });
        if (next - side == 1) // those within belong to two triangles
            outline.lines.push_back(*side);
        side = next;
    }
    return outline.lines;
}

void RegionActor::addObjects(const Region& region, const FilledBodies& bodies, const Frame& frame, double scale)
{
    m_parts->objects.points->Reset();
    double spacing = 0;
    for (const auto& [id, items] : region.items) {
        spacing = bodies[id]->aggregate->lattice.spacing;
        for (const Region::Item object : items)
            m_parts->objects.points->InsertNextPoint(frame.snapshot->bodies[id].positions[object].data());
    }
    m_parts->objects.points->Modified();
    m_parts->objects.joinNothing(static_cast<std::size_t>(m_parts->objects.points->GetNumberOfPoints()));
    m_parts->objects.data->Modified();
    m_parts->objects.mapper->SetRadius(static_cast<float>(scale * markRadius * spacing));
    m_parts->objects.actor->VisibilityOn();
}

} // namespace knead
