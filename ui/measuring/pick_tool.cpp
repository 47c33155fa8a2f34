#include "ui/measuring/pick_tool.h"

#include "ui/document/document.h"
#include "ui/viewport/viewport_widget.h"

#include <QMouseEvent>

#include <utility>

namespace knead {

PickTool::PickTool(const Document& document, ViewportWidget& view, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_view(view)
    , m_picker(document, view)
{
    connect(&document, &Document::changed, this, [this](Document::Change what) {
        if (what != Document::Change::Model)
            return;
        m_picker.forget();
        stop();
    });
}

void PickTool::begin(const QString& title, std::vector<PickWhat> picks, Done done)
{
    m_view.removeEventFilter(this);
    m_view.installEventFilter(this);
    m_title = title;
    m_wanted = std::move(picks);
    m_done = std::move(done);
    m_picked.clear();
    m_hovered.reset();
    m_view.forgetHover();
    m_view.setCursor(Qt::CrossCursor);
    emit begun();
    emit changed();
}

void PickTool::setTitle(const QString& title)
{
    m_title = title;
    emit changed();
}

void PickTool::stop()
{
    if (!isPicking())
        return;
    m_view.removeEventFilter(this);
    m_wanted.clear();
    m_picked.clear();
    m_hovered.reset();
    m_hasPress = false;
    m_view.setHighlight({});
    m_view.setCursor(Qt::ArrowCursor);
    emit changed();
    emit stopped();
}

QString PickTool::prompt() const
{
    if (!isPicking())
        return {};
    const std::size_t step = m_picked.size();
    const bool isOnly = m_wanted.size() == 1;
    QString what;
    switch (wanted()) {
    case PickWhat::place:
        what = isOnly ? tr("click a place") : tr("click place %1 of %2").arg(step + 1).arg(m_wanted.size());
        if (!isOnly && m_wanted.back() != PickWhat::place)
            what = tr("click a place");
        break;
    case PickWhat::face:
        what = isOnly || m_wanted.front() != PickWhat::face
                   ? tr("click a face")
                   : tr("click face %1 of %2").arg(step + 1).arg(m_wanted.size());
        break;
    case PickWhat::body:
        what = tr("click a part");
        break;
    }
    return tr("%1: %2   Esc: done").arg(m_title, what);
}

/// A press is taken with its release, so that nothing else sees half of a click; what was pressed before goes its way.
bool PickTool::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != &m_view || !isPicking())
        return false;
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        if (auto* mouse = static_cast<QMouseEvent*>(event); mouse->button() == Qt::LeftButton &&
                                                            !m_view.isForNavigation(*mouse) &&
                                                            !m_view.isOnCube(mouse->position())) {
            m_hasPress = true;
            take(mouse->position());
            return true;
        }
        return false;
    case QEvent::MouseButtonRelease:
        return static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton && std::exchange(m_hasPress, false);
    case QEvent::MouseMove: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (mouse->buttons() != Qt::NoButton)
            return m_hasPress && mouse->buttons() == Qt::LeftButton;
        hoverFrom(eye(), mouse->position());
        return true;
    }
    case QEvent::Leave:
        leave();
        return false;
    default:
        return false;
    }
}

SkinPicker::Eye PickTool::eye() const
{
    return {m_view.camera(), m_view.window()};
}

void PickTool::hoverFrom(const SkinPicker::Eye& eye, const QPointF& position)
{
    if (!isPicking())
        return;
    m_hovered = m_picker.pick(eye, position, wanted() == PickWhat::place);
    std::optional<SceneMarks::Face> face;
    if (m_hovered && wanted() == PickWhat::face)
        if (const auto found = faceOf(m_hovered->place, *m_document.content().bodies[m_hovered->place.body]))
            face = SceneMarks::Face{m_hovered->place.body, *found};
    m_view.setHighlight(face);
    m_view.setCursor(Qt::CrossCursor);
    emit changed();
}

void PickTool::leave()
{
    if (!isPicking())
        return;
    m_hovered.reset();
    m_view.setHighlight({});
    emit changed();
}

void PickTool::take(const QPointF& position)
{
    const auto hit = m_picker.pick(eye(), position, wanted() == PickWhat::place);
    if (!hit)
        return emit refused(tr("There is nothing at that place: click on a part."));
    if (wanted() == PickWhat::face && !faceOf(hit->place, *m_document.content().bodies[hit->place.body]))
        return emit refused(tr("This part is a mesh without CAD faces: measure it with places instead."));
    m_picked.push_back(hit->place);
    if (m_picked.size() == m_wanted.size())
        m_done(std::exchange(m_picked, {}));
    emit changed();
}

} // namespace knead
