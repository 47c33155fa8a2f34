#include "ui/help/tour.h"

#include "ui/theme.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>
#include <QPushButton>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>
#include <utility>

namespace knead {

namespace {

constexpr int tourWidth = 320;
constexpr int tourGap = 14;           // between the place and the card, and to the rim of the window [pixels]
constexpr int ringRim = 5;            // between the place and the ring [pixels]
constexpr int tourLookInterval = 120; // [ms]
constexpr int tourGoOnDelay = 900;    // to be seen that it was noticed [ms]

qint64 areaOf(const QRect& rect)
{
    return rect.isEmpty() ? 0 : qint64(rect.width()) * rect.height();
}

} // namespace

/// Around what is to be clicked; the mouse does not know of it.
class Tour::Ring final : public QWidget {
public:
    explicit Ring(QWidget* parent)
        : QWidget(parent)
    {
        setObjectName("tourRing");
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::NoFocus);
        hide();
    }

protected:
    void paintEvent(QPaintEvent* /*event*/) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QRectF line = QRectF(rect()).adjusted(2, 2, -2, -2);
        painter.setPen(QPen(palette().color(QPalette::Base), 4)); // seen on dark and on light
        painter.drawRoundedRect(line, 8, 8);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawRoundedRect(line, 8, 8);
    }
};

Tour::Tour(QMainWindow& window, std::vector<Step> steps, QWidget& beside)
    : QFrame(&window)
    , m_window(window)
    , m_steps(std::move(steps))
    , m_ring(new Ring(&window))
    , m_looking(new QTimer(this))
    , m_goingOn(new QTimer(this))
{
    setObjectName("tour");
    setAttribute(Qt::WA_DeleteOnClose);
    setAttribute(Qt::WA_StyledBackground);
    setFixedWidth(withText(tourWidth));
    makeCard(beside);
    m_looking->setInterval(tourLookInterval);
    m_goingOn->setSingleShot(true);
    m_goingOn->setInterval(tourGoOnDelay);
    connect(m_looking, &QTimer::timeout, this, &Tour::look);
    connect(m_goingOn, &QTimer::timeout, this, [this] { go(m_step + 1); });
    hide();
}

Tour::~Tour()
{
    delete m_ring;
}

