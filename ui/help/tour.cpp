#include "ui/help/tour.h"

#include "ui/frame/docks.h"
#include "ui/frame/workbench.h"
#include "ui/theme.h"

#include <QApplication>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <string_view>

namespace knead {

namespace {

constexpr int cardWidth = 340;
constexpr int cardGap = 14;   // between the place and the card [pixels]
constexpr int frameRim = 5;   // around the place
constexpr int darkness = 150; // of 255

} // namespace

Tour::Tour(QMainWindow& window, std::vector<Step> steps)
    : QWidget(&window)
    , m_window(window)
    , m_steps(std::move(steps))
    , m_card(new QWidget(this))
{
    setObjectName("tour");
    setAttribute(Qt::WA_DeleteOnClose);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Tour of the window"));
    makeCard();
    window.installEventFilter(this);
    hide();
}

void Tour::makeCard()
{
    m_card->setObjectName("tourCard");
    m_card->setAttribute(Qt::WA_StyledBackground);
    m_card->setFixedWidth(withText(cardWidth));
    m_title = new QLabel(m_card);
    m_title->setObjectName("tourTitle");
    m_title->setProperty("role", "title");
    m_text = new QLabel(m_card);
    m_text->setObjectName("tourText");
    m_text->setWordWrap(true);
    m_count = new QLabel(m_card);
    m_count->setProperty("role", "dimmed");
    auto* skip = new QPushButton(tr("End tour"), m_card);
    skip->setObjectName("tourSkip");
    m_back = new QPushButton(tr("Back"), m_card);
    m_back->setObjectName("tourBack");
    m_next = new QPushButton(m_card);
    m_next->setObjectName("tourNext");
    m_next->setProperty("role", "primary");
    for (QPushButton* button : {skip, m_back, m_next})
        button->setFocusPolicy(Qt::NoFocus); // the keys are the tour's
    auto* column = new QVBoxLayout(m_card);
    column->setContentsMargins(18, 16, 18, 14);
    column->setSpacing(8);
    column->addWidget(m_title);
    column->addWidget(m_text);
    auto* row = new QHBoxLayout;
    row->addWidget(m_count);
    row->addStretch();
    row->addWidget(skip);
    row->addWidget(m_back);
    row->addWidget(m_next);
    column->addSpacing(6);
    column->addLayout(row);
    connect(skip, &QPushButton::clicked, this, &QWidget::close);
    connect(m_back, &QPushButton::clicked, this, [this] { go(m_step - 1); });
    connect(m_next, &QPushButton::clicked, this, [this] { go(m_step + 1); });
}

void Tour::begin()
{
    m_focusBefore = QApplication::focusWidget();
    setGeometry(m_window.rect());
    show();
    raise();
    setFocus();
    go(0);
}

/// After the last step it ends.
void Tour::go(int step)
{
    if (step >= static_cast<int>(m_steps.size())) {
        close();
        return;
    }
    m_step = std::max(step, 0);
    const Step& now = m_steps[static_cast<std::size_t>(m_step)];
    m_place = now.place ? now.place() : nullptr;
    raise(); // a panel that was brought to the front lies above all else, the tour included
    m_title->setText(now.title);
    m_text->setText(now.text);
    m_count->setText(tr("%1 of %2").arg(m_step + 1).arg(m_steps.size()));
    m_back->setVisible(m_step > 0);
    m_next->setText(m_step + 1 < static_cast<int>(m_steps.size()) ? tr("Next") : tr("Done"));
    m_card->adjustSize();
    m_card->resize(cardWidth,
                   m_card->heightForWidth(cardWidth) > 0 ? m_card->heightForWidth(cardWidth) : m_card->height());
    arrange();
}

QRect Tour::spot() const
{
    if (m_place == nullptr || !m_place->isVisible())
        return {};
    const QRect place(m_place->mapTo(&m_window, QPoint(0, 0)), m_place->size());
    return place.adjusted(-frameRim, -frameRim, frameRim, frameRim).intersected(rect());
}

/// The card goes where there is room: right of the place, left, below, above; else into the middle.
void Tour::arrange()
{
    setGeometry(m_window.rect());
    const QRect place = spot();
    const QSize size = m_card->size();
    const int y = std::clamp(place.center().y() - size.height() / 2, cardGap,
                             std::max(cardGap, height() - size.height() - cardGap));
    const int x =
        std::clamp(place.center().x() - size.width() / 2, cardGap, std::max(cardGap, width() - size.width() - cardGap));
    QPoint corner = rect().center() - QPoint(size.width() / 2, size.height() / 2);
    if (!place.isEmpty()) {
        if (place.right() + 2 * cardGap + size.width() < width())
            corner = {place.right() + cardGap, y};
        else if (place.left() - 2 * cardGap - size.width() > 0)
            corner = {place.left() - cardGap - size.width(), y};
        else if (place.bottom() + 2 * cardGap + size.height() < height())
            corner = {x, place.bottom() + cardGap};
        else if (place.top() - 2 * cardGap - size.height() > 0)
            corner = {x, place.top() - cardGap - size.height()};
    }
    m_card->move(corner);
    update();
}

bool Tour::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &m_window && event->type() == QEvent::Resize && isVisible())
        arrange();
    return QWidget::eventFilter(watched, event);
}

