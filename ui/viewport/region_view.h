#pragma once

#include "core/geometry/plane_section.h"
#include "core/session/region.h"
#include "ui/viewport/projector.h"
#include "ui/viewport/scene_picker.h"

#include <optional>
#include <set>
#include <vector>

namespace knead {

/// A closed line on the screen: a box, a lasso, the disk of a brush.
using ScreenShape = std::vector<Pixel>;

ScreenShape boxShape(const Pixel& a, const Pixel& b);
ScreenShape strokeShape(const Pixel& a, const Pixel& b, double radius); ///< that a disk sweeps over from a to b
bool contains(const ScreenShape& shape, const Pixel& pixel);

/// Finds what is seen at a place of the screen, or within a shape on it. Window thread; some ms for 100,000 triangles.
class RegionView {
public:
    RegionView(const Document& document, ScenePicker& picker)
        : m_document(document)
        , m_picker(picker)
    {
    }

    void look(const Camera& camera, const WindowSize& window)
    {
        m_camera = camera;
        m_window = window;
    }
    /// Parts that cannot be selected, since nobody sees them.
    void hide(const std::set<std::size_t>& parts) { m_hiddenParts = parts; }
    /// What a section plane takes away, which nobody sees either.
    void cut(const std::optional<CutPlane>& plane) { m_cut = plane; }
    void forget() { m_connections.clear(); }

    /// The one thing under a pixel, or nothing.
    Region at(Level level, const Pixel& pixel);

    struct Query {
        Level level = Level::Part;
        bool isWhole = false;   ///< only what lies in the shape with all of it
        bool isThrough = false; ///< also what is hidden behind the skin
    };
    Region within(const ScreenShape& shape, const Query& query);
    /// What lies under the pixels between two, one for each step.
    Region along(Level level, const Pixel& from, const Pixel& to, double step);

private:
    bool isShown(BodyId body) const;
    bool isCutOff(const Vec3& place) const;
    Projector projector() const;
    bool isSeen(const Vec3& place, double tolerance);
    bool isSeenNow(const Vec3& place, double tolerance) const;
    double tolerance() const;
    bool isWithin(const Vec3& place, const ScreenShape& shape) const;
    std::vector<bool> verticesWithin(BodyId body, const ScreenShape& shape) const;
    const std::vector<ConnectionId>& connectionsOf(BodyId body);

    Region edgeAt(const Pixel& pixel);
    Region objectAt(const Pixel& pixel) const;
    Region connectionAt(const Pixel& pixel);

    Region::Items partWithin(BodyId body, const ScreenShape& shape, const Query& query) const;
    Region::Items facesWithin(BodyId body, const ScreenShape& shape, const Query& query);
    Region::Items edgesWithin(BodyId body, const ScreenShape& shape, const Query& query);
    Region::Items objectsWithin(BodyId body, const ScreenShape& shape, const Query& query);
    Region::Items connectionsWithin(BodyId body, const ScreenShape& shape, const Query& query);
    bool isFaceSeen(BodyId body, std::uint32_t face, const std::vector<std::uint32_t>& triangles);
    Region facesUnder(const ScreenShape& shape);

    const Document& m_document;
    ScenePicker& m_picker;
    Camera m_camera;
    WindowSize m_window;
    std::set<std::size_t> m_hiddenParts;
    std::optional<CutPlane> m_cut;
    std::map<BodyId, std::vector<ConnectionId>> m_connections; ///< of the surface; found when asked for
};

} // namespace knead
