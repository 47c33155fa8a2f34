#include "ui/viewport/viewport_widget.h"

#include "core/model/part_tree.h"
#include "ui/viewport/pixel_of.h"
#include "ui/viewport/region_overlay.h"
#include "ui/viewport/surface_field_overlay.h"
#include "ui/viewport/surface_fields_preparer.h"
#include "ui/viewport/view_cube.h"
#include "ui/viewport/view_reading.h"

#include <QLabel>
#include <QVariantAnimation>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr double roomAroundPlace = 1.15; // in distance: in perspective a box that is in the middle reaches further
constexpr int turnTime = 220;            // [ms]
constexpr double drawingShare = 0.4;     // of the window's time at most; without a graphics card drawing is slow
constexpr int captionInset = 12;         // [pixels]

} // namespace

ViewportWidget::ViewportWidget(Document& document, QWidget* parent)
    : ViewportBridge(parent)
    , m_document(document)
    , m_manipulation(new Manipulation(document, this))
    , m_regions(new RegionTool(document, m_manipulation->picker(), this))
    , m_regionOverlay(new RegionOverlay(*m_regions, this))
    , m_scene(std::make_unique<SceneView>(renderWindow()))
    , m_sights(new SurfaceFieldsPreparer(this))
    , m_overlay(new SurfaceFieldOverlay(*this))
    , m_turning(new QVariantAnimation(this))
    , m_caption(new QLabel(this))
{
    m_caption->setObjectName("pastCaption");
    m_caption->setProperty("role", "force");
    m_caption->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_caption->move(captionInset, captionInset);
    m_caption->hide();
    setObjectName("viewport");
    setFocusPolicy(Qt::StrongFocus);
    makeReadable(*this, document);
    setMouseTracking(true);
    m_turning->setDuration(turnTime);
    m_turning->setStartValue(0.0);
    m_turning->setEndValue(1.0);
    m_turning->setEasingCurve(QEasingCurve::InOutCubic);
    connect(m_turning, &QVariantAnimation::valueChanged, this,
            [this](const QVariant& s) { setCamera(blend(m_turnStart, m_turnEnd, s.toDouble())); });
    connect(&document, &Document::changed, this, &ViewportWidget::documentChanged);
    connect(m_manipulation, &Manipulation::hoverChanged, this, &ViewportWidget::updateMarks);
    connect(m_sights, &SurfaceFieldsPreparer::made, this, [this](const SurfaceFieldsPointer& fields) {
        if (!requestOf(m_options).isEmpty())
            setSurfaceFields(fields);
        requestRender();
    });
    connect(m_regions, &RegionTool::hoverChanged, this, &ViewportWidget::updateMarks);
    connect(&document.selected(), &SelectionModel::changed, this, &ViewportWidget::updateMarks);
    connect(&document, &Document::appearanceChanged, this, [this] {
        m_scene->setAppearance(m_document.appearance());
        requestRender();
        emit sceneChanged(SceneChange::looks);
    });
}

ViewportWidget::~ViewportWidget() = default;

void ViewportWidget::setOptions(const SceneOptions& options)
{
    const bool isDragged = isOnlyCutElsewhere(m_options, options);
    m_options = options;
    m_manipulation->picker().hide(options.hiddenParts);
    m_manipulation->picker().cut(options.section.plane);
    m_regions->fields().hide(options.hiddenParts);
    m_regions->fields().cut(options.section.plane);
    m_scene->setOptions(options);
    askForSurfaceFields();
    if (isDragged)
        requestSketch();
    else
        requestRender();
    emit sceneChanged(SceneChange::options);
    emit optionsChanged();
}