/// No key is the window's meanwhile.
bool Tour::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void Tour::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath dark;
    dark.addRect(rect());
    const QRect place = spot();
    QPainterPath bright;
    if (!place.isEmpty())
        bright.addRoundedRect(place, 8, 8);
    painter.fillPath(dark.subtracted(bright), QColor(0, 0, 0, darkness));
    painter.strokePath(bright, QPen(palette().color(QPalette::Highlight), 2));
}

void Tour::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Escape:
        close();
        break;
    case Qt::Key_Left:
    case Qt::Key_Backspace:
        go(m_step - 1);
        break;
    case Qt::Key_Right:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
        go(m_step + 1);
        break;
    default:
        break;
    }
}

/// A click beside the card does nothing, so that nothing is done by accident.
void Tour::mousePressEvent(QMouseEvent* event)
{
    event->accept();
}

void Tour::hideEvent(QHideEvent* event)
{
    if (m_focusBefore != nullptr)
        m_focusBefore->setFocus();
    emit ended();
    QWidget::hideEvent(event);
}

std::vector<Tour::Step> windowTour(const Workbench& bench, QWidget& toolBar)
{
    const auto dock = [&docks = bench.docks](std::string_view name) {
        return [&docks, name]() -> QWidget* {
            docks.show(name);
            return &docks.of(name);
        };
    };
    QMainWindow& window = bench.window;
    return {
        {Tour::tr("Open a part"),
         Tour::tr(
             "Drop a STEP, IGES or mesh file here, press Ctrl+O, or begin with an example. It is filled with material "
             "at once."),
         [&window] { return window.centralWidget(); }},
        {Tour::tr("What there is"),
         Tour::tr(
             "Parts, tools and fixtures are listed here. A click selects; the selected one shows in the view, too."),
         dock("modelDock")},
        {Tour::tr("What it is made of"),
         Tour::tr(
             "Choose a material or type its numbers, with any unit: 2 MPa, 0,5 mm, 1.2e3 kg/m³. It takes effect while "
             "time runs."),
         dock("propertiesDock")},
        {Tour::tr("Hold, push, run"),
         Tour::tr("X fixes faces that you click, B adds a block, Space runs time. Drag the block with the left button "
                  "or drive "
                  "it with the arrow keys; the middle button turns the view."),
         [&toolBar] { return &toolBar; }},
        {Tour::tr("Back and forth in time"),
         Tour::tr("Drag along the timeline to look back. Ctrl+Z undoes whatever you did, what was simulated included."),
         dock("timelineDock")},
        {Tour::tr("Everything else"),
         Tour::tr(
             "Ctrl+E exports the part as CAD again. Ctrl+K finds any command by a few letters, F1 opens the handbook, "
             "and the menu Help repeats this tour."),
         [&window] { return window.menuWidget(); }}};
}

} // namespace knead
