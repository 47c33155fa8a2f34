// How colors of the scene tell what is meant: numbers, what is selected, what is under the cursor, what is fixed.
#include "ui/viewport/scene_view_parts.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace knead {

namespace {

constexpr double tint = 0.65;          // share of a mark in the color of a face
constexpr double selectedTint = 0.8;   // of the selection
constexpr double valuesTint = 0.5;     // of either over colors that stand for numbers
constexpr double selectedScale = 1.06; // of selected objects, so that they cover those that are drawn anyway
constexpr double hoveredScale = 1.1;

Color mix(const Color& a, const Color& b, double share)
{
    const auto s = static_cast<float>(share);
    return {a.r + s * (b.r - a.r), a.g + s * (b.g - a.g), a.b + s * (b.b - a.b)};
}

bool isOfFaces(const Region& region)
{
    return region.level == Level::Face && !region.isEmpty();
}

bool isPart(const Region& region, BodyId body)
{
    return region.level == Level::Part && region.contains(body, 0);
}

/// Whether skins look otherwise.
bool areOthers(const SceneMarks& before, const SceneMarks& after)
{
    const auto isSkin = [](const Region& region) { return region.level == Level::Part || isOfFaces(region); };
    const auto isOther = [&](const Region& a, const Region& b) { return a != b && (isSkin(a) || isSkin(b)); };
    return before.highlighted != after.highlighted || before.fixed != after.fixed ||
           before.isFixing != after.isFixing || before.selectedBody != after.selectedBody ||
           isOther(before.selected, after.selected) || isOther(before.hovered, after.hovered);
}

} // namespace

void SceneView::setMarks(const SceneMarks& marks)
{
    const bool colorsAnew = areOthers(m_marks, marks);
    const bool isOtherSelected = m_marks.selected != marks.selected;
    const bool isOtherHovered = m_marks.hovered != marks.hovered;
    m_marks = marks;
    if (colorsAnew)
        colorBodies();
    if (isOtherSelected)
        showSelectedRegion();
    if (isOtherHovered)
        showHoveredRegion();
    if (m_frame)
        showTools();
}

void SceneView::setSurfaceFields(const SurfaceFieldsPointer& fields)
{
    if (!fields && !m_fields)
        return;
    m_fields = fields;
    m_scale.reset();
    if (fields && fields->request.quantity && fields->request.quantity == m_options.colors.quantity)
        m_scale = colorScale(*fields, m_options.colors, [this](std::size_t body) {
            return !m_options.hiddenParts.contains(m_bodies[body]->part);
        });
    m_parts->fields->setSurfaceFields(fields);
    colorBodies();
    colorRegions();
}

std::optional<ColorScale> SceneView::scale() const
{
    return m_scale;
}

/// @return false: its faces have the colors of the part
bool SceneView::colorByValues(BodyId body)
{
    if (!m_scale || body >= m_fields->values.size() ||
        m_fields->values[body].size() != m_bodies[body]->mesh.vertices.size()) // of what it was before it came apart
        return false;
    m_parts->skins[body]->setValues(m_fields->values[body], *m_scale);
    return true;
}

void SceneView::showRegions()
{
    showSelectedRegion();
    showHoveredRegion();
}

/// In front of all nothing has to stand out from a face.
void SceneView::colorRegions()
{
    m_parts->within->selected.setColor(markOn(m_marks.selected, m_style.selectedEdge, m_style.selectedOther));
    m_parts->within->hovered.setColor(markOn(m_marks.hovered, m_style.highlight, m_style.highlightOther));
    m_parts->inFront->selected.setColor(m_style.selectedEdge);
    m_parts->inFront->hovered.setColor(m_style.highlight);
}

/// May be many thousands of objects: not for every move of the mouse.
void SceneView::showSelectedRegion()
{
    colorRegions();
    showRegion(m_marks.selected, m_parts->within->selected, m_parts->inFront->selected, selectedScale);
}

void SceneView::showHoveredRegion()
{
    colorRegions();
    showRegion(m_marks.hovered, m_parts->within->hovered, m_parts->inFront->hovered, hoveredScale);
}

/// The color in which a region is drawn: around faces, one that stands out from the first of them.
Color SceneView::markOn(const Region& region, const Color& usual, const Color& other) const
{
    if (!isOfFaces(region) || m_scale)
        return usual;
    const auto& [body, faces] = *region.items.begin();
    if (body >= m_bodies.size())
        return usual;
    return standingOut(m_shown.faceColor(*m_model, m_bodies[body]->part, static_cast<std::uint32_t>(faces.front())),
                       usual, other);
}

/// Objects that are hidden by a skin, and connections, which are hidden by objects, are drawn in front of all.
void SceneView::showRegion(const Region& region, RegionActor& within, RegionActor& inFront, double scale)
{
    const bool isAmongObjects = region.level == Level::Object && m_options.objects != ObjectDisplay::Off;
    const bool isWithin = region.level == Level::Edge || region.level == Level::Face || isAmongObjects;
    within.hide();
    inFront.hide();
    if (m_frame)
        (isWithin ? within : inFront).show(shownOf(region), m_bodies, *m_frame, scale);
    m_parts->front->SetDraw(m_parts->inFront->selected.isShown() || m_parts->inFront->hovered.isShown());
}