/// What belongs to a place in another part is given up; the same part filled anew is looked at as before.
void ViewportWidget::beginContent()
{
    const Box& box = m_document.content().box;
    if (!m_restBox.isApprox(box) || m_document.content().bodies.empty()) {
        m_options.section.plane.reset();
        m_options.divider.reset();
    }
    m_restBox = box;
    const std::shared_ptr<const Model> before = std::exchange(m_model, m_document.content().model);
    const bool isSame = std::exchange(m_opening, m_document.opening()) == m_document.opening();
    m_options.hiddenParts =
        isSame && before ? stillHidden(m_options.hiddenParts, *before, *m_model) : m_document.content().hiddenAtFirst();
    m_sights->begin(m_document.content().bodies);
    m_scene->setModel(m_document.content());
    m_scene->setAppearance(m_document.appearance());
    takeMaterials();
    m_marks = {};
    m_fields = nullptr;
    emit sceneChanged(SceneChange::content);
    setOptions(m_options);
    showFrame();
}

/// Those of now, also of what is looked at of the past.
void ViewportWidget::takeMaterials()
{
    if (!m_document.frame() || !m_scene->setMaterials(m_document.frame()->snapshot->materials))
        return;
    requestRender();
    emit sceneChanged(SceneChange::looks);
}

/// Of now, or of the past when that is looked at.
void ViewportWidget::showFrame()
{
    if (const FramePointer& shown = shownFrame()) {
        m_scene->showFrame(shown);
        emit sceneChanged(SceneChange::frame);
    }
}

/// Whether all is where the last frame showed it, with what presses on it told as before.
bool ViewportWidget::isAtRest()
{
    const Snapshot& now = *m_document.frame()->snapshot;
    const std::pair rest(now.rest, !now.bodies.empty() && now.bodies.front().pressing != nullptr);
    return std::exchange(m_rest, rest) == rest && now.rest > 0;
}

void ViewportWidget::setSurfaceFields(const SurfaceFieldsPointer& fields)
{
    if (!fields && !m_fields)
        return;
    m_fields = fields;
    m_scene->setSurfaceFields(fields);
    emit sceneChanged(SceneChange::fields);
}

/// Colors and caps come when they are found, for the moment that is shown.
void ViewportWidget::askForSurfaceFields()
{
    const SurfaceFieldsRequest request =
        m_document.content().bodies.empty() ? SurfaceFieldsRequest() : requestOf(m_options);
    m_document.showPressing(request.quantity == SurfaceQuantity::contactForce ||
                            request.quantity ==
                                SurfaceQuantity::vonMisesStress); // which depends on where something presses
    if (m_past && m_foretold) {
        m_sights->forget();
        setSurfaceFields(m_foretold);
    } else if (request.isEmpty()) {
        m_sights->forget();
        setSurfaceFields(nullptr);
    } else if (const FramePointer& shown = shownFrame())
        m_sights->ask(shown, request);
}

void ViewportWidget::setStyle(const SceneStyle& style)
{
    m_style = style;
    m_scene->setStyle(style);
    requestRender();
    emit sceneChanged(SceneChange::style);
}

void ViewportWidget::setTurningSmoothly(bool on)
{
    m_turning->setDuration(on ? turnTime : 0);
}

void ViewportWidget::setFixing(bool on)
{
    m_manipulation->setFixing(on);
    m_regions->leave();
    updateMarks();
}

void ViewportWidget::forgetHover()
{
    m_manipulation->leave();
    m_regions->leave();
}

void ViewportWidget::setMode(std::optional<Qt::CursorShape> cursor)
{
    m_mode = cursor;
    forgetHover();
    updateMarks();
}

Qt::CursorShape ViewportWidget::usualCursor() const
{
    const Qt::CursorShape cursor = m_manipulation->cursor();
    return cursor == Qt::ArrowCursor ? m_mode.value_or(cursor) : cursor;
}

void ViewportWidget::setHighlight(const std::optional<SceneMarks::Face>& face)
{
    if (std::exchange(m_highlight, face) != face)
        updateMarks();
}

void ViewportWidget::documentChanged(Document::Change what)
{
    switch (what) {
    case Document::Change::Model:
        m_past = nullptr;
        m_foretold = nullptr;
        m_caption->hide();
        beginContent();
        break;
    case Document::Change::Filling:
        m_regions->fields().forget();
        return;
    case Document::Change::Frame:
        takeMaterials();
        if (m_past || isAtRest())
            return;
        showFrame();
        break;
    case Document::Change::Selection:
    case Document::Change::Fixtures:
    case Document::Change::Moment:
        break;
    case Document::Change::History:
        return;
    }
    if (what != Document::Change::Frame)
        updateMarks();
    askForSurfaceFields();
    if (what == Document::Change::Frame)
        requestSketch();
    else
        requestRender();
}

