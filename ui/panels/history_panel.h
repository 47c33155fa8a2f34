#pragma once

#include "core/session/history_outline.h"
#include "ui/document/document.h"

#include <QWidget>

#include <cstdint>
#include <set>
#include <vector>

class QLabel;
class QSpinBox;
class QTimer;
class QTreeWidget;
class QTreeWidgetItem;

namespace knead {

/// Everything that was done, to be gone back to: a click on an entry goes there, what is done next begins a branch. Entries can
/// be renamed, and marked as key moments, which memory is kept for longest.
class HistoryPanel final : public QWidget {
    Q_OBJECT
public:
    using Entry = Document::Entry;

    explicit HistoryPanel(Document& document, QWidget* parent = nullptr);

    void showAllowedMemory(int megabytes); ///< for moments

signals:
    void allowedMemoryChanged();

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    class Row;

    void makeTree();
    void makeFoot();
    void documentChanged(Document::Change what);
    void bringUpToDate();
    void build();
    bool isListed() const;
    void addWay(const std::vector<OutlineRow>& way, QTreeWidgetItem* parent);
    void addEntry(Entry entry);
    QTreeWidgetItem* makeRow(Entry entry);
    void showEntries();
    void showEntry(Entry entry);
    QVariant lookOf(Entry entry, int column, int role) const;
    QVariant tipOf(Entry entry, int column) const;
    void entryClicked(QTreeWidgetItem* item, int column);
    void entryEdited(QTreeWidgetItem* item, int column);
    void askWhatToDo(const QPoint& place);
    void renameEntry(QTreeWidgetItem* item);
    void toggleKey(Entry entry);

    Document& m_document;
    QTreeWidget* m_tree;
    QLabel* m_used;
    QSpinBox* m_allowed;                   ///< [MB]
    QTimer* m_soon;                        ///< many changes are shown at once
    std::vector<QTreeWidgetItem*> m_items; ///< by entry
    std::vector<bool> m_isOnWay;           ///< per entry: leads to the present one
    std::set<Entry> m_edited;              ///< entries whose name or mark is not shown yet
    std::uint64_t m_listed = 0;            ///< number of the document whose entries these are
    bool m_isUpdating = false;
};

} // namespace knead
