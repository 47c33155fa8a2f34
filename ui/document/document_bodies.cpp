// What is done to the selected body, or to all of them.
#include "ui/document/document.h"

#include "ui/selection/selection_model.h"

namespace knead {

void Document::renormalize()
{
    if (later([this] { renormalize(); }))
        return;
    if (m_selection.kind == Selection::Kind::Region) {
        renormalizeRegion(m_selected->region());
        return;
    }
    for (BodyId body = 0; body < m_content->bodies.size(); ++body) {
        const bool isMeant = m_selection.kind != Selection::Kind::Body || m_selection.id == body;
        if (isMeant && m_frame->snapshot->bodies[body].kind == BodyKind::deformable)
            post(Renormalize{.body = body});
    }
}

void Document::refillNow()
{
    if (later([this] { refillNow(); }))
        return;
    bool isAny = false;
    for (BodyId body = 0; body < m_content->bodies.size(); ++body) {
        const bool isSelected = m_selection.kind == Selection::Kind::Body && m_selection.id == body;
        const bool isMeant =
            isSelected || (m_selection.kind != Selection::Kind::Body && m_frame->snapshot->materials[body].yields());
        if (isMeant)
            post(Refill{.body = body});
        isAny = isAny || isMeant;
    }
    if (!isAny)
        emit notice(
            tr("No body is of material that yields: elastic ones keep their shape at rest, and are not filled anew."));
}

void Document::cutAlong(const Vec3& point, const Vec3& normal)
{
    if (later([this, point, normal] { cutAlong(point, normal); }))
        return;
    for (BodyId body = 0; body < m_content->bodies.size(); ++body) {
        const bool isSelected = m_selection.kind == Selection::Kind::Body && m_selection.id == body;
        const bool isMeant =
            m_selection.kind != Selection::Kind::Body && m_frame->snapshot->bodies[body].kind == BodyKind::deformable;
        if (isSelected || isMeant)
            post(Cut{.body = body, .point = point, .normal = normal});
    }
}

} // namespace knead