void ViewportWidget::lookBack(const FramePointer& frame, const QString& caption)
{
    m_foretold = nullptr;
    lookAt(frame, caption);
}

void ViewportWidget::lookAhead(const FramePointer& frame, const SurfaceFieldsPointer& fields, const QString& caption)
{
    m_foretold = frame ? fields : nullptr;
    lookAt(frame, caption);
}

void ViewportWidget::lookAt(const FramePointer& frame, const QString& caption)
{
    m_past = frame;
    m_regions->cancel(); // one selects in the present
    m_regions->leave();
    m_caption->setText(caption);
    m_caption->adjustSize();
    m_caption->setVisible(m_past != nullptr);
    showFrame();
    m_overlay->setPast(m_past != nullptr);
    askForSurfaceFields();
    requestSketch();
}

void ViewportWidget::updateMarks()
{
    SceneMarks marks;
    const Selection& selection = m_document.selection();
    if (selection.kind == Selection::Kind::Body)
        marks.selectedBody = selection.id;
    if (selection.kind == Selection::Kind::Tool)
        marks.selectedTool = selection.id;
    const PickHit& hovered = m_manipulation->hovered();
    if (hovered.kind == PickHit::Kind::Tool)
        marks.hoveredTool = hovered.id;
    if (hovered.kind == PickHit::Kind::Body && m_manipulation->isFixing() && !m_manipulation->isJustToggled())
        marks.highlighted = SceneMarks::Face{hovered.id, hovered.face};
    marks.selected = m_document.selected().region();
    const bool isOnly = m_document.content().bodies.size() == 1; // the cursor could mean nothing else
    if (const Region& under = m_regions->hovered(); under.level != Level::Part || !isOnly)
        marks.hovered = under;
    if (m_highlight)
        marks.highlighted = m_highlight;
    marks.fixed = fixedFaces();
    marks.isFixing = m_manipulation->isFixing();
    m_marks = std::move(marks);
    m_scene->setMarks(m_marks);
    setCursor(usualCursor());
    requestRender();
    emit sceneChanged(SceneChange::marks);
}

std::vector<SceneMarks::Face> ViewportWidget::fixedFaces() const
{
    std::vector<SceneMarks::Face> faces;
    for (const FaceFixture& fixture : m_document.fixtures().list())
        for (const std::uint32_t face : fixture.faces)
            faces.push_back({fixture.body, face});
    return faces;
}

SceneLook ViewportWidget::look() const
{
    SceneOptions options = m_options;
    options.section.hasFrame = false; // a handle of the view
    return {m_document.content(),
            options,
            {.fixed = fixedFaces()},
            m_style,
            m_camera,
            m_document.appearance(),
            m_document.frame() ? m_document.frame()->snapshot->materials : std::vector<Material>()};
}

QImage ViewportWidget::portrait()
{
    m_scene->cube().setDrawn(false);
    requestRender();
    QImage image = grabFramebuffer();
    m_scene->cube().setDrawn(true);
    requestRender();
    return image;
}

WindowSize ViewportWidget::window() const
{
    return {static_cast<double>(std::max(1, width())), static_cast<double>(std::max(1, height()))};
}

bool ViewportWidget::showsAll() const
{
    const Camera camera = cameraAfterTurning();
    const Box box = sceneBox();
    const WindowSize size = window();
    for (int corner = 0; corner < 8; ++corner) {
        const auto seen = camera.project(box.corner(static_cast<Box::CornerType>(corner)), size);
        if (!seen || seen->x < 0 || seen->y < 0 || seen->x > size.width || seen->y > size.height)
            return false;
    }
    return true;
}

Box ViewportWidget::materialBox() const
{
    Box box = m_restBox;
    if (const FramePointer& frame = shownFrame())
        for (const auto& body : frame->bodies)
            for (const Vec3& place : body->places)
                box.extend(place);
    return box;
}

