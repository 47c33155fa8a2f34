#include "ui/viewport/surface_field_actors.h"

#include "ui/viewport/cap_actor.h"
#include "ui/viewport/connection_actor.h"
#include "ui/viewport/skin_actor.h"

#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <utility>

namespace knead {

namespace {

constexpr double ghostOpacity = 0.28;
constexpr float edgeWidth = 1.2F;
constexpr float connectionShade = 0.8F;    // of the color of the body
constexpr double hatchingShare = 1.0 / 45; // between lines, in sizes of the content

using Skins = std::vector<std::unique_ptr<SkinActor>>;

/// The shape at rest.
BodyFrame originalOf(const FilledBody& body)
{
    BodyFrame frame{.places = body.mesh.vertices, .points = {}, .normals = {}};
    frame.points = renderPoints(body.render, frame.places);
    frame.normals = renderNormals(body.render, frame.points);
    return frame;
}

Skins originalsOf(const FilledBodies& bodies, vtkRenderer* renderer)
{
    Skins skins;
    for (const auto& body : bodies) {
        skins.push_back(std::make_unique<SkinActor>(body, renderer));
        skins.back()->show(originalOf(*body));
    }
    return skins;
}

void place(vtkPlane* plane, const Vec3& origin, const Vec3& kept)
{
    plane->SetOrigin(origin.data());
    plane->SetNormal(kept.data());
}

} // namespace

struct SurfaceFieldActors::Parts {
    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkPlane> section; ///< all planes keep what is on the side of their normal
    vtkNew<vtkPlane> right;   ///< of the divider
    vtkNew<vtkPlane> left;
    vtkNew<vtkPlaneCollection> ofStill;
    vtkNew<vtkPlaneCollection> ofDeformed;
    vtkNew<vtkPlaneCollection> ofOriginal;     ///< left of the divider
    vtkNew<vtkPlaneCollection> ofDeformedCaps; ///< they lie in the section plane
    vtkNew<vtkPlaneCollection> ofOriginalCaps;
    Skins ghosts;                                              ///< beside the deformed; empty while they are not shown
    Skins originals;                                           ///< left of the divider; likewise
    std::vector<std::unique_ptr<ConnectionActor>> connections; ///< likewise
    std::vector<std::shared_ptr<const std::vector<BrokenConnection>>> brokenSeen; ///< by those
    std::unique_ptr<BreakActor> breaks;                                           ///< null while they are not shown
    std::vector<std::unique_ptr<CapActor>> caps; ///< per body: of the deformed, then of the original ones
    std::unique_ptr<PlaneFrameActor> frame;
};

SurfaceFieldActors::SurfaceFieldActors(vtkRenderer* renderer)
    : m_parts(std::make_unique<Parts>())
{
    m_parts->renderer = renderer;
    m_parts->frame = std::make_unique<PlaneFrameActor>(renderer);
    m_parts->frame->setVisible(false);
}

SurfaceFieldActors::~SurfaceFieldActors() = default;

vtkPlaneCollection* SurfaceFieldActors::clipping() const
{
    return m_parts->ofDeformed;
}

vtkPlaneCollection* SurfaceFieldActors::clippingOfStill() const
{
    return m_parts->ofStill;
}

bool SurfaceFieldActors::isShown(std::size_t body) const
{
    return !m_options.hiddenParts.contains(m_bodies[body]->part);
}

void SurfaceFieldActors::setModel(const FilledModel& content)
{
    m_model = content.model;
    m_bodies = content.bodies;
    m_box = content.box;
    m_frame = nullptr;
    m_fields = nullptr;
    m_parts->ghosts.clear();
    m_parts->originals.clear();
    m_parts->connections.clear();
    m_parts->breaks.reset();
    m_parts->caps.clear();
}

void SurfaceFieldActors::setBodies(const FilledBodies& bodies)
{
    m_bodies = bodies;
    m_parts->connections.clear();
    m_parts->breaks.reset();
}

void SurfaceFieldActors::showFrame(const FramePointer& frame)
{
    m_frame = frame;
    showConnections();
    showBreaks();
}

void SurfaceFieldActors::setStyle(const SceneStyle& style)
{
    m_style = style;
    m_parts->frame->setColor(style.highlight);
    m_parts->ghosts.clear();
    m_parts->originals.clear();
    showOriginals();
    showBreaks();
    showCaps();
}

void SurfaceFieldActors::setAppearance(const PartAppearance& looks)
{
    m_appearance = looks;
    m_parts->originals.clear();
    m_parts->connections.clear();
    showOriginals();
    showConnections();
    showCaps();
}

void SurfaceFieldActors::setOptions(const SceneOptions& options)
{
    const bool othersJoined = options.connections != m_options.connections || options.objects != m_options.objects ||
                              options.hiddenParts != m_options.hiddenParts;
    m_options = options;
    if (othersJoined)
        m_parts->connections.clear();
    clip();
    showOriginals();
    showConnections();
    showBreaks();
    showCaps();
}

void SurfaceFieldActors::setCut(const SceneOptions& options)
{
    m_options.section = options.section;
    m_options.divider = options.divider;
    clip();
    showCaps();
}

void SurfaceFieldActors::setSurfaceFields(const SurfaceFieldsPointer& fields)
{
    m_fields = fields;
    showCaps();
}

void SurfaceFieldActors::showOriginals()
{
    Skins& ghosts = m_parts->ghosts;
    Skins& originals = m_parts->originals;
    if (!m_options.original)
        ghosts.clear();
    else if (ghosts.empty()) {
        ghosts = originalsOf(m_bodies, m_parts->renderer);
        for (const auto& ghost : ghosts) {
            ghost->setOpacity(ghostOpacity);
            ghost->setEdges(m_style.highlight, edgeWidth);
            ghost->setColors([this](std::uint32_t) { return m_style.highlight; });
            ghost->setClipping(m_parts->ofDeformed);
        }
    }
    if (!m_options.divider)
        originals.clear();
    else if (originals.empty()) {
        originals = originalsOf(m_bodies, m_parts->renderer);
        for (std::size_t b = 0; b < m_bodies.size(); ++b) {
            originals[b]->setEdges(m_style.edge, edgeWidth);
            originals[b]->setColors(
                [&](std::uint32_t face) { return m_appearance.faceColor(*m_model, m_bodies[b]->part, face); });
            originals[b]->setClipping(m_parts->ofOriginal);
        }
    }
    for (std::size_t b = 0; b < ghosts.size(); ++b)
        ghosts[b]->setVisible(isShown(b), isShown(b) && m_options.edges);
    for (std::size_t b = 0; b < originals.size(); ++b)
        originals[b]->setVisible(isShown(b), isShown(b) && m_options.edges);
}

void SurfaceFieldActors::showConnections()
{
    auto& actors = m_parts->connections;
    if (!m_options.connections || !m_frame) {
        actors.clear();
        return;
    }
    if (actors.empty()) {
        m_parts->brokenSeen.assign(m_bodies.size(), nullptr);
        actors.resize(m_bodies.size());
    }
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        if (!isShown(b))
            continue;
        const Snapshot::BodyState& now = m_frame->snapshot->bodies[b];
        const bool isNew = !actors[b];
        if (isNew) {
            const Color color = m_appearance.partColor(*m_model, m_bodies[b]->part);
            actors[b] = std::make_unique<ConnectionActor>(
                m_parts->renderer,
                Color{connectionShade * color.r, connectionShade * color.g, connectionShade * color.b});
            actors[b]->setClipping(m_parts->ofDeformed);
        }
        if (std::exchange(m_parts->brokenSeen[b], now.broken) != now.broken || isNew)
            actors[b]->setConnections(
                *m_bodies[b]->aggregate, now.broken ? std::span(*now.broken) : std::span<const BrokenConnection>(),
                m_options.objects == ObjectDisplay::All ? std::span<const ObjectIndex>() : m_bodies[b]->surfaceObjects);
        actors[b]->show(now.positions);
    }
}

