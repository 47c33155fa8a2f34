#pragma once

#include <QStyledItemDelegate>

namespace knead {

/// Draws the lines of the model tree: the check box of a part as an eye at the right end, a lock beside it. Names are typed
/// without what the line says besides.
class ModelTreeDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    /// The tree asks buttonAt() itself: a click on eye or lock selects nothing.
    bool editorEvent(QEvent* /*event*/, QAbstractItemModel* /*model*/, const QStyleOptionViewItem& /*option*/,
                     const QModelIndex& /*index*/) override
    {
        return false;
    }
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
    bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;

    enum class Button { None, Eye, Lock };
    static Button buttonAt(const QModelIndex& index, const QRect& line, const QPoint& place);
    /// Where the eye and the lock are in a line of the tree.
    static QRect eyeRect(const QRect& line);
    static QRect lockRect(const QRect& line);

signals:
    void renamed(const QModelIndex& index, const QString& name) const;
};

} // namespace knead
