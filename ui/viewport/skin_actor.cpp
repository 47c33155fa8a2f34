#include "ui/viewport/skin_actor.h"

#include "core/geometry/mass_properties.h"
#include "core/session/edge_sight.h"
#include "core/session/relief.h"
#include "ui/viewport/stroke_actor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace knead {

struct SkinActor::Parts {
    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> normals;
    vtkNew<vtkUnsignedCharArray> colors;
    std::vector<unsigned char>
        plain;                 ///< colors without shades; empty where they tell values, which shades would falsify
    std::vector<float> shades; ///< see BodyFrame
    std::shared_ptr<const std::vector<float>> contactShades; ///< see Frame; null: none
    Shading shading = Shading::usual;
    std::optional<EdgeSight> sight; ///< once it was asked for
    bool isClosed = false;          ///< known once there is a sight
    std::vector<bool> seenEdges;    ///< that do not lie behind the body; at first all
    vtkSmartPointer<vtkPlaneCollection> clipping;
    std::vector<std::uint32_t> left; ///< triangles that are not drawn
    std::vector<bool> leftEdges;     ///< those between them
    vtkNew<vtkPolyData> faces;
    vtkNew<vtkPolyData> edges;
    vtkNew<vtkPolyDataMapper> faceMapper;
    vtkNew<vtkPolyDataMapper> edgeMapper;
    vtkNew<vtkActor> faceActor;
    vtkNew<StrokeActor> edgeActor;
};

namespace {

template <class Cell>
void insertCell(vtkCellArray* target, const Cell& cell)
{
    target->InsertNextCell(static_cast<int>(cell.size()));
    for (const std::uint32_t vertex : cell)
        target->InsertCellPoint(vertex);
}

using MeshEdge = std::pair<std::uint32_t, std::uint32_t>; // vertices of the mesh, the lower one first

/// Edges with two of some triangles beside them, ascending. @param triangles of render vertices
std::vector<MeshEdge> edgesWithin(const RenderMesh& mesh, const std::vector<std::uint32_t>& triangles)
{
    std::vector<MeshEdge> all;
    for (const std::uint32_t t : triangles)
        for (std::size_t i = 0; i < 3; ++i)
            all.push_back(
                std::minmax({mesh.source[mesh.triangles[t][i]], mesh.source[mesh.triangles[t][(i + 1) % 3]]}));
    std::ranges::sort(all);
    std::vector<MeshEdge> within;
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i] == all[i - 1])
            within.push_back(all[i]);
    return within;
}

unsigned char byteOf(float channel)
{
    return static_cast<unsigned char>(std::clamp(channel, 0.0F, 1.0F) * 255.0F + 0.5F);
}

} // namespace

SkinActor::SkinActor(std::shared_ptr<const FilledBody> body, vtkRenderer* renderer)
    : m_body(std::move(body))
    , m_parts(std::make_unique<Parts>())
{
    const RenderMesh& mesh = m_body->render;
    const auto count = static_cast<vtkIdType>(mesh.source.size());
    m_parts->renderer = renderer;
    m_parts->points->SetDataTypeToFloat();
    m_parts->points->SetNumberOfPoints(count);
    m_parts->normals->SetNumberOfComponents(3);
    m_parts->normals->SetNumberOfTuples(count);
    m_parts->colors->SetNumberOfComponents(3);
    m_parts->colors->SetNumberOfTuples(count);
    m_parts->colors->Fill(200);

    m_parts->faces->SetPoints(m_parts->points);
    m_parts->faces->GetPointData()->SetNormals(m_parts->normals);
    m_parts->faces->GetPointData()->SetScalars(m_parts->colors);
    m_parts->edges->SetPoints(m_parts->points);
    m_parts->seenEdges.assign(mesh.edges.size(), true);
    leaveOut({});

    m_parts->faceMapper->SetInputData(m_parts->faces);
    m_parts->faceMapper->SetColorModeToDirectScalars();
    // Faces step back a little so that the edges on them are whole.
    m_parts->faceMapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_parts->faceMapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1);
    m_parts->edgeMapper->SetInputData(m_parts->edges);
    m_parts->edgeMapper->ScalarVisibilityOff();
    m_parts->faceActor->SetMapper(m_parts->faceMapper);
    m_parts->edgeActor->SetMapper(m_parts->edgeMapper);

    shadeFaces(*m_parts->faceActor, Shading::usual, MaterialLook::plain);
    m_parts->edgeActor->GetProperty()->LightingOff();
    renderer->AddActor(m_parts->faceActor);
    renderer->AddActor(m_parts->edgeActor);
}