void SurfaceFieldActors::showBreaks()
{
    if (!m_options.breaks || !m_frame) {
        m_parts->breaks.reset();
        return;
    }
    std::vector<Vec3> marks;
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const Snapshot::BodyState& now = m_frame->snapshot->bodies[b];
        if (!now.broken || !isShown(b))
            continue;
        const std::vector<Vec3> own = breakMarks(*m_bodies[b]->aggregate, now.positions, *now.broken);
        marks.insert(marks.end(), own.begin(), own.end());
    }
    if (!m_parts->breaks) {
        m_parts->breaks = std::make_unique<BreakActor>(m_parts->renderer);
        m_parts->breaks->setClipping(m_parts->ofDeformed);
    }
    m_parts->breaks->setColor(m_style.force);
    m_parts->breaks->show(marks);
}

/// Caps stay until those of the plane of now are there, so that nothing flickers while it is dragged.
void SurfaceFieldActors::showCaps()
{
    const std::optional<CutPlane>& plane = m_options.section.plane;
    m_parts->frame->setVisible(plane.has_value() && !m_bodies.empty() && m_options.section.hasFrame);
    if (plane)
        m_parts->frame->show(*plane, m_box);
    const bool isReady = plane && m_fields && m_fields->request.section == plane;
    if (!isReady && !plane)
        m_parts->caps.clear();
    if (!isReady)
        return;
    if (m_parts->caps.empty())
        for (std::size_t i = 0; i < 2 * m_bodies.size(); ++i)
            m_parts->caps.push_back(std::make_unique<CapActor>(m_parts->renderer));
    const double hatching = hatchingShare * m_box.sizes().maxCoeff();
    for (std::size_t i = 0; i < m_parts->caps.size(); ++i) {
        const std::size_t b = i % m_bodies.size();
        const bool isOriginal = i >= m_bodies.size();
        const std::vector<PlaneSection>& sections = isOriginal ? m_fields->originalCaps : m_fields->caps;
        CapActor& cap = *m_parts->caps[i];
        const bool isVisible = isShown(b) && !sections.empty() && (!isOriginal || m_options.divider);
        cap.setVisible(isVisible);
        if (!isVisible)
            continue;
        cap.show(sections[b], *plane, hatching);
        cap.setLook(m_appearance.partColor(*m_model, m_bodies[b]->part), m_style.edge, m_options.section.isHatched);
        cap.setClipping(isOriginal ? m_parts->ofOriginalCaps : m_parts->ofDeformedCaps);
    }
}

