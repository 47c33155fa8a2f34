#include "ui/viewport/connection_actor.h"

#include "ui/viewport/drawn_points.h"
#include "ui/viewport/stroke_actor.h"

#include "core/aggregate/pieces.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>

namespace knead {

namespace {

constexpr float dotSize = 7;          // [pixels]
constexpr double beforeAll = -66000;  // units of depth: in front of everything
constexpr std::size_t crowded = 3000; // so many dots are drawn smaller
constexpr float crowdedDotSize = 4;

void setPoints(vtkPoints* points, std::span<const Vec3> places)
{
    points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
    auto* out = static_cast<float*>(points->GetVoidPointer(0));
    for (const Vec3& place : places)
        for (const double coordinate : place)
            *out++ = static_cast<float>(coordinate);
    points->GetData()->Modified();
    points->Modified();
}

} // namespace

struct StrokesOfPoints : DrawnPoints<vtkPolyDataMapper, StrokeActor> {
    using DrawnPoints::DrawnPoints;
};

ConnectionActor::ConnectionActor(vtkRenderer* renderer, const Color& color)
    : m_parts(std::make_unique<StrokesOfPoints>(renderer))
{
    m_parts->actor->GetProperty()->SetColor(color.r, color.g, color.b);
    m_parts->actor->GetProperty()->LightingOff();
    m_parts->actor->setLineWidth(1.2F);
}

ConnectionActor::~ConnectionActor() = default;

void ConnectionActor::setConnections(const Aggregate& aggregate, std::span<const BrokenConnection> broken,
                                     std::span<const ObjectIndex> chosen)
{
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate, broken);
    std::vector<bool> isChosen(aggregate.size(), chosen.empty());
    for (const ObjectIndex object : chosen)
        isChosen[object] = true;
    vtkNew<vtkCellArray> lines;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
            for (ObjectIndex i = segment.begin; i < segment.end; ++i) {
                const ObjectIndex other = i + static_cast<ObjectIndex>(segment.offset);
                if (!isChosen[i] || !isChosen[other] || !(aggregate.weight[d][i] > 0) || (isBroken[i] >> d & 1U) != 0)
                    continue;
                const vtkIdType ends[] = {i, other};
                lines->InsertNextCell(2, ends);
            }
    m_parts->data->SetLines(lines);
    m_parts->data->Modified();
}

void ConnectionActor::show(std::span<const Vec3> positions)
{
    setPoints(m_parts->points, positions);
    m_parts->data->Modified();
}

void ConnectionActor::setClipping(vtkPlaneCollection* planes)
{
    m_parts->mapper->SetClippingPlanes(planes);
}

BreakActor::BreakActor(vtkRenderer* renderer)
    : m_parts(std::make_unique<StrokesOfPoints>(renderer))
{
    m_parts->mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_parts->mapper->SetRelativeCoincidentTopologyPointOffsetParameter(beforeAll);
    m_parts->actor->GetProperty()->LightingOff();
    m_parts->actor->GetProperty()->RenderPointsAsSpheresOn();
}

BreakActor::~BreakActor() = default;

void BreakActor::show(const std::vector<Vec3>& marks)
{
    if (static_cast<std::size_t>(m_parts->points->GetNumberOfPoints()) != marks.size())
        m_parts->joinNothing(marks.size());
    setPoints(m_parts->points, marks);
    m_parts->data->Modified();
    m_parts->actor->SetVisibility(!marks.empty());
    m_parts->actor->setDotSize(marks.size() > crowded ? crowdedDotSize : dotSize);
}

void BreakActor::setColor(const Color& color)
{
    m_parts->actor->GetProperty()->SetColor(color.r, color.g, color.b);
}

void BreakActor::setClipping(vtkPlaneCollection* planes)
{
    m_parts->mapper->SetClippingPlanes(planes);
}

std::vector<Vec3> breakMarks(const Aggregate& aggregate, std::span<const Vec3> positions,
                             std::span<const BrokenConnection> broken)
{
    std::vector<Vec3> marks;
    marks.reserve(2 * broken.size());
    for (const ConnectionId& connection : broken) {
        Lattice::Node node = aggregate.lattice.nodes[connection.lower];
        for (std::size_t axis = 0; axis < 3; ++axis)
            node[axis] += Lattice::directions[connection.direction][axis];
        const ObjectIndex other = aggregate.lattice.find(node);
        if (other >= aggregate.size())
            continue;
        const Vec3 way = positions[other] - positions[connection.lower];
        const double length = way.norm();
        const double half = 0.5 * aggregate.lattice.direction(static_cast<int>(connection.direction)).norm();
        const Vec3 step = length > 0 ? Vec3(way * (half / length)) : Vec3(Vec3::Zero());
        marks.emplace_back(positions[connection.lower] + step);
        marks.emplace_back(positions[other] - step);
    }
    return marks;
}

} // namespace knead
