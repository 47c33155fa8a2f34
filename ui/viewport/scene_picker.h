#pragma once

#include "ui/document/document.h"
#include "ui/viewport/picker.h"

#include <memory>
#include <set>
#include <vector>

namespace knead {

/// What lies under the cursor.
struct PickHit {
    enum class Kind { Nothing, Body, Tool, Cut }; ///< cut: where a section plane opens a body; there is no face
    Kind kind = Kind::Nothing;
    std::uint32_t id = 0;       ///< BodyId or ToolId
    std::uint32_t triangle = 0; ///< of FilledBody::mesh
    std::uint32_t face = 0;     ///< CAD face
    Vec3 place = Vec3::Zero();  ///< [m]
};

/// Picks bodies and tools of a document as they are drawn now. Follows deformation only when asked, so that an idle
/// mouse costs nothing.
class ScenePicker {
public:
    explicit ScenePicker(const Document& document)
        : m_document(document)
    {
    }

    /// The document shows another content.
    void forget();
    /// Parts that nobody sees, by index into Model::parts, are not picked.
    void hide(const std::set<std::size_t>& parts) { m_hiddenParts = parts; }
    /// Nor is what a section plane takes away.
    void cut(const std::optional<CutPlane>& plane) { m_cut = plane; }

    /// The nearest thing. @param skipsTools looks through tools at the bodies
    PickHit pick(const Ray& ray, bool skipsTools = false);

    /// Makes ready for pickNow(): bodies are where the document's frame has them.
    void follow();
    /// As pick(), where they were when follow() was called last. Any thread, and several at a time.
    PickHit pickNow(const Ray& ray, bool skipsTools = false) const;

private:
    const Document& m_document;
    FramePointer m_frame; ///< the trees fit to this one
    FilledBodies m_bodies;
    std::set<std::size_t> m_hiddenParts;
    std::optional<CutPlane> m_cut;
    std::vector<std::unique_ptr<SurfacePicker>> m_pickers;
};

} // namespace knead
