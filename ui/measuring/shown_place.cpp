#include "ui/measuring/shown_place.h"

#include "ui/document/document.h"
#include "ui/viewport/viewport_widget.h"

#include <QEvent>

namespace knead {

namespace {

constexpr double leastSurroundings = 0.2; // of the diagonal of all
constexpr double pointSize = 1e-9;        // below which a place has no outline [m]

/// The twelve edges of a box.
std::vector<std::vector<Vec3>> edgesOf(const Box& box)
{
    std::vector<std::vector<Vec3>> edges;
    for (int corner = 0; corner < 8; ++corner)
        for (int axis = 0; axis < 3; ++axis)
            if ((corner & 1 << axis) == 0)
                edges.push_back({box.corner(static_cast<Box::CornerType>(corner)),
                                 box.corner(static_cast<Box::CornerType>(corner | 1 << axis))});
    return edges;
}

OverlayMark outlineOf(const Box& box)
{
    OverlayMark mark{.isStrong = true};
    mark.mark.label = box.center();
    if (box.diagonal().norm() > pointSize)
        mark.mark.lines = edgesOf(box);
    else
        mark.mark.points = {box.center()};
    return mark;
}

} // namespace

Box boxOf(const ReportPlace& place, const FilledModel& content, const Frame& frame)
{
    if (!place.part)
        return place.box;
    Box box;
    for (std::size_t b = 0; b < frame.bodies.size(); ++b)
        if (frame.filled[b]->part == *place.part)
            for (const Vec3& vertex : frame.bodies[b]->places)
                box.extend(vertex);
    for (const auto& surface : content.surfaces)
        if (surface->body->part == *place.part)
            for (const Vec3& vertex : surface->body->mesh.vertices)
                box.extend(vertex);
    return box;
}

Box withSurroundings(const Box& place, const Box& all)
{
    const double least = leastSurroundings * all.diagonal().norm();
    const Vec3 half = 0.5 * place.sizes().cwiseMax(least / std::sqrt(3.0));
    return {place.center() - half, place.center() + half};
}

ShownPlace::ShownPlace(Document& document, ViewportWidget& view)
    : QObject(&view)
    , m_document(document)
    , m_view(view)
    , m_overlay(new MarksOverlay(view, [&view](const Vec3& place) { return view.widgetPosition(place); }))
{
    m_overlay->setObjectName("shownPlace");
    view.installEventFilter(this);
    connect(&view, &ViewportBridge::renderRequested, this, [this] {
        if (const FramePointer& now = m_view.shownFrame(); m_frame && (!now || now->bodies != m_frame->bodies))
            hide();
    });
    connect(&document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Model)
            hide();
    });
}

void ShownPlace::show(const ReportPlace& place)
{
    const FramePointer& frame = m_view.shownFrame();
    if (!frame)
        return;
    const Box box = boxOf(place, m_document.content(), *frame);
    if (box.isEmpty())
        return;
    if (place.part)
        selectPart(*place.part);
    const Box all = m_view.materialBox();
    const Vec3 outward = box.center() - all.center();
    // From behind, the part would hide it.
    const bool isBehind = !place.part && outward.dot(m_view.cameraAfterTurning().towardsEye()) < 0;
    m_view.flyTo(withSurroundings(box, all), isBehind ? std::optional(outward.normalized()) : std::nullopt);
    m_frame = frame;
    m_overlay->show({outlineOf(box)});
}

void ShownPlace::selectPart(std::size_t part)
{
    const FilledBodies& bodies = m_document.content().bodies;
    for (BodyId b = 0; b < bodies.size(); ++b)
        if (bodies[b]->part == part)
            return m_document.select({Selection::Kind::Body, b});
}

bool ShownPlace::eventFilter(QObject* /*watched*/, QEvent* event)
{
    if (event->type() == QEvent::MouseButtonPress)
        hide();
    return false;
}

void ShownPlace::hide()
{
    m_frame = nullptr;
    m_overlay->show({});
}

} // namespace knead
