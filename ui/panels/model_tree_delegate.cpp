#include "ui/panels/model_tree_delegate.h"

#include "ui/panels/model_tree.h"
#include "ui/theme.h"

#include <QApplication>
#include <QHelpEvent>
#include <QLineEdit>
#include <QPainter>
#include <QToolTip>

namespace knead {

namespace {

constexpr int iconSide = 16; // of eye and lock [pixels]
constexpr int margin = 5;    // around them

bool hasEye(const QModelIndex& index)
{
    return index.data(Qt::CheckStateRole).isValid() && index.flags() & Qt::ItemIsUserCheckable;
}

bool hasLock(const QModelIndex& index)
{
    return index.data(tree_roles::lock).isValid();
}

bool isHiddenLine(const QModelIndex& index)
{
    return hasEye(index) && index.data(Qt::CheckStateRole).toInt() == Qt::Unchecked;
}

} // namespace

QRect ModelTreeDelegate::eyeRect(const QRect& line)
{
    return {line.right() - margin - iconSide, line.center().y() - iconSide / 2, iconSide, iconSide};
}

QRect ModelTreeDelegate::lockRect(const QRect& line)
{
    return eyeRect(line).translated(-iconSide - margin, 0);
}

void ModelTreeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QStyleOptionViewItem line = option;
    initStyleOption(&line, index);
    line.features &= ~QStyleOptionViewItem::HasCheckIndicator;
    const bool isSelected = line.state & QStyle::State_Selected;
    const QStyle* style = line.widget->style();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &line, painter, line.widget);
    const bool isHidden = isHiddenLine(index);
    if (isHidden && !isSelected)
        line.palette.setColor(QPalette::Text, line.palette.color(QPalette::PlaceholderText));
    if (hasEye(index) || hasLock(index))
        line.rect.setRight(lockRect(option.rect).left() - margin);
    style->drawControl(QStyle::CE_ItemViewItem, &line, painter, line.widget);

    static const QIcon eye = icon("eye");
    static const QIcon noEye = icon("eye-off");
    static const QIcon lock = icon("lock");
    static const QIcon noLock = icon("unlock");
    const bool isUnderMouse = line.state & QStyle::State_MouseOver;
    const QIcon::Mode strong = isSelected ? QIcon::Selected : QIcon::Normal;
    const QIcon::Mode weak = isSelected ? QIcon::Selected : QIcon::Disabled;
    if (hasEye(index))
        (isHidden ? noEye : eye)
            .paint(painter, eyeRect(option.rect), Qt::AlignCenter, isHidden || isUnderMouse ? strong : weak);
    const bool isLocked = index.data(tree_roles::lock).toBool();
    if (hasLock(index) && (isLocked || isUnderMouse))
        (isLocked ? lock : noLock).paint(painter, lockRect(option.rect), Qt::AlignCenter, isLocked ? strong : weak);
}

ModelTreeDelegate::Button ModelTreeDelegate::buttonAt(const QModelIndex& index, const QRect& line, const QPoint& place)
{
    const QMargins around(margin / 2, margin, margin / 2, margin);
    if (hasEye(index) && (eyeRect(line) + around).contains(place))
        return Button::Eye;
    return hasLock(index) && (lockRect(line) + around).contains(place) ? Button::Lock : Button::None;
}

void ModelTreeDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const
{
    if (auto* field = qobject_cast<QLineEdit*>(editor))
        field->setText(index.data(tree_roles::name).toString());
}

void ModelTreeDelegate::setModelData(QWidget* editor, QAbstractItemModel* /*model*/, const QModelIndex& index) const
{
    if (const auto* field = qobject_cast<QLineEdit*>(editor))
        emit renamed(index, field->text());
}

bool ModelTreeDelegate::helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                                  const QModelIndex& index)
{
    QString tip;
    const Button button = buttonAt(index, option.rect, event->pos());
    if (button == Button::Eye)
        tip = isHiddenLine(index) ? tr("Show (H)") : tr("Hide (H)");
    else if (button == Button::Lock)
        tip = index.data(tree_roles::lock).toBool() ? tr("Unlock (L)") : tr("Lock: keep it from being changed (L)");
    if (tip.isEmpty())
        return QStyledItemDelegate::helpEvent(event, view, option, index);
    QToolTip::showText(event->globalPos(), tip, view);
    return true;
}

} // namespace knead
