#include "ui/commands/command_palette.h"

#include "ui/commands/availability.h"
#include "ui/commands/fuzzy_match.h"
#include "ui/commands/synonyms.h"
#include "ui/theme.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>

namespace knead {

namespace {

constexpr int usualWidth = 620;
constexpr int gap = 10;
constexpr int rowHeight = 34;
constexpr int mostRows = 11;
constexpr int fromTop = 64; // of the window [pixels]

enum Role { MenuRole = Qt::UserRole, KeysRole, WhyRole, HitsRole };

/// Icon, text with the letters that were meant, menu; at the right the keys, or why it cannot be done.
class RowPainter final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {0, withText(rowHeight)}; }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const QString why = index.data(WhyRole).toString();
        const bool isChosen = option.state.testFlag(QStyle::State_Selected);
        const QPalette& palette = option.palette;
        const QColor text = !why.isEmpty() ? palette.color(QPalette::Disabled, QPalette::Text)
                                           : palette.color(isChosen ? QPalette::HighlightedText : QPalette::Text);
        QColor aside = palette.color(QPalette::PlaceholderText);
        if (isChosen && why.isEmpty())
            aside = text;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        if (isChosen) {
            painter->setPen(Qt::NoPen);
            painter->setBrush(why.isEmpty() ? palette.color(QPalette::Highlight)
                                            : palette.color(QPalette::AlternateBase));
            painter->drawRoundedRect(option.rect.adjusted(4, 1, -4, -1), 5, 5);
        }
        const QRect row = option.rect.adjusted(14, 0, -14, 0);
        const QRect sign(row.left(), row.center().y() - 9, 18, 18);
        const QIcon::Mode mode = !why.isEmpty() ? QIcon::Disabled : isChosen ? QIcon::Selected : QIcon::Normal;
        index.data(Qt::DecorationRole).value<QIcon>().paint(painter, sign, Qt::AlignCenter, mode);
        const int right = drawAside(painter, row, why.isEmpty() ? index.data(KeysRole).toString() : why, aside);
        const QRect rest(row.left() + 28, row.top(), right - row.left() - 40, row.height());
        const int end = drawText(painter, rest, index, text);
        painter->setPen(aside);
        const QRect place(end + 10, row.top(), std::max(0, rest.right() - end - 10), row.height());
        painter->drawText(
            place, Qt::AlignVCenter | Qt::AlignLeft,
            painter->fontMetrics().elidedText(index.data(MenuRole).toString(), Qt::ElideRight, place.width()));
        painter->restore();
    }

private:
    /// @return where it begins
    static int drawAside(QPainter* painter, const QRect& row, const QString& text, const QColor& color)
    {
        painter->setPen(color);
        const int taken = std::min(painter->fontMetrics().horizontalAdvance(text), row.width() * 3 / 5);
        const QRect place(row.right() - taken, row.top(), taken + 1, row.height());
        painter->drawText(place, Qt::AlignVCenter | Qt::AlignRight,
                          painter->fontMetrics().elidedText(text, Qt::ElideRight, taken + 1));
        return place.left();
    }

    /// @return where it ends
    static int drawText(QPainter* painter, const QRect& place, const QModelIndex& index, const QColor& color)
    {
        const QString text = index.data(Qt::DisplayRole).toString();
        const QVariantList hits = index.data(HitsRole).toList();
        const QFont usual = painter->font();
        QFont bold = usual;
        bold.setBold(true);
        int x = place.left();
        painter->setPen(color);
        const auto isHit = [&hits](qsizetype i) { return hits.contains(QVariant::fromValue(i)); };
        for (qsizetype i = 0, end = 0; i < text.size() && x < place.right(); i = end) {
            end = i + 1;
            while (end < text.size() && isHit(end) == isHit(i))
                ++end;
            const QString run = text.mid(i, end - i);
            painter->setFont(isHit(i) ? bold : usual);
            painter->drawText(QRect(x, place.top(), place.right() - x, place.height()),
                              Qt::AlignVCenter | Qt::AlignLeft, run);
            x += painter->fontMetrics().horizontalAdvance(run);
        }
        painter->setFont(usual);
        return x;
    }
};

struct Ranked {
    const ListedAction* one;
    int rank;
    QList<qsizetype> hits;
    QString synonym; ///< by which it was found; empty: by its text or its menu
};

struct SynonymMatch {
    int score = 0;
    QString word;
};

