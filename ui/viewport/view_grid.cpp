#include "ui/viewport/view_grid.h"

#include "ui/viewport/view_name.h"

#include <QApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr int nameInset = 8;         // from the corner of a view [pixels]
constexpr int captionUnderName = 36; // [pixels]
constexpr double fitTolerance = 1e-3;
constexpr double turnBudget = 0.008; // for side views between two events; at least one is drawn [s]

/// From where a part is looked at first: the free view as a new camera looks, the others from where they are named
/// after.
Vec3 firstDirection(ViewSlot slot)
{
    const Vec3 directions[viewSlots] = {Camera().towardsEye(), {0, -1, 0}, {0, 0, 1}, {1, 0, 0}};
    return directions[static_cast<std::size_t>(slot)];
}

/// As they come; those with names are in parallel.
Camera firstCamera(ViewSlot slot)
{
    Camera camera;
    camera.lookFrom(firstDirection(slot));
    camera.perspective = slot == ViewSlot::free;
    return camera;
}

} // namespace

ViewGrid::ViewGrid(Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_view(new ViewportWidget(document, this))
{
    setObjectName("views");
    setMouseTracking(true);
    setMinimumSize(320, 240);
    for (const ViewSlot slot : allViewSlots) {
        m_cameras[indexOf(slot)] = firstCamera(slot);
        auto* name = new ViewName(this);
        name->setObjectName(QStringLiteral("viewName%1").arg(indexOf(slot)));
        connect(name, &ViewName::clicked, this, [this, slot] { activate(slot); });
        connect(name, &ViewName::doubleClicked, this, [this, slot] {
            activate(slot);
            setAlone(!m_isAlone);
        });
        m_names[indexOf(slot)] = name;
    }
    m_turn.setSingleShot(true);
    m_turn.setInterval(0);
    connect(&m_turn, &QTimer::timeout, this, &ViewGrid::drawStale);
    connect(m_view, &ViewportWidget::cameraChanged, this, [this] {
        linkTo(m_active);
        showNames();
    });
    connect(&document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Model)
            contentChanged();
    });
}

/// Side views go before the view they look at.
ViewGrid::~ViewGrid()
{
    remember();
    for (SideView* side : m_sides)
        delete side;
}

// --- arrangement ------------------------------------------------------------------------------------------------------

QRect ViewGrid::cell(ViewSlot slot) const
{
    return isSingle() ? rect() : m_cells.cell(slot, rect());
}

void ViewGrid::arrange(ViewArrangement arrangement)
{
    m_isAlone = false;
    m_cells.arrangement = arrangement;
    layOut();
    remember();
    emit changed();
}

void ViewGrid::setAlone(bool alone)
{
    alone = alone && areSeveral();
    if (std::exchange(m_isAlone, alone) == alone)
        return;
    layOut();
    emit changed();
}

void ViewGrid::layOut(Cameras cameras)
{
    const std::vector<ViewSlot> wholes = cameras == Cameras::keepWhole ? fittedOnes() : std::vector<ViewSlot>();
    makeSides();
    m_view->setGeometry(cell(m_active));
    for (const ViewSlot slot : m_cells.shown())
        if (SideView* side = sideView(slot)) {
            side->setGeometry(m_cells.cell(slot, rect()));
            side->setVisible(!isSingle());
        }
    m_view->setCaptionTop(areSeveral() ? captionUnderName : nameInset + 4);
    fitNew();
    fit(wholes);
    linkTo(m_active);
    showNames();
    update();
    m_turn.start(); // what became another while it was hidden
}

/// None for a page that nobody looks at.
void ViewGrid::makeSides()
{
    for (const ViewSlot slot : allViewSlots) {
        SideView*& side = m_sides[indexOf(slot)];
        const bool isWanted = m_cells.shows(slot) && slot != m_active;
        if (isWanted && side == nullptr && isVisible() && !isSingle()) {
            side = newSide(slot);
        } else if (!isWanted && side != nullptr) {
            m_cameras[indexOf(slot)] = side->camera();
            side->hide();
            side->disconnect(this);
            side->deleteLater(); // it may have asked for it
            side = nullptr;
        }
    }
}

