#include "ui/interaction/key_cards.h"

#include "ui/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPalette>

namespace knead {

namespace {

constexpr int gap = 3;     // between caps [pixels]
constexpr int padding = 6; // [pixels]
constexpr double smallText = 0.85;

// With room for texts of any size [pixels].
int cap() // edge of a key cap
{
    return withText(20);
}

int title() // height of a name
{
    return withText(17);
}

int foot() // height of the line below
{
    return withText(17);
}

int wideCap() // of up and down
{
    return withText(34);
}

int cardWidth()
{
    return 3 * cap() + wideCap() + 4 * gap + 2 * padding;
}

int cardHeight()
{
    return title() + 2 * cap() + 2 * gap + 2 * padding;
}

struct Words {
    Q_DECLARE_TR_FUNCTIONS(KeyCards)
};

/// One card.
class Card {
public:
    Card(QPainter& painter, const QRect& area, const std::set<int>& pressed, const QPalette& palette, bool isUsed)
        : m_painter(painter)
        , m_area(area)
        , m_pressed(pressed)
        , m_palette(palette)
        , m_isUsed(isUsed)
    {
    }

    void draw(const QString& name, const KeyBindings& keys)
    {
        m_painter.setPen(m_palette.color(QPalette::Mid));
        QColor back = m_palette.color(QPalette::ToolTipBase);
        back.setAlphaF(0.93F);
        m_painter.setBrush(back);
        m_painter.drawRoundedRect(QRectF(m_area).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
        drawName(name);
        // As they lie on the keyboard: away above, left, towards and right below; up and down beside them.
        drawCap(keys.away, 1, 0);
        drawCap(keys.left, 0, 1);
        drawCap(keys.towards, 1, 1);
        drawCap(keys.right, 2, 1);
        drawWideCap(keys.up, 0);
        drawWideCap(keys.down, 1);
    }

private:
    QColor textColor() const
    {
        return m_palette.color(m_isUsed ? QPalette::Active : QPalette::Disabled, QPalette::Text);
    }

    void drawName(const QString& name)
    {
        QFont font = m_painter.font();
        font.setBold(m_isUsed);
        m_painter.setFont(font);
        m_painter.setPen(textColor());
        const QRect line(m_area.left() + padding, m_area.top() + padding / 2, m_area.width() - 2 * padding, title());
        m_painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                           m_painter.fontMetrics().elidedText(name, Qt::ElideRight, line.width()));
    }

    void drawCap(int key, int column, int row)
    {
        drawKey(key, keyName(key), QRect(m_area.left() + padding + column * (cap() + gap), top(row), cap(), cap()));
    }

    /// Up or down.
    void drawWideCap(int key, int row)
    {
        const QRect place(m_area.left() + padding + 3 * (cap() + gap) + gap, top(row), wideCap(), cap());
        const QString arrow = row == 0 ? QStringLiteral("⤒") : QStringLiteral("⤓");
        drawKey(key, keyName(key).size() > 1 ? keyName(key) : keyName(key) + ' ' + arrow, place);
    }

    int top(int row) const { return m_area.top() + title() + padding + row * (cap() + gap) - gap; }

    void drawKey(int key, const QString& text, const QRect& place)
    {
        const bool isLit = m_isUsed && m_pressed.contains(key);
        const QRectF edge = QRectF(place).adjusted(0.5, 0.5, -0.5, -0.5);
        m_painter.setPen(m_palette.color(isLit ? QPalette::Highlight : QPalette::Mid));
        m_painter.setBrush(m_palette.color(isLit ? QPalette::Highlight : QPalette::Button));
        m_painter.drawRoundedRect(edge, 4, 4);
        QFont font = m_painter.font();
        font.setBold(false);
        m_painter.setFont(font);
        m_painter.setPen(isLit ? m_palette.color(QPalette::HighlightedText) : textColor());
        m_painter.drawText(place, Qt::AlignCenter, text);
    }

    QPainter& m_painter;
    QRect m_area;
    const std::set<int>& m_pressed;
    const QPalette& m_palette;
    bool m_isUsed;
};

} // namespace

QSize keyCardsSize()
{
    const int cards = static_cast<int>(drivenTools);
    return {cards * cardWidth() + (cards - 1) * gap * 2, cardHeight() + gap + foot()};
}

void drawKeyCards(QPainter& painter, const QRect& area, const std::array<QString, drivenTools>& names,
                  const std::set<int>& pressed, const QString& speed, const QPalette& palette)
{
    QFont font = painter.font();
    font.setPointSizeF(smallText * font.pointSizeF());
    painter.setFont(font);
    for (std::size_t place = 0; place < drivenTools; ++place) {
        const QRect card(area.left() + static_cast<int>(place) * (cardWidth() + 2 * gap), area.top(), cardWidth(),
                         cardHeight());
        const bool isUsed = !names[place].isEmpty();
        const QString name = isUsed ? names[place] : Words::tr("Tool %1: add one").arg(place + 1);
        Card(painter, card, pressed, palette, isUsed).draw(name, keyBindings()[place]);
    }
    const QRect line(area.left(), area.bottom() - foot(), area.width(), foot());
    QColor back = palette.color(QPalette::ToolTipBase);
    back.setAlphaF(0.85F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(back);
    painter.drawRoundedRect(line, 4, 4);
    painter.setPen(palette.color(QPalette::ToolTipText));
    painter.drawText(line, Qt::AlignCenter, speed);
}

} // namespace knead
