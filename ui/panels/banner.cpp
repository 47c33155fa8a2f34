#include "ui/panels/banner.h"

#include "ui/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>

namespace knead {

namespace {

constexpr int bannerInset = 8;    // from the lower edge of the view [px]
constexpr int widestBanner = 700; // beyond it the sentence takes another line [px]
constexpr int besideText = 220;   // sign, buttons and edges [px]

} // namespace

Banner::Banner(QWidget* parent)
    : QFrame(parent)
    , m_sign(new QLabel(this))
    , m_sentence(new QLabel(this))
    , m_remedy(new QToolButton(this))
    , m_other(new QToolButton(this))
{
    setObjectName("banner");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 8, 8, 8);
    drawSign();
    m_sentence->setObjectName("bannerText");
    m_sentence->setWordWrap(true);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_remedy->setObjectName("bannerRemedy");
    m_other->setObjectName("bannerOther");
    auto* close = new QToolButton(this);
    close->setObjectName("bannerClose");
    close->setIcon(icon("close"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close"));
    close->setAccessibleName(close->toolTip());
    row->addWidget(m_sign);
    row->addWidget(m_sentence, 1);
    row->addWidget(m_remedy);
    row->addWidget(m_other);
    row->addWidget(close);
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    connect(m_remedy, &QToolButton::clicked, this, &Banner::remedyClicked);
    connect(m_other, &QToolButton::clicked, this, &Banner::otherClicked);
    hide();
}

void Banner::drawSign()
{
    m_sign->setPixmap(icon("warning").pixmap(QSize(20, 20), devicePixelRatioF()));
}

void Banner::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        drawSign();
    QFrame::changeEvent(event);
}

void Banner::layOver(QWidget& view)
{
    m_view = &view;
    view.installEventFilter(this);
    place();
}

/// Its sentence is another one when the language changes.
bool Banner::event(QEvent* event)
{
    const bool isTaken = QFrame::event(event);
    if (event->type() == QEvent::LayoutRequest)
        place();
    return isTaken;
}

bool Banner::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_view && (event->type() == QEvent::Resize || event->type() == QEvent::Move))
        place();
    return QFrame::eventFilter(watched, event);
}

/// In the middle of the lower edge, as high as its sentence takes: cubes, names of views and captions lie at the upper one.
void Banner::place()
{
    if (m_view == nullptr)
        return;
    const QRect view = m_view->geometry();
    const int text = m_sentence->fontMetrics().horizontalAdvance(m_sentence->text());
    const int width = std::min({view.width() - 2 * bannerInset, widestBanner, text + besideText});
    ensurePolished();
    layout()->activate();
    const int height = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : sizeHint().height();
    setGeometry(view.center().x() - width / 2, view.bottom() - bannerInset - height, width, height);
    raise();
}

void Banner::show(const QString& sentence, const QString& remedy, const QString& other)
{
    m_sentence->setText(sentence);
    setAccessibleName(sentence);
    m_remedy->setText(remedy);
    m_remedy->setVisible(!remedy.isEmpty());
    m_other->setText(other);
    m_other->setVisible(!other.isEmpty());
    QFrame::show();
    place();
}

QString Banner::sentence() const
{
    return isHidden() ? QString() : m_sentence->text();
}

} // namespace knead