/// The synonym that fits best. One that was typed as a whole is what is meant.
std::optional<SynonymMatch> bestSynonym(const QString& wanted, const QString& action)
{
    constexpr qsizetype fewest = 2; // letters, so that not everything is found by one
    constexpr int whole = 8;
    if (wanted.trimmed().size() < fewest)
        return std::nullopt;
    std::optional<SynonymMatch> best;
    for (const QString& word : synonymsOf(action))
        if (const std::optional<FuzzyMatch> match = wordMatch(wanted, word)) {
            const int score = match->score + (match->hits.size() == word.size() ? whole : 0);
            if (!best || score > best->score)
                best = SynonymMatch{score, word};
        }
    return best;
}

/// By its text; else by a synonym, or by menu and text together, which counts less. What can be done comes before what cannot, and a
/// tool or a command before a file that is called like it: "plate" is the tool for the part that is open, not the example in place of it.
std::optional<Ranked> rank(const ListedAction& one, const QString& wanted, qsizetype lastDone)
{
    constexpr int ownText = 20;
    constexpr int ownSynonym = 10;
    constexpr int doneLately = 12;
    constexpr int ofFile = -4;
    const int lately = lastDone < 0 ? 0 : std::max(1, doneLately - static_cast<int>(lastDone));
    const int file = one.action->property(opensFile).toBool() ? ofFile : 0;
    const int besides = lately + file + (one.action->isEnabled() ? ownText : 0);
    std::optional<Ranked> best;
    const auto offer = [&](int score, const QList<qsizetype>& hits, const QString& synonym) {
        if (!best || score + besides > best->rank)
            best = Ranked{&one, score + besides, hits, synonym};
    };
    if (const std::optional<FuzzyMatch> own = fuzzyMatch(wanted, one.text))
        offer(own->score + ownText, own->hits, {});
    else if (const std::optional<FuzzyMatch> inMenu = fuzzyMatch(wanted, one.menu + ' ' + one.text))
        offer(inMenu->score, {}, {});
    if (const std::optional<SynonymMatch> synonym = bestSynonym(wanted, one.action->objectName()))
        offer(synonym->score + ownSynonym, {}, synonym->word);
    return best;
}

} // namespace

