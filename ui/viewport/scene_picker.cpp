#include "ui/viewport/scene_picker.h"

#include <limits>

namespace knead {

void ScenePicker::forget()
{
    m_pickers.clear();
    m_bodies.clear();
    m_frame = nullptr;
}

void ScenePicker::follow()
{
    const FramePointer& frame = m_document.frame();
    if (frame == m_frame || m_document.isEmpty())
        return;
    const bool isNew = m_pickers.empty();
    if (isNew) {
        m_bodies = frame->filled;
        m_pickers.resize(m_bodies.size());
    }
    for (std::size_t b = 0; b < m_pickers.size(); ++b) {
        if (!isNew && haveSameSurface(*m_bodies[b], *frame->filled[b])) {
            m_pickers[b]->refit(frame->bodies[b]->points);
            continue;
        }
        m_bodies[b] = frame->filled[b];
        m_pickers[b] = std::make_unique<SurfacePicker>(m_bodies[b]->render, frame->bodies[b]->points);
    }
    m_frame = frame;
}

PickHit ScenePicker::pick(const Ray& ray, bool skipsTools)
{
    follow();
    return pickNow(ray, skipsTools);
}

PickHit ScenePicker::pickNow(const Ray& ray, bool skipsTools) const
{
    PickHit hit;
    if (m_document.isEmpty())
        return hit;
    const RayReach reach = reachOf(ray, m_cut);
    double nearest = std::numeric_limits<double>::max();
    for (std::uint32_t b = 0; b < m_pickers.size(); ++b)
        if (const auto found =
                m_hiddenParts.contains(m_bodies[b]->part) ? std::nullopt : m_pickers[b]->pick(ray, reach);
            found && found->distance < nearest) {
            nearest = found->distance;
            hit = {found->isCut ? PickHit::Kind::Cut : PickHit::Kind::Body, b, found->triangle, found->face,
                   ray.origin + nearest * ray.direction};
        }
    if (skipsTools)
        return hit;
    for (const ToolState& tool : m_frame->snapshot->tools)
        if (const auto distance = pickTool(ray, {tool.kind, tool.size, tool.part}, tool.pose);
            distance && *distance < nearest) {
            nearest = *distance;
            hit = {PickHit::Kind::Tool, tool.id, 0, 0, ray.origin + nearest * ray.direction};
        }
    return hit;
}

} // namespace knead
