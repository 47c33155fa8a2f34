#include "ui/document/warning_watch.h"

#include "core/geometry/mass_properties.h"
#include "ui/document/fold_watch.h"
#include "ui/units.h"

#include <algorithm>
#include <map>
#include <utility>

namespace knead {

namespace {

/// The middle of a triangle of a body, as it is drawn.
Vec3 middleOfTriangle(const FilledBody& body, const BodyFrame& drawn, std::uint32_t triangle)
{
    const TriangleMesh::Triangle& corners = body.mesh.triangles[triangle];
    return (drawn.places[corners[0]] + drawn.places[corners[1]] + drawn.places[corners[2]]) / 3;
}

} // namespace

/// Looks at frames, one after the other. Remembers the walls that bodies have at rest.
class WarningWatch::Finder {
public:
    std::vector<OfBody> find(const Frame& frame, TaskControl& control)
    {
        std::vector<OfBody> all;
        for (BodyId b = 0; b < frame.bodies.size(); ++b) {
            const Snapshot::BodyState& state = frame.snapshot->bodies[b];
            const FilledBody& body = *frame.filled[b];
            const std::vector<Vec3>& places = frame.bodies[b]->places;
            if (state.kind != BodyKind::deformable || places == body.mesh.vertices)
                continue;
            OfBody one{.body = b, .wall = {}, .stretch = mostOverstretched(state, control)};
            if (!body.whole)
                if (const Known& known = knownOf(b, body, control); known.walls)
                    one.wall = known.walls->thinnest(places, body.aggregate->lattice.spacing, control);
            if (one.wall || one.stretch)
                all.push_back(one);
        }
        return all;
    }

private:
    struct Known {
        TriangleMesh rest;
        std::optional<WallChange> walls; ///< of closed surfaces
    };

    const Known& knownOf(BodyId id, const FilledBody& body, TaskControl& control)
    {
        const auto found = m_known.find(id);
        if (found != m_known.end() && found->second.rest.vertices == body.mesh.vertices &&
            found->second.rest.triangles == body.mesh.triangles)
            return found->second;
        Known known{.rest = body.mesh, .walls = {}};
        if (isWatertight(body.mesh))
            known.walls.emplace(body.mesh, control);
        return m_known.insert_or_assign(id, std::move(known)).first->second;
    }

    std::map<BodyId, Known> m_known;
};

WarningWatch::WarningWatch(Document& document, const FoldWatch& folds, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_folds(folds)
    , m_look(
          document,
          [this, finder = std::make_shared<Finder>()](const FramePointer& frame,
                                                      TaskControl& control) -> BackgroundLook::Finish {
              return [this, frame, found = finder->find(*frame, control)] { take(frame, found); };
          },
          this)
{
    connect(&folds, &FoldWatch::changed, this, &WarningWatch::changed);
    connect(&m_look, &BackgroundLook::forgotten, this, [this] {
        m_frame = nullptr;
        if (!std::exchange(m_found, {}).empty())
            emit changed();
    });
}

void WarningWatch::take(const FramePointer& frame, std::vector<OfBody> found)
{
    m_frame = frame;
    const std::vector<OfBody> before = std::exchange(m_found, std::move(found));
    if (!before.empty() || !m_found.empty())
        emit changed();
}

std::vector<PlaceWarning> WarningWatch::warnings() const
{
    std::vector<PlaceWarning> all;
    const FramePointer frame = m_document.frame();
    if (!frame)
        return all;
    addFolds(all);
    for (const OfBody& one : m_found)
        if (one.body < frame->bodies.size())
            addFound(one, *frame, all);
    return all;
}

/// One per fold, at that of its triangles which is nearest to its middle.
void WarningWatch::addFolds(std::vector<PlaceWarning>& all) const
{
    for (const Fold& fold : m_folds.folds()) {
        const std::vector<Vec3> places = m_folds.placesOf(fold);
        if (places.empty())
            continue;
        Vec3 middle = Vec3::Zero();
        for (const Vec3& place : places)
            middle += place / static_cast<double>(places.size());
        const auto nearest =
            std::ranges::min_element(places, {}, [&](const Vec3& place) { return (place - middle).squaredNorm(); });
        all.push_back({PlaceWarning::Kind::fold, fold.body, *nearest, tr("Fold")});
    }
}

void WarningWatch::addFound(const OfBody& one, const Frame& now, std::vector<PlaceWarning>& all) const
{
    const FilledBody& body = *now.filled[one.body];
    const bool isFolded = std::ranges::find(m_folds.folds(), one.body, &Fold::body) != m_folds.folds().end();
    if (one.wall && !isFolded && haveSameSurface(body, *m_frame->filled[one.body]))
        all.push_back({PlaceWarning::Kind::thinWall, one.body,
                       middleOfTriangle(body, *now.bodies[one.body], one.wall->triangle),
                       tr("Wall %1, was %2")
                           .arg(formatReading(one.wall->thickness, Quantity::Length),
                                formatReading(one.wall->atRest, Quantity::Length))});
    const Snapshot::BodyState& state = now.snapshot->bodies[one.body];
    const Snapshot::BodyState& found = m_frame->snapshot->bodies[one.body];
    if (one.stretch && state.aggregate == found.aggregate && state.broken == found.broken) // what broke is relaxed
        all.push_back({PlaceWarning::Kind::stretch, one.body, state.positions[one.stretch->object],
                       tr("Stretched to %1 % of breaking").arg(qRound(100 * one.stretch->share))});
}

} // namespace knead