void Tour::makeCard(QWidget& beside)
{
    m_title = new QLabel(this);
    m_title->setObjectName("tourTitle");
    m_title->setProperty("role", "title");
    m_text = new QLabel(this);
    m_text->setObjectName("tourText");
    m_text->setWordWrap(true);
    m_count = new QLabel(this);
    m_count->setProperty("role", "dimmed");
    m_back = new QPushButton(tr("Back"), this);
    m_back->setObjectName("tourBack");
    m_skip = new QPushButton(tr("Skip"), this);
    m_skip->setObjectName("tourSkip");
    m_skip->setToolTip(tr("Go on without doing this"));
    m_end = new QPushButton(tr("End"), this);
    m_end->setObjectName("tourEnd");
    m_end->setToolTip(tr("End the tour; the part stays open"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(18, 14, 18, 12);
    column->setSpacing(8);
    column->addWidget(m_title);
    column->addWidget(m_text);
    auto* row = new QHBoxLayout;
    row->addWidget(m_count);
    row->addStretch();
    for (QPushButton* button : {m_back, m_skip, m_end}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    column->addLayout(row);
    setTabOrder(&beside, m_back);
    setTabOrder(m_back, m_skip);
    setTabOrder(m_skip, m_end);
    connect(m_back, &QPushButton::clicked, this, [this] { go(m_step - 1); });
    connect(m_skip, &QPushButton::clicked, this, [this] { go(m_step + 1); });
    connect(m_end, &QPushButton::clicked, this, &QWidget::close);
}

void Tour::begin()
{
    show();
    m_looking->start();
    go(0);
}

/// After the last step it ends.
void Tour::go(int step)
{
    m_goingOn->stop();
    if (step >= static_cast<int>(m_steps.size())) {
        close();
        return;
    }
    m_step = std::max(step, 0);
    m_isDone = false;
    if (now().begin)
        now().begin();
    say();
    arrange(true);
}

void Tour::say()
{
    const bool isLast = m_step + 1 == static_cast<int>(m_steps.size());
    const QString title = now().title();
    m_title->setText(m_isDone ? QStringLiteral("✓ ") + title : title);
    m_text->setText(now().text());
    m_count->setText(isLast ? QString() : tr("%1 of %2").arg(m_step + 1).arg(m_steps.size() - 1)); // that are done
    const QWidget* had = QApplication::focusWidget();
    m_back->setVisible(m_step > 0);
    m_skip->setVisible(!isLast);
    if (had != nullptr && isAncestorOf(had) && !had->isVisible()) // the keyboard stays on the card
        (isLast ? m_end : m_skip)->setFocus();
    setAccessibleName(tr("Tour: %1").arg(title));
    setAccessibleDescription(m_text->text());
    layout()->activate();
    const int height = heightForWidth(width());
    resize(width(), height > 0 ? height : sizeHint().height());
}

void Tour::look()
{
    if (!m_isDone && now().isDone && now().isDone()) {
        m_isDone = true;
        say();
        m_goingOn->start();
    }
    arrange(false);
}

QRect Tour::spot() const
{
    const QRect place = now().place ? now().place() : QRect();
    return place.isEmpty() ? QRect()
                           : place.adjusted(-ringRim, -ringRim, ringRim, ringRim).intersected(m_window.rect());
}

/// So much of what should be seen or clicked a card would hide; of what is pointed at, nothing may be [pixels].
qint64 Tour::covered(const QRect& card) const
{
    constexpr int never = 1000;
    qint64 most = never * areaOf(card.intersected(spot()));
    if (now().uncovered)
        for (const QRect& free : now().uncovered())
            most += areaOf(card.intersected(free));
    return most;
}

/// Right of the place, left, below, above, else in a corner of the middle of the window or of the window: the first that covers
/// least.
QPoint Tour::cornerBeside(const QRect& place) const
{
    const int below = m_window.statusBar()->height() + tourGap / 2; // what it says is to be read
    const QRect room = m_window.rect().adjusted(tourGap, tourGap, -tourGap, -below);
    const auto within = [&](int x, int y) {
        return QPoint(std::clamp(x, room.left(), std::max(room.left(), room.right() - width())),
                      std::clamp(y, room.top(), std::max(room.top(), room.bottom() - height())));
    };
    const QWidget* center = m_window.centralWidget();
    const QRect views(center->mapTo(&m_window, QPoint(0, 0)), center->size());
    const int x = place.center().x() - width() / 2;
    const int y = place.center().y() - height() / 2;
    QList<QPoint> corners;
    if (!place.isEmpty())
        corners << within(place.right() + tourGap, y) << within(place.left() - tourGap - width(), y)
                << within(x, place.bottom() + tourGap) << within(x, place.top() - tourGap - height());
    for (const QRect& area : {views.adjusted(tourGap, tourGap, -tourGap, -tourGap), room})
        for (const int left : {area.right() - width(), area.left()})
            for (const int top : {area.bottom() - height(), area.top()})
                corners << within(left, top);
    return *std::ranges::min_element(corners, {}, [&](const QPoint& corner) { return covered(QRect(corner, size())); });
}

/// The card stays where it is as long as it is in nobody's way there.
void Tour::arrange(bool isNew)
{
    const QRect place = spot();
    if (isNew || !m_window.rect().contains(geometry()) || covered(geometry()) > 0)
        move(cornerBeside(place));
    if (m_ring->geometry() != place)
        m_ring->setGeometry(place);
    m_ring->setVisible(!place.isEmpty());
    if (isNew) { // a panel that was brought to the front lies above all else
        m_ring->raise();
        raise();
    }
}

/// Where the card has the keyboard, keys of its buttons are not the window's: Space would let time run.
bool Tour::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        constexpr int own[] = {Qt::Key_Escape, Qt::Key_Space, Qt::Key_Return, Qt::Key_Enter};
        if (std::ranges::find(own, static_cast<QKeyEvent*>(event)->key()) != std::end(own)) {
            event->accept();
            return true;
        }
    }
    return QFrame::event(event);
}

void Tour::changeEvent(QEvent* event)
{
    const bool isLarger = event->type() == QEvent::FontChange && isVisible();
    if (isLarger)
        setFixedWidth(withText(tourWidth));
    if (isLarger || (event->type() == QEvent::LanguageChange && isVisible())) {
        say();
        arrange(true);
    }
    QFrame::changeEvent(event);
}

void Tour::keyPressEvent(QKeyEvent* event)
{
    auto* button = qobject_cast<QPushButton*>(focusWidget());
    if (event->key() == Qt::Key_Escape)
        close();
    else if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && button != nullptr)
        button->click();
    else
        QFrame::keyPressEvent(event);
}

void Tour::closeEvent(QCloseEvent* event)
{
    m_looking->stop();
    m_goingOn->stop();
    m_ring->hide();
    emit ended();
    QFrame::closeEvent(event);
}

} // namespace knead
