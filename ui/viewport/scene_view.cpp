#include "ui/viewport/picker.h"
#include "ui/viewport/scene_view_parts.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <map>
#include <utility>

namespace knead {

namespace {

constexpr double arrowLength = 0.28; // of the largest force, in sizes of the part
constexpr double objectRadius = 0.5; // in spacings
constexpr double glassOpacity = 0.3; // of a skin through which one sees what is inside

} // namespace

SceneView::SceneView(vtkRenderWindow* window)
    : m_parts(std::make_unique<Parts>())
    , m_style(lightScene())
{
    m_parts->renderer->GradientBackgroundOn();
    m_parts->renderer->SetLayer(0);
    addLights();
    window->SetNumberOfLayers(3);
    m_parts->front->SetLayer(1);
    m_parts->front->InteractiveOff();
    m_parts->front->SetActiveCamera(m_parts->renderer->GetActiveCamera());
    m_parts->front->DrawOff();
    window->AddRenderer(m_parts->renderer);
    window->AddRenderer(m_parts->front);
    m_parts->within = std::make_unique<Parts::Regions>(m_parts->renderer);
    m_parts->inFront = std::make_unique<Parts::Regions>(m_parts->front);
    m_parts->cube = std::make_unique<ViewCube>(window);
    m_parts->grid = std::make_unique<GridActor>(m_parts->renderer);
    m_parts->grid->setVisible(false);
    m_parts->shadow = std::make_unique<GroundShadowActor>(m_parts->renderer);
    m_parts->shadow->setVisible(false);
    m_parts->openEdges = std::make_unique<OpenEdgesActor>(m_parts->renderer);
    m_parts->fields = std::make_unique<SurfaceFieldActors>(m_parts->renderer);
    m_parts->openEdges->setClipping(m_parts->fields->clippingOfStill());
    setStyle(m_style);
}

SceneView::~SceneView() = default;

/// A key light over the left shoulder and a weaker one from the right below; both turn with the camera.
void SceneView::addLights()
{
    const struct {
        double x, y, z, intensity;
    } lights[] = {{-0.45, 0.7, 1.0, 0.86}, {0.9, -0.2, 0.7, 0.5}};
    m_parts->renderer->AutomaticLightCreationOff();
    for (const auto& setting : lights) {
        vtkNew<vtkLight> light;
        light->SetLightTypeToCameraLight();
        light->SetPosition(setting.x, setting.y, setting.z);
        light->SetFocalPoint(0, 0, 0);
        light->SetIntensity(setting.intensity);
        m_parts->renderer->AddLight(light);
    }
}

void SceneView::setModel(const FilledModel& content)
{
    m_model = content.model;
    m_bodies = content.bodies;
    m_surfaces = content.surfaces;
    m_restBox = content.box;
    m_frame = nullptr;
    m_hasOptions = false;
    m_marks = {};
    m_fields = nullptr;
    m_scale.reset();
    m_materialLooks.clear();
    m_shown = m_appearance;
    m_parts->fields->setModel(content);
    m_parts->skins.clear();
    m_parts->surfaces.clear();
    m_parts->objects.clear();
    m_parts->tools.clear();
    for (const auto& body : m_bodies)
        m_parts->skins.push_back(std::make_unique<SkinActor>(body, m_parts->renderer));
    for (const auto& surface : m_surfaces) {
        m_parts->surfaces.push_back(std::make_unique<SkinActor>(surface->body, m_parts->renderer));
        m_parts->surfaces.back()->show(surface->frame);
    }
    for (const auto& skin : m_parts->skins)
        skin->setClipping(m_parts->fields->clipping());
    for (const auto& surface : m_parts->surfaces)
        surface->setClipping(m_parts->fields->clippingOfStill());
    for (Parts::Regions* regions : {m_parts->within.get(), m_parts->inFront.get()})
        for (RegionActor* actor : {&regions->selected, &regions->hovered})
            actor->setClipping(m_parts->fields->clipping());
    m_gridHeight = m_restBox.min().z();
    layGrid();
    colorBodies();
    colorSurfaces();
    showBodies();
    showOpenEdges();
}

void SceneView::showFrame(const FramePointer& frame)
{
    const bool hasMoved = !m_frame || m_frame->bodies != frame->bodies;
    m_frame = frame;
    if (m_bodies != frame->filled) {
        const FilledBodies before = std::exchange(m_bodies, frame->filled);
        m_parts->objects.clear();
        m_parts->fields->setBodies(m_bodies);
        takeSurfaces(before);
    }
    if (hasMoved) {
        for (std::size_t b = 0; b < m_bodies.size(); ++b)
            m_parts->skins[b]->show(*frame->bodies[b]);
        showObjects();
        showRegions();
    }
    for (std::size_t b = 0; b < frame->contactShades.size(); ++b)
        m_parts->skins[b]->setContactShades(frame->contactShades[b]);
    m_parts->fields->showFrame(frame);
    showTools();
    m_isShadowNew = true;
    const double height = frame->snapshot->floorHeight.value_or(m_restBox.min().z());
    if (height != m_gridHeight) {
        m_gridHeight = height;
        layGrid();
    }
}

/// Of bodies that came apart, or are whole again.
void SceneView::takeSurfaces(const FilledBodies& before)
{
    bool isAny = false;
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        if (haveSameSurface(*before[b], *m_bodies[b]))
            continue;
        m_parts->skins[b] = std::make_unique<SkinActor>(m_bodies[b], m_parts->renderer);
        m_parts->skins[b]->setClipping(m_parts->fields->clipping());
        m_parts->skins[b]->show(*m_frame->bodies[b]);
        isAny = true;
    }
    if (!isAny)
        return;
    colorBodies();
    showBodies();
}