/// Planes are made part of the lists here, and placed here and in setCamera().
void SurfaceFieldActors::clip()
{
    Parts& p = *m_parts;
    for (vtkPlaneCollection* list :
         {p.ofStill.Get(), p.ofDeformed.Get(), p.ofOriginal.Get(), p.ofDeformedCaps.Get(), p.ofOriginalCaps.Get()})
        list->RemoveAllItems();
    if (const std::optional<CutPlane>& plane = m_options.section.plane) {
        place(p.section, plane->offset * plane->normal, -plane->normal);
        p.ofStill->AddItem(p.section);
        p.ofDeformed->AddItem(p.section);
        p.ofOriginal->AddItem(p.section);
    }
    if (!m_options.divider)
        return;
    for (vtkPlaneCollection* list : {p.ofDeformed.Get(), p.ofDeformedCaps.Get()})
        list->AddItem(p.right);
    for (vtkPlaneCollection* list : {p.ofOriginal.Get(), p.ofOriginalCaps.Get()})
        list->AddItem(p.left);
}

/// The divider is a plane through the eye and a vertical line of the view.
void SurfaceFieldActors::setCamera(const Camera& camera, double aspect)
{
    if (!m_options.divider)
        return;
    const double aside = (2 * *m_options.divider - 1) * camera.viewHeight() / 2 * aspect;
    const Vec3 foot = camera.target + aside * camera.right();
    const Vec3 fields = camera.perspective ? Vec3(foot - camera.eye()) : Vec3(-camera.towardsEye());
    const Vec3 right = fields.cross(camera.up()).normalized();
    place(m_parts->right, foot, right);
    place(m_parts->left, foot, -right);
}

} // namespace knead