Ray ViewportWidget::rayAt(const QPointF& position) const
{
    return m_camera.ray(pixelOf(position), window());
}

bool ViewportWidget::isOnCube(const QPointF& position) const
{
    return cubeSideAt(position).has_value();
}

/// Of the cube as it will be drawn: a press may come before that, from a view that was not the active one.
std::optional<Vec3> ViewportWidget::cubeSideAt(const QPointF& position) const
{
    m_scene->cube().setWindow(window());
    m_scene->cube().setCamera(m_camera);
    return m_scene->cube().directionAt(pixelOf(position));
}

std::optional<QPointF> ViewportWidget::widgetPosition(const Vec3& place) const
{
    const std::optional<Pixel> pixel = m_camera.project(place, window());
    return pixel ? std::optional(QPointF(pixel->x, pixel->y)) : std::nullopt;
}

void ViewportWidget::setCamera(const Camera& camera)
{
    m_camera = camera;
    requestSketch();
    emit cameraChanged();
}

Camera ViewportWidget::cameraAfterTurning() const
{
    return m_turning->state() == QAbstractAnimation::Running ? m_turnEnd : m_camera;
}

void ViewportWidget::turnTo(const Camera& camera)
{
    m_turning->stop();
    m_turnStart = m_camera;
    m_turnEnd = camera;
    m_turning->start();
}

void ViewportWidget::jumpTo(const Camera& camera)
{
    m_turning->stop();
    m_turnEnd = camera;
    setCamera(camera);
}

void ViewportWidget::fit()
{
    Camera camera = cameraAfterTurning();
    camera.fit(m_scene->box(), window(), taken());
    turnTo(camera);
}

void ViewportWidget::flyTo(const Box& box, const std::optional<Vec3>& from)
{
    Camera camera = cameraAfterTurning();
    if (from)
        camera.lookFrom(*from);
    const Insets covered = taken();
    camera.fit(box, window(), covered);
    camera.distance *= roomAroundPlace;
    if (const std::optional<Pixel> seen = camera.project(box.center(), window()))
        camera.pan((window().width + covered.left - covered.right) / 2 - seen->x,
                   (window().height + covered.top - covered.bottom) / 2 - seen->y, window());
    turnTo(camera);
}

void ViewportWidget::keepFree(const QObject* what, const Insets& taken)
{
    m_taken[what] = taken;
}

Insets ViewportWidget::taken() const
{
    Insets all;
    for (const auto& [what, own] : m_taken) {
        all.left = std::max(all.left, own.left);
        all.top = std::max(all.top, own.top);
        all.right = std::max(all.right, own.right);
        all.bottom = std::max(all.bottom, own.bottom);
    }
    return all;
}

void ViewportWidget::lookFrom(const Vec3& direction)
{
    Camera camera = cameraAfterTurning();
    camera.lookFrom(direction);
    turnTo(camera);
}

void ViewportWidget::setPerspective(bool on)
{
    if (m_camera.perspective == on)
        return;
    m_turnEnd.perspective = on;
    m_camera.perspective = on;
    setCamera(m_camera);
}

void ViewportWidget::moveDivider(double share)
{
    if (!options().divider)
        return;
    SceneOptions changed = options();
    changed.divider = share;
    setOptions(changed);
}

void ViewportWidget::setCaptionTop(int top)
{
    m_caption->move(captionInset, top);
}

void ViewportWidget::aboutToRender()
{
    m_document.setDisplayInterval((renderSeconds() + m_secondsOfOthers) / drawingShare);
    m_scene->cube().setWindow(window());
    m_scene->setCamera(m_camera);
    m_overlay->place(m_scene->scale(), m_restBox);
    m_labels.place(m_scene->labels(), [this](const Vec3& place) { return widgetPosition(place); });
}

bool ViewportWidget::isMoving() const
{
    return m_document.isPlaying() && !m_past;
}

void ViewportWidget::resizeEvent(QResizeEvent* event)
{
    ViewportBridge::resizeEvent(event);
    m_regionOverlay->resize(size());
    requestRender();
}

} // namespace knead