/// Triangles and the edges between them. @param triangles ascending
void SkinActor::leaveOut(const std::vector<std::uint32_t>& triangles)
{
    const RenderMesh& mesh = m_body->render;
    vtkNew<vtkCellArray> faces;
    auto left = triangles.begin();
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        if (left != triangles.end() && *left == t)
            ++left;
        else
            insertCell(faces, mesh.triangles[t]);
    const std::vector<MeshEdge> within = edgesWithin(mesh, triangles);
    m_parts->leftEdges.clear();
    for (const auto& [from, to] : mesh.edges)
        m_parts->leftEdges.push_back(
            std::ranges::binary_search(within, MeshEdge(std::minmax({mesh.source[from], mesh.source[to]}))));
    m_parts->faces->SetPolys(faces);
    m_parts->left = triangles;
    layEdges();
}

SkinActor::~SkinActor()
{
    m_parts->renderer->RemoveActor(m_parts->faceActor);
    m_parts->renderer->RemoveActor(m_parts->edgeActor);
}

void SkinActor::show(const BodyFrame& frame)
{
    vtkDataArray* points = m_parts->points->GetData();
    std::copy(frame.points.begin(), frame.points.end(), static_cast<float*>(points->GetVoidPointer(0)));
    std::copy(frame.normals.begin(), frame.normals.end(), m_parts->normals->GetPointer(0));
    if (m_parts->left != frame.acrossCracks)
        leaveOut(frame.acrossCracks);
    if (m_parts->shades != frame.shades) {
        m_parts->shades = frame.shades;
        showColors();
    }
    points->Modified();
    m_parts->points->Modified();
    m_parts->normals->Modified();
    m_parts->faces->Modified();
    m_parts->edges->Modified();
}

void SkinActor::setContactShades(std::shared_ptr<const std::vector<float>> shades)
{
    if (shades == m_parts->contactShades)
        return;
    m_parts->contactShades = std::move(shades);
    showColors();
}

/// Through glass, and where the body is open, cut or cracked, one sees them all.
void SkinActor::hideEdgesBehind(const Camera& camera)
{
    if (!m_parts->edgeActor->GetVisibility())
        return;
    const bool isSolid = m_parts->faceActor->GetVisibility() && m_parts->faceActor->GetProperty()->GetOpacity() >= 1 &&
                         (!m_parts->clipping || m_parts->clipping->GetNumberOfItems() == 0) && m_parts->left.empty();
    if (isSolid && !m_parts->sight) {
        m_parts->sight.emplace(m_body->render);
        m_parts->isClosed = isWatertight(m_body->mesh);
    }
    if (!isSolid || !m_parts->isClosed) {
        drawEdges(std::vector<bool>(m_parts->seenEdges.size(), true));
        return;
    }
    const auto* points = static_cast<const float*>(m_parts->points->GetData()->GetVoidPointer(0));
    drawEdges(m_parts->sight->seenFrom({points, 3 * m_body->render.source.size()},
                                       camera.perspective ? std::optional(camera.eye()) : std::nullopt,
                                       camera.towardsEye()));
}

void SkinActor::drawEdges(const std::vector<bool>& isSeen)
{
    if (isSeen == m_parts->seenEdges)
        return;
    m_parts->seenEdges = isSeen;
    layEdges();
}

void SkinActor::layEdges()
{
    const auto& all = m_body->render.edges;
    vtkNew<vtkCellArray> lines;
    for (std::size_t e = 0; e < all.size(); ++e)
        if (m_parts->seenEdges[e] && !m_parts->leftEdges[e])
            insertCell(lines, all[e]);
    m_parts->edges->SetLines(lines);
    m_parts->edges->Modified();
}

void SkinActor::setVisible(bool faces, bool edges)
{
    m_parts->faceActor->SetVisibility(faces);
    m_parts->edgeActor->SetVisibility(edges);
}

void SkinActor::setEdges(const Color& color, float width)
{
    m_parts->edgeActor->GetProperty()->SetColor(color.r, color.g, color.b);
    m_parts->edgeActor->setLineWidth(width);
}