CommandPalette::CommandPalette(QMainWindow& window)
    : QFrame(&window)
    , m_window(window)
    , m_field(new QLineEdit(this))
    , m_list(new QListWidget(this))
{
    setObjectName("commandPalette");
    setAutoFillBackground(true);
    m_field->setObjectName("paletteField");
    m_field->setPlaceholderText(tr("What do you want to do?"));
    m_field->setAccessibleName(m_field->placeholderText());
    m_field->setMinimumHeight(32);
    m_list->setObjectName("paletteList");
    m_list->setItemDelegate(new RowPainter(m_list));
    m_list->setUniformItemSizes(true);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setMouseTracking(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(gap, gap, gap, gap);
    column->setSpacing(gap);
    column->addWidget(m_field);
    column->addWidget(m_list);
    m_field->installEventFilter(this);
    m_window.installEventFilter(this);
    connect(m_field, &QLineEdit::textEdited, this, &CommandPalette::list);
    connect(m_list, &QListWidget::itemClicked, this, &CommandPalette::doCurrent);
    hide();
}

void CommandPalette::open()
{
    if (isHidden())
        m_focusBefore = QApplication::focusWidget();
    m_actions = listedActions(m_window);
    m_field->clear();
    list({});
    place();
    show();
    raise();
    m_field->setFocus(Qt::PopupFocusReason);
}

std::vector<ListedAction> CommandPalette::shown() const
{
    return m_shown;
}

void CommandPalette::list(const QString& wanted)
{
    std::erase_if(m_actions, [](const ListedAction& one) { return one.action == nullptr; });
    std::vector<Ranked> found;
    for (const ListedAction& one : m_actions)
        if (std::optional<Ranked> ranked = rank(one, wanted, m_lastDone.indexOf(one.action->objectName())))
            found.push_back(std::move(*ranked));
    const auto lastDone = [this](const Ranked& ranked) {
        const qsizetype at = m_lastDone.indexOf(ranked.one->action->objectName());
        return at < 0 ? m_lastDone.size() : at;
    };
    if (wanted.trimmed().isEmpty()) // as in the menus, after what was done last
        std::ranges::stable_sort(found, std::ranges::less(), lastDone);
    else
        std::ranges::stable_sort(found, std::ranges::greater(), &Ranked::rank);
    m_list->clear();
    m_shown.clear();
    for (const Ranked& ranked : found)
        addRow(*ranked.one, ranked.hits, ranked.synonym);
    m_list->setCurrentRow(0);
    place();
    if (found.empty()) {
        auto* none = new QListWidgetItem(tr("Nothing is called like that: try fewer letters."), m_list);
        none->setFlags(Qt::NoItemFlags);
    }
}

void CommandPalette::addRow(const ListedAction& one, const QList<qsizetype>& hits, const QString& synonym)
{
    const QAction& action = *one.action;
    QString why;
    if (!action.isEnabled())
        why = Availability::whyNot(action);
    if (!action.isEnabled() && why.isEmpty())
        why = tr("Not possible now.");
    auto* item = new QListWidgetItem(action.icon(), one.text, m_list);
    QVariantList letters;
    for (const qsizetype hit : hits)
        letters << QVariant::fromValue(hit);
    item->setData(MenuRole, synonym.isEmpty() ? one.menu : QStringLiteral("%1 (%2)").arg(one.menu, synonym));
    item->setData(KeysRole, QKeySequence::listToString(action.shortcuts(), QKeySequence::NativeText));
    item->setData(WhyRole, why);
    item->setData(HitsRole, letters);
    item->setData(Qt::AccessibleTextRole, QStringLiteral("%1, %2").arg(one.text, one.menu));
    item->setToolTip(action.toolTip());
    if (action.isCheckable() && action.isChecked())
        item->setText(one.text + QStringLiteral("  ✓"));
    m_shown.push_back(one);
}

void CommandPalette::place()
{
    const int rows = std::clamp(static_cast<int>(m_shown.size()), 1, mostRows);
    m_list->setFixedHeight(rows * withText(rowHeight) + 2 * m_list->frameWidth() + 2);
    const int height = m_field->minimumHeight() + m_list->height() + 3 * gap;
    const QSize size(std::min(usualWidth, m_window.width() - 40), height);
    setGeometry(QRect(QPoint((m_window.width() - size.width()) / 2, std::min(fromTop, m_window.height() / 8)), size));
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &m_window) {
        if (event->type() == QEvent::Resize && isVisible())
            place();
        return false;
    }
    if (event->type() == QEvent::FocusOut && static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason)
        hide();
    const bool isKey = event->type() == QEvent::KeyPress;
    if (!isKey && event->type() != QEvent::ShortcutOverride)
        return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const int page = mostRows - 1;
    const std::pair<int, int> steps[] = {
        {Qt::Key_Down, 1}, {Qt::Key_Up, -1}, {Qt::Key_PageDown, page}, {Qt::Key_PageUp, -page}};
    const auto* move = std::ranges::find(steps, key.key(), &std::pair<int, int>::first);
    const bool isDone = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    if (move == std::end(steps) && !isDone && key.key() != Qt::Key_Escape)
        return false;
    event->accept(); // it is not the window's
    if (!isKey)
        return true;
    if (isDone)
        doCurrent();
    else if (key.key() == Qt::Key_Escape)
        leave();
    else
        step(move->second);
    return true;
}

void CommandPalette::step(int rows)
{
    const int count = m_list->count();
    const int row = m_list->currentRow() + rows;
    const bool isOne = std::abs(rows) == 1;
    m_list->setCurrentRow(isOne ? (row + count) % count : std::clamp(row, 0, count - 1));
}

void CommandPalette::doCurrent()
{
    const int row = m_list->currentRow();
    if (row < 0 || row >= static_cast<int>(m_shown.size()))
        return;
    const QPointer<QAction> action = m_shown[static_cast<std::size_t>(row)].action;
    if (action == nullptr || !action->isEnabled())
        return;
    constexpr qsizetype most = 6;
    leave();
    if (!action->objectName().isEmpty()) {
        m_lastDone.removeAll(action->objectName());
        m_lastDone.prepend(action->objectName());
        m_lastDone = m_lastDone.first(std::min(most, m_lastDone.size()));
    }
    action->trigger();
}

/// The keyboard goes back to where it was.
void CommandPalette::leave()
{
    if (isHidden())
        return;
    hide();
    if (m_focusBefore != nullptr && m_focusBefore->isVisible())
        m_focusBefore->setFocus(Qt::PopupFocusReason);
}

} // namespace knead
