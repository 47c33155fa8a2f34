#pragma once

#include "ui/document/document.h"

#include <QTreeWidget>

#include <set>

namespace knead {

/// What the document holds: parts as the file orders them, tools and fixtures. Selects together with the view; the
/// check box of a
/// part hides it.
class ModelTree final : public QTreeWidget {
    Q_OBJECT
public:
    explicit ModelTree(Document& document, QWidget* parent = nullptr);

    /// Hides these parts and shows all others.
    void hideParts(const std::set<std::size_t>& parts);
    /// Hides or shows the selected body.
    void toggleSelectedBody();

signals:
    void hiddenChanged(const std::set<std::size_t>& hiddenParts);

private:
    struct ListedTool {
        ToolId id;
        std::string name;
        ToolKind kind;
        friend bool operator==(const ListedTool&, const ListedTool&) = default;
    };

    void documentChanged(Document::Change what);
    void build();
    void addParts(const PartNode& node, QTreeWidgetItem* parent);
    void addPart(std::size_t part, const QString& name, QTreeWidgetItem* parent);
    void markVisible(QTreeWidgetItem* item, std::size_t part);
    void listTools();
    void listFixtures();
    void showSelection();
    void currentChanged();
    void itemChecked(QTreeWidgetItem* item);
    QTreeWidgetItem* find(const Selection& selection) const;

    Document& m_document;
    QTreeWidgetItem* m_tools = nullptr;
    QTreeWidgetItem* m_fixtures = nullptr;
    std::vector<ListedTool> m_listedTools;
    bool m_isUpdating = false;
};

} // namespace knead
