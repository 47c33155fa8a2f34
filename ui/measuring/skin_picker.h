#pragma once

#include "core/session/skin_place.h"
#include "ui/viewport/camera.h"
#include "ui/viewport/picker.h"

#include <QPointF>

#include <memory>
#include <vector>

namespace knead {

class Document;
class ViewportWidget;

/// What of the skin lies under the cursor, as the view draws it: hidden parts and what the section plane cuts off do not count, and
/// the past is picked in while one looks back. Corners of CAD faces attract.
class SkinPicker {
public:
    SkinPicker(const Document& document, const ViewportWidget& view)
        : m_document(document)
        , m_view(view)
    {
    }

    struct Hit {
        SkinPlace place;
        Vec3 at = Vec3::Zero(); ///< [m]
        bool isCorner = false;
        bool isCut = false; ///< where the section plane cuts a body: no place of the skin
    };
    /// From where, and of how large a window, one looks.
    struct Eye {
        Camera camera;
        WindowSize window;
    };
    /// The nearest place. @param snaps to a corner close by
    std::optional<Hit> pick(const Eye& eye, const QPointF& position, bool snaps);

    /// The document shows another content.
    void forget();

private:
    struct Corner {
        std::uint32_t vertex = 0;
        SkinPlace place;
    };
    struct Body {
        std::unique_ptr<SurfacePicker> picker;
        std::vector<Corner> corners;
    };

    void follow();
    bool isHidden(std::size_t body) const;
    std::optional<Hit> surfaceAlong(const Ray& ray) const;
    std::optional<Hit> cornerNear(const Eye& eye, const QPointF& position) const;
    static std::vector<Corner> cornersOf(BodyId id, const FilledBody& body, const FilledModel& content);

    const Document& m_document;
    const ViewportWidget& m_view;
    FramePointer m_frame; ///< the trees fit to this one
    FilledBodies m_bodies;
    std::vector<Body> m_pickers;
};

} // namespace knead
