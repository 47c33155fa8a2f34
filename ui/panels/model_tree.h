#pragma once

#include "core/session/region.h"
#include "ui/document/document.h"

#include <QTreeWidget>

#include <functional>
#include <set>

class QMenu;

namespace knead {

/// What a line of the model tree is.
enum class TreeItem {
    File,
    Assembly,
    Group,
    Part,
    Surface,
    Tools,
    Tool,
    Fixtures,
    Fixture,
    Sets,
    Set,
    Exports,
    Export
};

/// What is kept at the lines of the model tree, by item->data(0, role).
namespace tree_roles {
constexpr int type = Qt::UserRole;
constexpr int id = Qt::UserRole + 1;   ///< of Selection
constexpr int part = Qt::UserRole + 2; ///< index into Model::parts
constexpr int name = Qt::UserRole + 3; ///< what F2 changes; none: it has no name of its own
constexpr int lock = Qt::UserRole + 4; ///< whether it is locked; none: it cannot be
constexpr int file = Qt::UserRole + 5; ///< of an export
} // namespace tree_roles

/// What the document holds: parts as the file orders them or as the person groups them, tools, fixtures, selection sets and
/// exports. Selects together with the view. The eye of a line, its check box, hides parts; the lock keeps them as they are.
class ModelTree final : public QTreeWidget {
    Q_OBJECT
public:
    explicit ModelTree(Document& document, QWidget* parent = nullptr);

    /// Hides these parts and shows all others.
    void hideParts(const std::set<std::size_t>& parts);
    const std::set<std::size_t>& hiddenParts() const { return m_hiddenParts; }
    /// Hides or shows the selected bodies.
    void toggleSelectedBody();
    /// Shows nothing but the selected bodies; a second time, what was shown before.
    void isolateSelected();
    void showAll();

    void renameCurrent();   ///< in place
    void colorSelected();   ///< asks for a color
    void uncolorSelected(); ///< as in the file
    void lockSelected();    ///< or unlocks, when all of them are
    void groupSelected();
    void ungroupSelected();

    /// Shows only lines with this text in their names, and those above and below them.
    void filter(const QString& text);

    /// What the menu of a line has of the window's actions.
    void setMenu(std::function<void(QMenu& menu, TreeItem type)> fill) { m_fillMenu = std::move(fill); }

signals:
    void hiddenChanged(const std::set<std::size_t>& hiddenParts);
    void problem(const QString& sentence);
    void toolClicked(); ///< which is selected now

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;

private:
    struct ListedTool {
        ToolId id;
        std::string name;
        ToolKind kind;
        friend bool operator==(const ListedTool&, const ListedTool&) = default;
    };

    void documentChanged(Document::Change what);
    void beginContent();
    void notesChanged();
    void appearanceChanged();

    // Lines (model_tree_lines.cpp)
    void build();
    QTreeWidgetItem* makeHeading(const QString& text, const char* image, TreeItem type);
    void addGroups(QTreeWidgetItem* parent);
    void addParts(const PartNode& node, QTreeWidgetItem* parent);
    void addPart(std::size_t part, const QString& name, QTreeWidgetItem* parent);
    void dress(QTreeWidgetItem* item);
    void markVisible(QTreeWidgetItem* item, std::size_t part);
    void listTools();
    void listFixtures();
    void listSets();
    void listExports();
    void showLocks();

    void showSelection();
    void selectionChanged();
    void selectSet(const std::string& name);
    void rename(QTreeWidgetItem* item, const QString& name);
    void tellHidden();
    bool pressedButton(const QMouseEvent& event);

    std::vector<QTreeWidgetItem*> all() const;
    QTreeWidgetItem* find(const Selection& selection) const;
    std::vector<QTreeWidgetItem*> chosen() const;
    std::set<std::size_t> chosenParts() const;
    std::set<std::size_t> partsBelow(QTreeWidgetItem* item) const;
    bool filterBelow(QTreeWidgetItem* item, const QString& text, bool isAboveShown);
    void fillSetMenu(QMenu& menu, const std::string& name);
    void fillExportMenu(QMenu& menu, const QString& file);

    Document& m_document;
    QTreeWidgetItem* m_tools = nullptr;
    QTreeWidgetItem* m_fixtures = nullptr;
    QTreeWidgetItem* m_sets = nullptr;
    QTreeWidgetItem* m_exports = nullptr;
    std::vector<ListedTool> m_listedTools;
    std::shared_ptr<const Model> m_model;
    std::set<std::size_t> m_hiddenParts;
    std::optional<std::set<std::size_t>> m_hiddenBefore; ///< isolating
    std::vector<std::pair<std::string, std::set<std::size_t>>> m_shownGroups;
    QString m_filter;
    std::function<void(QMenu&, TreeItem)> m_fillMenu;
    Region m_regionOfSet;  ///< that was selected last by its line
    Region m_regionBefore; ///< selected when the mouse went down
    bool m_isUpdating = false;
    bool m_isOnButton = false;   ///< the mouse went down on an eye or a lock
    std::uint64_t m_opening = 0; ///< of the document that was shown last
};

/// What a line names, for Document::select().
Selection selectionOf(const QTreeWidgetItem* item);
TreeItem typeOf(const QTreeWidgetItem* item);

} // namespace knead
