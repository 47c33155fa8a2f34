#pragma once

#include "ui/document/document.h"
#include "ui/document/history_outline.h"

#include <QWidget>

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

protected:
    void showEvent(QShowEvent* event) override;

private:
    void makeTree();
    void makeFoot();
    void documentChanged(Document::Change what);
    void bringUpToDate();
    void build();
    void addWay(const std::vector<OutlineRow>& way, QTreeWidgetItem* parent);
    void showEntries();
    void showEntry(QTreeWidgetItem* item);
    void showMemory();
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
    std::vector<Entry> m_parents; ///< of the entries listed; tells whether the list is still that of the document
    std::vector<bool> m_isOnWay;  ///< per entry: leads to the present one
    bool m_isUpdating = false;
};

} // namespace knead
