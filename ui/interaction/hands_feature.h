#pragma once

#include "ui/frame/workbench.h"

#include <QList>
#include <QObject>

#include <cstddef>
#include <optional>

class QAction;
class QMenu;
class QWidget;

namespace knead {

class Hands;
class Modes;

/// Tools and fixtures, tools and material by hand, the forces that come of it, and the folds: their panels, and the table of
/// forces as a file. Window thread only.
class HandsFeature final : public QObject {
    Q_OBJECT
public:
    struct Actions {
        explicit Actions(QWidget& window);

        QList<QAction*> addTool; ///< one per form, in the order of toolsToAdd()
        QAction* fixFaces;
        QAction* remove;
    };

    HandsFeature(const Workbench& bench, Modes& modes);

    const Actions& actions() const { return m_actions; }
    QMenu& addToolMenu() const { return m_addTool; }
    Hands& hands() { return *m_hands; }

    /// Of the brush that sculpts, by a factor of its radius. @return whether one is chosen
    bool changeBrush(double factor) const;

    /// Writes the forces over time as a table in the background.
    void exportForces(const QString& path);

private:
    void connectActions(Modes& modes);
    void addTool(int index);
    void showNewTool(Document::Change what);
    void askForForces();

    Workbench m_bench;
    Actions m_actions;
    QMenu& m_addTool;
    Hands* m_hands;
    std::optional<std::size_t> m_toolsBefore; ///< a tool was added where all was seen
};

} // namespace knead