/// What of a region belongs to parts that are not hidden.
Region SceneView::shownOf(const Region& region) const
{
    Region shown = region;
    std::erase_if(shown.items, [this](const auto& own) {
        return own.first >= m_bodies.size() || m_options.hiddenParts.contains(m_bodies[own.first]->part);
    });
    return shown;
}

/// Of what is selected or under the cursor, a color that stands out from the part.
Color SceneView::edgesOf(BodyId body, bool isSelected, bool isHovered) const
{
    if (!isSelected && !isHovered)
        return m_style.edge;
    const Color& usual = isHovered ? m_style.highlight : m_style.selectedEdge;
    if (m_scale)
        return usual;
    return standingOut(m_shown.partColor(*m_model, m_bodies[body]->part), usual,
                       isHovered ? m_style.highlightOther : m_style.selectedOther);
}

bool SceneView::setMaterials(std::span<const Material> materials)
{
    std::vector<MaterialLook> looks;
    std::transform(materials.begin(), materials.end(), std::back_inserter(looks), materialLook);
    if (!m_model || looks == m_materialLooks)
        return false;
    m_materialLooks = std::move(looks);
    dress();
    return true;
}

MaterialLook SceneView::lookOfBody(BodyId body) const
{
    return body < m_materialLooks.size() ? m_materialLooks[body] : MaterialLook::plain;
}

/// The first body of a part gives it a color, where it has none of its own.
void SceneView::dress()
{
    m_shown = m_appearance;
    for (BodyId b = 0; b < m_bodies.size(); ++b) {
        const std::size_t part = m_bodies[b]->part;
        const std::optional<Color> color = usualColor(lookOfBody(b));
        if (color && !m_shown.chosenColor(part) && !hasOwnColor(m_model->parts[part]))
            m_shown.follow(SetPartLook{static_cast<std::uint32_t>(part), m_shown.chosenName(part), textOf(*color)});
    }
    m_parts->fields->setAppearance(m_shown);
    m_parts->objects.clear();
    colorBodies();
    colorRegions();
    colorSurfaces();
    showObjects();
}

void SceneView::colorBodies()
{
    for (BodyId b = 0; b < m_parts->skins.size(); ++b) {
        const bool isSelected = m_marks.selectedBody == b || isPart(m_marks.selected, b);
        const bool isHovered = isPart(m_marks.hovered, b);
        m_parts->skins[b]->setEdges(edgesOf(b, isSelected, isHovered), isHovered || isSelected ? 1.8F : 1.2F);
        const bool hasValues = colorByValues(b);
        m_parts->skins[b]->setShading(hasValues ? Shading::usual : m_options.shading,
                                      hasValues ? MaterialLook::plain : lookOfBody(b));
        if (hasValues) {
            tintValues(b);
            continue;
        }
        const std::size_t part = m_bodies[b]->part;
        m_parts->skins[b]->setColors([&](std::uint32_t face) {
            const SceneMarks::Face mark{b, face};
            Color color = colorFor(m_options.shading, m_shown.faceColor(*m_model, part, face));
            if (std::count(m_marks.fixed.begin(), m_marks.fixed.end(), mark) > 0)
                color = mix(color, m_style.fixed, tint);
            if (isOfFaces(m_marks.selected) && m_marks.selected.contains(b, face))
                color = mix(color, standingOut(color, m_style.selectedEdge, m_style.selectedOther), selectedTint);
            const bool isUnderCursor =
                m_marks.highlighted == mark || (isOfFaces(m_marks.hovered) && m_marks.hovered.contains(b, face));
            return isUnderCursor ? mix(color, standingOut(color, m_style.highlight, m_style.highlightOther), tint)
                                 : color;
        });
    }
}

/// They have no numbers and no marks.
void SceneView::colorSurfaces()
{
    for (std::size_t s = 0; s < m_surfaces.size(); ++s) {
        const std::size_t part = m_surfaces[s]->body->part;
        m_parts->surfaces[s]->setEdges(m_style.edge, 1.2F);
        m_parts->surfaces[s]->setShading(m_options.shading, MaterialLook::plain);
        m_parts->surfaces[s]->setColors(
            [&](std::uint32_t face) { return colorFor(m_options.shading, m_shown.faceColor(*m_model, part, face)); });
    }
}

/// What is selected or under the cursor is seen over numbers too. Fixed faces keep theirs, as stress is highest there, but
/// while they are chosen.
void SceneView::tintValues(BodyId body)
{
    const auto isFace = [body](const Region& region) { return isOfFaces(region) && region.items.contains(body); };
    const bool isHighlighted = m_marks.highlighted && m_marks.highlighted->body == body;
    const bool showsFixed = m_marks.isFixing && !m_marks.fixed.empty();
    if (!showsFixed && !isHighlighted && !isFace(m_marks.selected) && !isFace(m_marks.hovered))
        return;
    m_parts->skins[body]->tint(valuesTint, [&](std::uint32_t face) -> std::optional<Color> {
        if (m_marks.highlighted == SceneMarks::Face{body, face} ||
            (isFace(m_marks.hovered) && m_marks.hovered.contains(body, face)))
            return m_style.highlight;
        if (isFace(m_marks.selected) && m_marks.selected.contains(body, face))
            return m_style.selectedEdge;
        if (showsFixed && std::count(m_marks.fixed.begin(), m_marks.fixed.end(), SceneMarks::Face{body, face}) > 0)
            return m_style.fixed;
        return std::nullopt;
    });
}

} // namespace knead