void SceneView::setStyle(const SceneStyle& style)
{
    m_style = style;
    m_parts->renderer->SetBackground(style.bottom.r, style.bottom.g, style.bottom.b);
    m_parts->renderer->SetBackground2(style.top.r, style.top.g, style.top.b);
    m_parts->cube->setStyle(style);
    m_parts->openEdges->setColor(style.openEdge);
    m_parts->fields->setStyle(style);
    layGrid();
    colorBodies();
    colorRegions();
    colorSurfaces();
    if (m_frame)
        showTools();
}

/// While a plane is dragged, many times a second, only what is cut is shown anew, and the shadow of what is left: laying the grid,
/// which took most of such a step, and all that is drawn in it stay.
void SceneView::setOptions(const SceneOptions& options)
{
    if (std::exchange(m_hasOptions, true) && isOnlyCutElsewhere(m_options, options)) {
        m_isShadowNew = m_isShadowNew || options.section.plane != m_options.section.plane;
        m_options = options;
        m_parts->fields->setCut(options);
        return;
    }
    const bool otherObjects = options.objects != m_options.objects || options.hiddenParts != m_options.hiddenParts;
    const bool otherParts = options.hiddenParts != m_options.hiddenParts;
    const bool isShadedAnew = options.shading != m_options.shading;
    const bool otherColors = options.colors != m_options.colors || otherParts;
    m_options = options;
    if (otherObjects)
        m_parts->objects.clear();
    if (otherParts)
        showOpenEdges();
    m_parts->fields->setOptions(options);
    showBodies();
    showObjects();
    showRegions();
    layGrid();
    if (otherColors)
        setSurfaceFields(m_fields);
    if (isShadedAnew) {
        colorBodies();
        colorSurfaces();
    }
    if (m_frame)
        showTools();
}

bool SceneView::isGlass() const
{
    return m_options.objects != ObjectDisplay::Off || m_options.connections;
}

void SceneView::setAppearance(const PartAppearance& looks)
{
    m_appearance = looks;
    dress();
}