SideView* ViewGrid::newSide(ViewSlot slot)
{
    auto* side = new SideView(m_document, *m_view, this);
    side->setObjectName(QStringLiteral("sideView%1").arg(indexOf(slot)));
    side->setSamples(m_samples);
    side->setCamera(m_cameras[indexOf(slot)]);
    const auto slotOf = [this, side] {
        const auto at = std::find(m_sides.begin(), m_sides.end(), side); // they change places
        return static_cast<ViewSlot>(at - m_sides.begin());
    };
    connect(side, &SideView::pressed, this, [this, slotOf] { activate(slotOf()); });
    connect(side, &SideView::zoomed, this, [this, slotOf] { linkTo(slotOf()); });
    connect(side, &SideView::becameStale, this, [this, side] {
        if (side->isVisible() && !m_turn.isActive())
            m_turn.start();
    });
    emit sideAdded(*side);
    return side;
}

void ViewGrid::showNames()
{
    for (const ViewSlot slot : allViewSlots) {
        ViewName& name = *m_names[indexOf(slot)];
        const bool isActive = slot == m_active;
        if (SideView* side = sideView(slot))
            side->setAccessibleName(nameOfView(side->camera()));
        if (!m_cells.shows(slot) || (isSingle() && !isActive)) {
            name.hide();
            continue;
        }
        name.move(cell(slot).topLeft() + QPoint(nameInset, nameInset));
        name.show(nameOfView(camera(slot)), isActive);
    }
}

// --- the active view --------------------------------------------------------------------------------------------------

void ViewGrid::activate(ViewSlot slot)
{
    SideView* side = sideView(slot);
    if (slot == m_active || side == nullptr)
        return;
    m_view->forgetHover();
    const Camera wanted = side->camera();
    side->setCamera(m_view->cameraAfterTurning());
    std::swap(m_sides[indexOf(slot)], m_sides[indexOf(m_active)]);
    m_active = slot;
    if (slot != ViewSlot::free)
        m_cells.second = slot;
    m_isLinking = true; // it was linked before
    m_view->jumpTo(wanted);
    m_isLinking = false;
    layOut(Cameras::keep);
    m_view->setFocus();
    emit activated();
}

void ViewGrid::activateNext()
{
    if (!areSeveral() || QApplication::mouseButtons() != Qt::NoButton)
        return;
    const std::vector<ViewSlot> shown = m_cells.shown();
    const auto at = std::find(shown.begin(), shown.end(), m_active);
    activate(at + 1 == shown.end() ? shown.front() : *(at + 1));
}

Camera ViewGrid::camera(ViewSlot slot) const
{
    if (slot == m_active)
        return m_view->camera();
    const SideView* side = m_sides[indexOf(slot)];
    return side != nullptr ? side->camera() : m_cameras[indexOf(slot)];
}

void ViewGrid::setCamera(ViewSlot slot, const Camera& camera)
{
    if (slot == m_active)
        m_view->jumpTo(camera);
    else if (SideView* side = sideView(slot))
        side->setCamera(camera);
    else
        m_cameras[indexOf(slot)] = camera;
}

// --- what cameras follow ----------------------------------------------------------------------------------------------

/// The active view is fitted by who opened the part.
void ViewGrid::contentChanged()
{
    const Box& box = m_document.content().box;
    if (m_box.isEmpty() || !m_box.isApprox(box))
        m_areFitted.fill(false);
    m_box = box;
    const std::shared_ptr<const Model> before = std::exchange(m_opened, m_document.opened());
    if (before != nullptr && before != m_opened) { // how the last part was turned says nothing of another one
        m_areFitted.fill(false);
        for (const ViewSlot slot : allViewSlots) {
            Camera turned = cameraToBe(slot);
            turned.lookFrom(firstDirection(slot));
            setCamera(slot, turned);
        }
    }
    fitNew();
}

/// Views that never showed this part.
void ViewGrid::fitNew()
{
    m_areFitted[indexOf(m_active)] = true;
    if (!isVisible() || m_document.isEmpty() || isSingle())
        return;
    for (const ViewSlot slot : m_cells.shown()) {
        if (std::exchange(m_areFitted[indexOf(slot)], true))
            continue;
        setCamera(slot, fitted(slot, camera(slot), cell(slot).size()));
    }
}