void SkinActor::setColors(const std::function<Color(std::uint32_t face)>& colorOf)
{
    std::unordered_map<std::uint32_t, std::array<unsigned char, 3>> bytes;
    m_parts->plain.resize(3 * m_body->render.face.size());
    auto out = m_parts->plain.begin();
    for (const std::uint32_t face : m_body->render.face) {
        const auto [known, isNew] = bytes.try_emplace(face);
        if (isNew) {
            const Color color = colorOf(face);
            known->second = {byteOf(color.r), byteOf(color.g), byteOf(color.b)};
        }
        out = std::copy(known->second.begin(), known->second.end(), out);
    }
    showColors();
}

/// Darker in hollows and beside tools, where the colors are those of the part.
void SkinActor::showColors()
{
    const std::vector<unsigned char>& plain = m_parts->plain;
    const std::vector<float>& shades = m_parts->shades;
    const std::vector<float>* contact = m_parts->contactShades.get();
    const bool hasShades = 3 * shades.size() == plain.size();
    const bool hasContact = contact != nullptr && 3 * contact->size() == plain.size();
    const bool tellsBend = m_parts->shading == Shading::curvature;
    unsigned char* out = m_parts->colors->GetPointer(0);
    for (std::size_t vertex = 0; 3 * vertex < plain.size(); ++vertex) {
        Color share{1, 1, 1};
        if (hasShades)
            share = tellsBend ? curvatureTint(bendOfShade(shades[vertex]))
                              : Color{shades[vertex], shades[vertex], shades[vertex]};
        const float kept = hasContact ? (*contact)[vertex] : 1;
        const float shares[] = {kept * share.r, kept * share.g, kept * share.b};
        for (std::size_t c = 0; c < 3; ++c)
            *out++ = static_cast<unsigned char>(
                std::min(255.0F, static_cast<float>(plain[3 * vertex + c]) * shares[c] + 0.5F));
    }
    m_parts->colors->Modified();
    m_parts->faces->Modified();
}

void SkinActor::setValues(std::span<const float> values, const ColorScale& scale)
{
    m_parts->plain.clear();
    const ColorTable& table = colorTable(scale.map);
    unsigned char* out = m_parts->colors->GetPointer(0);
    for (const std::uint32_t vertex : m_body->render.source) {
        const double share = scale.shareOf(static_cast<double>(values[vertex]));
        const double within = share > 0 ? std::min(share, 1.0) : 0.0; // also of what is no number
        const auto& color = table[static_cast<std::size_t>(std::lround(within * (table.size() - 1)))];
        out = std::copy(color.begin(), color.end(), out);
    }
    m_parts->colors->Modified();
    m_parts->faces->Modified();
}

void SkinActor::tint(double share, const std::function<std::optional<Color>(std::uint32_t face)>& colorOf)
{
    std::unordered_map<std::uint32_t, std::optional<Color>> colors;
    unsigned char* bytes = m_parts->plain.empty() ? m_parts->colors->GetPointer(0) : m_parts->plain.data();
    const auto mix = [share](unsigned char& byte, float to) {
        const float from = static_cast<float>(byte) / 255.0F;
        byte = byteOf(from + static_cast<float>(share) * (to - from));
    };
    for (const std::uint32_t face : m_body->render.face) {
        const auto [known, isNew] = colors.try_emplace(face);
        if (isNew)
            known->second = colorOf(face);
        if (const std::optional<Color>& color = known->second) {
            mix(bytes[0], color->r);
            mix(bytes[1], color->g);
            mix(bytes[2], color->b);
        }
        bytes += 3;
    }
    showColors();
}

void SkinActor::setShading(Shading shading, MaterialLook look)
{
    shadeFaces(*m_parts->faceActor, shading, look);
    m_parts->shading = shading;
}

void SkinActor::setOpacity(double opacity)
{
    m_parts->faceActor->GetProperty()->SetOpacity(opacity);
    m_parts->faceActor->GetProperty()->SetBackfaceCulling(opacity < 1);
}

void SkinActor::setClipping(vtkPlaneCollection* planes)
{
    m_parts->clipping = planes;
    m_parts->faceMapper->SetClippingPlanes(planes);
    m_parts->edgeMapper->SetClippingPlanes(planes);
}

} // namespace knead
