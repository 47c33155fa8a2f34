#include "ui/panels/banner.h"

#include "ui/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace knead {

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

void Banner::show(const QString& sentence, const QString& remedy, const QString& other)
{
    m_sentence->setText(sentence);
    m_remedy->setText(remedy);
    m_remedy->setVisible(!remedy.isEmpty());
    m_other->setText(other);
    m_other->setVisible(!other.isEmpty());
    QFrame::show();
}

QString Banner::sentence() const
{
    return isHidden() ? QString() : m_sentence->text();
}

} // namespace knead
