#include "ui/panels/place_rows.h"

#include <QFont>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPalette>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

namespace knead {

namespace {

constexpr int placeRole = Qt::UserRole + 7; // of the row's data: others may have theirs

std::optional<ReportPlace> placeOfRow(const QTreeWidgetItem& row, int column)
{
    const QVariant data = row.data(column, placeRole);
    return data.isValid() ? std::optional(data.value<ReportPlace>()) : std::nullopt;
}

bool isEnter(const QEvent& event)
{
    if (event.type() != QEvent::KeyPress)
        return false;
    const int key = static_cast<const QKeyEvent&>(event).key();
    return key == Qt::Key_Return || key == Qt::Key_Enter;
}

} // namespace

PlaceRows::PlaceRows(QTreeWidget& tree)
    : QObject(&tree)
    , m_tree(tree)
    , m_column(tree.columnCount())
{
    tree.setColumnCount(m_column + 1);
    tree.headerItem()->setText(m_column, {});
    tree.header()->moveSection(m_column, 1);
    tree.installEventFilter(this);
    connect(&tree, &QTreeWidget::itemClicked, this, [this](const QTreeWidgetItem* row, int column) {
        if (column == m_column)
            follow(row);
    });
}

void PlaceRows::set(QTreeWidgetItem& row, const std::optional<ReportPlace>& place)
{
    const bool hadPlace = placeOfRow(row, m_column).has_value();
    row.setData(m_column, placeRole, place ? QVariant::fromValue(*place) : QVariant());
    if (hadPlace == place.has_value())
        return;
    row.setText(m_column, place ? tr("Show me") : QString());
    QFont font = m_tree.font();
    font.setUnderline(true);
    row.setFont(m_column, font);
    row.setForeground(m_column, m_tree.palette().link());
    row.setToolTip(m_column, place ? tr("Look there in the view (Enter)") : QString());
}

/// Links have the color of the theme.
bool PlaceRows::eventFilter(QObject* /*watched*/, QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        for (QTreeWidgetItemIterator row(&m_tree); *row != nullptr; ++row)
            if (placeOfRow(**row, m_column))
                (*row)->setForeground(m_column, m_tree.palette().link());
    return isEnter(*event) && follow(m_tree.currentItem());
}

/// A row below another one is about the same place.
bool PlaceRows::follow(const QTreeWidgetItem* row)
{
    for (; row != nullptr; row = row->parent())
        if (const std::optional<ReportPlace> place = placeOfRow(*row, m_column)) {
            emit wanted(*place);
            return true;
        }
    return false;
}

} // namespace knead
