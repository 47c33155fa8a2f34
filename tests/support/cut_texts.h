#pragma once

#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QString>
#include <QStringList>
#include <QStyle>
#include <QStyleOptionButton>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QToolButton>
#include <QTreeView>
#include <QWidget>

#include <algorithm>

namespace knead {

/// Finds words in a window that do not fit where they stand.
namespace cutTexts {

/// "QLabel clearance: 140 x 17 in 118 x 17: Clearance to the wall"
inline QString report(const QWidget& widget, QSize needed, QSize room, const QString& text)
{
    return QStringLiteral("%1 %2: %3 x %4 in %5 x %6: %7")
        .arg(widget.metaObject()->className(), widget.objectName())
        .arg(needed.width())
        .arg(needed.height())
        .arg(room.width())
        .arg(room.height())
        .arg(text);
}

/// Where a button writes: without its rim and its picture [pixels].
inline int roomOf(const QAbstractButton& button)
{
    const QSize hint = button.sizeHint();
    const int words = button.fontMetrics().size(Qt::TextShowMnemonic, button.text()).width();
    return button.width() - (hint.width() - words); // what it has besides its words stays
}

inline void lookAtLabel(const QLabel& label, QStringList& found)
{
    if (label.text().isEmpty() || !label.pixmap().isNull())
        return;
    const int width = label.contentsRect().width();
    const int around = label.width() - width;
    QSize needed = label.wordWrap() ? QSize(label.minimumSizeHint().width(), label.heightForWidth(label.width()))
                                    : label.sizeHint();
    if (label.wordWrap()) { // by its longest word
        needed.setWidth(0);
        for (const QString& word : label.text().split(QRegularExpression("\\s"), Qt::SkipEmptyParts))
            needed.setWidth(std::max(needed.width(), label.fontMetrics().horizontalAdvance(word) + around));
    }
    if (needed.width() > label.width() || needed.height() > label.height())
        found << report(label, needed, label.size(), label.text());
}

inline void lookAtButton(const QAbstractButton& button, QStringList& found)
{
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    if (button.text().isEmpty() || (tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly))
        return;
    const QSize words = button.fontMetrics().size(Qt::TextShowMnemonic, button.text());
    if (words.width() > roomOf(button) || button.height() < button.minimumSizeHint().height())
        found << report(button, words, QSize(roomOf(button), button.height()), button.text());
}

inline void lookAtChoice(const QComboBox& choice, QStringList& found)
{
    QStyleOptionComboBox option;
    option.initFrom(&choice);
    option.editable = choice.isEditable();
    const QRect room =
        choice.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &choice);
    for (int i = 0; i < choice.count(); ++i) {
        const int picture = choice.itemIcon(i).isNull() ? 0 : choice.iconSize().width() + 4;
        const QSize words = choice.fontMetrics().size(0, choice.itemText(i));
        if (words.width() + picture > room.width() && choice.itemData(i, Qt::ToolTipRole).toString().isEmpty())
            found << report(choice, words, room.size() - QSize(picture, 0), choice.itemText(i));
    }
}

inline void lookAtHeader(const QHeaderView& header, QStringList& found)
{
    for (int i = 0; i < header.count(); ++i) {
        const QString text = header.model()->headerData(i, header.orientation()).toString();
        const bool isWide = header.orientation() == Qt::Horizontal;
        const int needed = header.fontMetrics().horizontalAdvance(text) + 6;
        if (isWide && !header.isSectionHidden(i) && needed > header.sectionSize(i))
            found << report(header, QSize(needed, 0), QSize(header.sectionSize(i), 0), text);
    }
}

/// What is typed may be long; what a program wrote into a field is to be read.
inline void lookAtField(const QLineEdit& field, QStringList& found)
{
    QStyleOptionFrame option;
    option.initFrom(&field);
    option.lineWidth = field.style()->pixelMetric(QStyle::PM_DefaultFrameWidth, &option, &field);
    const QRect room = field.style()->subElementRect(QStyle::SE_LineEditContents, &option, &field);
    const QString text = field.text().isEmpty() ? field.placeholderText() : field.text();
    const QSize words(field.fontMetrics().horizontalAdvance(text) + 4, field.fontMetrics().height()); // 2 each side
    if (words.width() > room.width())
        found << report(field, words, room.size(), text);
}

/// A tab that has not all of its room elides.
inline void lookAtTabs(const QTabBar& tabs, QStringList& found)
{
    for (int i = 0; i < tabs.count(); ++i) {
        const int room = tabs.tabRect(i).width() - 16; // without its padding
        if (const int words = tabs.fontMetrics().horizontalAdvance(tabs.tabText(i)); words > room)
            found << report(tabs, QSize(words, 0), QSize(room, 0), tabs.tabText(i));
    }
}

inline void lookAtItems(const QTreeView& tree, QStringList& found)
{
    for (QModelIndex row = tree.model()->index(0, 0); row.isValid(); row = tree.indexBelow(row))
        for (int column = 0; column < tree.model()->columnCount(); ++column) {
            const QModelIndex index = row.siblingAtColumn(column);
            const QRect room = tree.visualRect(index);
            const QString text = index.data().toString();
            const int words = tree.fontMetrics().horizontalAdvance(text) + 6;
            if (!tree.isColumnHidden(column) && words > room.width() &&
                index.data(Qt::ToolTipRole).toString().isEmpty())
                found << report(tree, QSize(words, 0), room.size(), text);
        }
}

inline void lookAt(const QWidget& widget, QStringList& found)
{
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        lookAtLabel(*label, found);
    else if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        lookAtButton(*button, found);
    else if (const auto* choice = qobject_cast<const QComboBox*>(&widget))
        lookAtChoice(*choice, found);
    else if (const auto* header = qobject_cast<const QHeaderView*>(&widget))
        lookAtHeader(*header, found);
    else if (const auto* field = qobject_cast<const QLineEdit*>(&widget))
        lookAtField(*field, found);
    else if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
        lookAtTabs(*tabs, found);
    else if (const auto* tree = qobject_cast<const QTreeView*>(&widget))
        lookAtItems(*tree, found);
}

/// Docks behind others wait beside the window, not yet laid out.
inline bool isBehind(const QWidget& widget)
{
    for (const QWidget* owner = &widget; owner != nullptr; owner = owner->parentWidget())
        if (qobject_cast<const QDockWidget*>(owner) != nullptr)
            return !owner->window()->rect().intersects(owner->geometry());
    return false;
}

} // namespace cutTexts

/// What is cut in what is seen of a widget, one line each.
inline QStringList cutTextsIn(const QWidget& owner)
{
    QStringList found;
    for (const QWidget* widget : owner.findChildren<QWidget*>())
        if (widget->isVisible() && !widget->isWindow() && !cutTexts::isBehind(*widget))
            cutTexts::lookAt(*widget, found);
    return found;
}

} // namespace knead