void SceneView::showBodies()
{
    for (BodyId b = 0; b < m_parts->skins.size(); ++b) {
        const bool isVisible = !m_options.hiddenParts.contains(m_bodies[b]->part);
        m_parts->skins[b]->setVisible(isVisible && m_options.skin, isVisible && m_options.skin && m_options.edges);
        m_parts->skins[b]->setOpacity(isGlass() ? glassOpacity : 1);
    }
    for (std::size_t s = 0; s < m_surfaces.size(); ++s) {
        const bool isVisible = !m_options.hiddenParts.contains(m_surfaces[s]->body->part);
        m_parts->surfaces[s]->setVisible(isVisible, isVisible && m_options.edges);
    }
    m_parts->openEdges->setVisible(m_model && m_options.openEdges);
}

void SceneView::showOpenEdges()
{
    if (m_model)
        m_parts->openEdges->show(*m_model, [this](std::size_t part) { return m_options.hiddenParts.contains(part); });
}

void SceneView::showObjects()
{
    if (m_options.objects == ObjectDisplay::Off || !m_frame)
        return;
    if (m_parts->objects.empty())
        for (const auto& body : m_bodies)
            m_parts->objects.push_back(std::make_unique<ObjectActor>(m_parts->renderer,
                                                                     m_shown.partColor(*m_model, body->part),
                                                                     objectRadius * body->aggregate->lattice.spacing));
    for (const auto& objects : m_parts->objects)
        objects->setClipping(m_parts->fields->clipping());
    for (BodyId b = 0; b < m_bodies.size(); ++b) {
        if (m_options.hiddenParts.contains(m_bodies[b]->part))
            continue;
        const bool areAll = m_options.objects == ObjectDisplay::All;
        m_parts->objects[b]->show(m_frame->snapshot->bodies[b].positions,
                                  areAll ? std::span<const ObjectIndex>() : m_bodies[b]->surfaceObjects);
    }
}

void SceneView::showTools()
{
    std::map<ToolId, std::unique_ptr<ToolActor>> kept;
    for (const ToolState& tool : m_frame->snapshot->tools) {
        std::unique_ptr<ToolActor> actor = std::move(m_parts->tools[tool.id]);
        if (!actor)
            actor = std::make_unique<ToolActor>(m_parts->renderer);
        actor->setStyle(m_style, m_marks.selectedTool == tool.id, m_marks.hoveredTool == tool.id);
        actor->show(tool, m_options.forces ? arrowLength * m_restBox.sizes().maxCoeff() : 0);
        kept[tool.id] = std::move(actor);
    }
    m_parts->tools = std::move(kept);
}

void SceneView::layGrid()
{
    m_parts->grid->setVisible(m_options.grid && m_model);
    if (m_model)
        m_parts->grid->lay(m_restBox, m_gridHeight, m_style.grid);
    m_parts->shadow->setVisible(m_options.grid && m_model);
    m_isShadowNew = true;
}

/// Before a drawing, where something has moved since.
void SceneView::layShadow()
{
    if (!m_options.grid || !m_model || !std::exchange(m_isShadowNew, false))
        return;
    std::vector<ShadowCaster> casters;
    const auto isSeen = [this](const FilledBody& body) { return !m_options.hiddenParts.contains(body.part); };
    if (m_frame)
        for (BodyId b = 0; b < m_bodies.size(); ++b)
            if (isSeen(*m_bodies[b]))
                casters.push_back({m_bodies[b]->render.triangles, m_frame->bodies[b]->points});
    for (const auto& surface : m_surfaces)
        if (isSeen(*surface->body))
            casters.push_back({surface->body->render.triangles, surface->frame.points});
    std::vector<ShadowProbe> probes;
    if (m_frame)
        for (const ToolState& tool : m_frame->snapshot->tools) {
            const Vec3 reach = Vec3::Constant(0.5 * tool.size.norm());
            probes.push_back({Box(tool.pose.position - reach, tool.pose.position + reach), [&tool](const Vec3& place) {
                                  const Ray up{place, Vec3::UnitZ()};
                                  return pickTool(up, {tool.kind, tool.size, tool.part}, tool.pose).value_or(-1);
                              }});
        }
    m_parts->shadow->lay(groundShadow(casters, probes, m_gridHeight, m_options.section.plane), m_gridHeight);
}