/// As ViewportWidget::fit() has it: what lies on the active view is left free there.
Camera ViewGrid::fitted(ViewSlot slot, const Camera& camera, const QSize& size) const
{
    Camera result = camera;
    const WindowSize window{1.0 * std::max(1, size.width()), 1.0 * std::max(1, size.height())};
    result.fit(m_view->sceneBox(), window, slot == m_active ? m_view->taken() : Insets());
    return result;
}

QSize ViewGrid::sizeOf(ViewSlot slot) const
{
    const SideView* side = m_sides[indexOf(slot)];
    return side != nullptr ? side->size() : m_view->size();
}

/// Views that show all of the part and no more go on to do so when they become larger or smaller.
std::vector<ViewSlot> ViewGrid::fittedOnes() const
{
    std::vector<ViewSlot> wholes;
    if (!isVisible() || m_document.isEmpty())
        return wholes;
    for (const ViewSlot slot : allViewSlots) {
        const bool isThere = slot == m_active || (m_sides[indexOf(slot)] != nullptr && m_cells.shows(slot));
        if (!isThere || sizeToBe(slot) == sizeOf(slot))
            continue;
        const Camera now = cameraToBe(slot);
        const Camera whole = fitted(slot, now, sizeOf(slot));
        if ((now.target - whole.target).norm() < fitTolerance * whole.distance &&
            std::abs(now.distance / whole.distance - 1) < fitTolerance)
            wholes.push_back(slot);
    }
    return wholes;
}

void ViewGrid::fit(const std::vector<ViewSlot>& wholes)
{
    for (const ViewSlot slot : wholes)
        setCamera(slot, fitted(slot, cameraToBe(slot), sizeToBe(slot)));
}

QSize ViewGrid::sizeToBe(ViewSlot slot) const
{
    return slot == m_active ? cell(slot).size() : m_cells.cell(slot, rect()).size();
}

Camera ViewGrid::cameraToBe(ViewSlot slot) const
{
    return slot == m_active ? m_view->cameraAfterTurning() : camera(slot);
}

void ViewGrid::setLinked(bool linked)
{
    if (std::exchange(m_areLinked, linked) == linked)
        return;
    linkTo(m_active);
    remember();
    emit changed();
}

/// A pixel is as many meters in all of them, whatever their heights.
void ViewGrid::linkTo(ViewSlot slot)
{
    if (!m_areLinked || m_isLinking || isSingle())
        return;
    m_isLinking = true;
    const Camera leading = camera(slot);
    const double perPixel = leading.distance / std::max(1, cell(slot).height());
    for (const ViewSlot other : m_cells.shown()) {
        if (other == slot)
            continue;
        Camera following = cameraToBe(other); // it may be turning
        following.target = leading.target;
        following.distance = perPixel * cell(other).height();
        setCamera(other, following);
    }
    m_isLinking = false;
}

// --- drawing ----------------------------------------------------------------------------------------------------------

void ViewGrid::drawStale()
{
    double spent = 0;
    for (std::size_t i = 1; i <= viewSlots; ++i) {
        const std::size_t next = (m_lastDrawn + 1) % viewSlots;
        SideView* side = m_sides[next];
        if (side != nullptr && side->isVisible() && side->isStale()) {
            if (spent > 0 && spent + side->renderSeconds() > turnBudget) {
                m_turn.start();
                break;
            }
            side->draw();
            spent += side->renderSeconds();
        }
        m_lastDrawn = next;
    }
    double others = 0;
    for (const SideView* side : m_sides)
        if (side != nullptr && side->isVisible())
            others += side->renderSeconds();
    m_view->setTimeOfOthers(others);
}

void ViewGrid::setSamples(int samples)
{
    m_samples = samples;
    m_view->setSamples(samples);
    for (SideView* side : m_sides)
        if (side != nullptr)
            side->setSamples(samples);
}

void ViewGrid::paintEvent(QPaintEvent* /*event*/)
{
    if (isSingle())
        return;
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Highlight));
    constexpr int rim = ViewCells::rim;
    painter.drawRect(cell(m_active).adjusted(-rim, -rim, rim, rim));
}

void ViewGrid::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    layOut(Cameras::keep);
}

void ViewGrid::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    layOut(areSeveral() ? Cameras::keepWhole : Cameras::keep);
}

} // namespace knead