void SceneView::setCamera(const Camera& camera)
{
    m_camera = camera;
    layShadow();
    const bool isBelow = camera.perspective ? camera.eye().z() < m_gridHeight : camera.towardsEye().z() < 0;
    m_parts->shadow->comeLast(isBelow);
    m_parts->grid->comeLast(isBelow);
    vtkCamera* eye = m_parts->renderer->GetActiveCamera();
    eye->SetPosition(camera.eye().data());
    eye->SetFocalPoint(camera.target.data());
    eye->SetViewUp(camera.up().data());
    eye->SetViewAngle(Camera::viewAngle);
    eye->SetParallelProjection(!camera.perspective);
    eye->SetParallelScale(camera.viewHeight() / 2);
    m_parts->cube->setCamera(camera);
    const int* size = m_parts->renderer->GetRenderWindow()->GetSize();
    for (const auto& skin : m_parts->skins)
        skin->hideEdgesBehind(camera);
    m_parts->fields->setCamera(camera, static_cast<double>(size[0]) / std::max(1, size[1]));
    clipToScene();
}

/// Keeps the depth buffer for what there is to see, ground included.
void SceneView::clipToScene()
{
    Box all = box();
    if (all.isEmpty())
        return;
    const double reach = 5 * m_restBox.sizes().maxCoeff();
    all.extend(Vec3(m_restBox.center() + Vec3(reach, reach, 0)));
    all.extend(Vec3(m_restBox.center() - Vec3(reach, reach, 0)));
    const double depth = (m_camera.eye() - all.center()).dot(m_camera.towardsEye());
    const double radius = all.diagonal().norm() / 2;
    // A parallel view has nothing behind the eye to protect.
    const double nearest = m_camera.perspective ? std::max(depth - radius, 0.01 * m_camera.distance) : depth - radius;
    m_parts->renderer->GetActiveCamera()->SetClippingRange(nearest, depth + radius);
}

bool isOnlyCutElsewhere(const SceneOptions& before, const SceneOptions& after)
{
    if (before.section.plane.has_value() != after.section.plane.has_value() ||
        before.divider.has_value() != after.divider.has_value())
        return false;
    SceneOptions moved = before;
    moved.section.plane = after.section.plane;
    moved.divider = after.divider;
    return before != after && moved == after;
}

SurfaceFieldsRequest requestOf(const SceneOptions& options)
{
    return {.quantity = options.colors.quantity,
            .section = options.section.plane,
            .capsOriginal = options.section.plane && options.divider};
}

ViewCube& SceneView::cube()
{
    return *m_parts->cube;
}

Box SceneView::box() const
{
    Box box = m_restBox;
    if (!m_frame)
        return box;
    for (const auto& body : m_frame->bodies)
        for (const Vec3& place : body->places)
            box.extend(place);
    for (const ToolState& tool : m_frame->snapshot->tools)
        for (const double side : {-0.5, 0.5})
            box.extend(
                Vec3(tool.pose.position + side * (tool.pose.rotation.toRotationMatrix().cwiseAbs() * tool.size)));
    return box;
}

std::vector<SceneLabel> SceneView::labels() const
{
    std::vector<SceneLabel> labels;
    if (m_frame && m_options.forces)
        for (const ToolState& tool : m_frame->snapshot->tools)
            labels.push_back(
                {m_parts->tools.at(tool.id)->labelPlace(), tool.id, tool.force.norm(), tool.pose.position});
    return labels;
}

} // namespace knead
