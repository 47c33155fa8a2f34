// What the main window does about several views of the part.
#include "ui/main_window.h"

#include "ui/actions.h"
#include "ui/viewport/view_grid.h"

#include <QAction>

namespace knead {

void MainWindow::connectViews()
{
    const Actions& a = *m_actions;
    const std::pair<QAction*, ViewArrangement> arrangements[] = {
        {a.oneView, ViewArrangement::one}, {a.twoViews, ViewArrangement::two}, {a.fourViews, ViewArrangement::four}};
    for (const auto& [action, arrangement] : arrangements)
        connect(action, &QAction::triggered, this, [this, chosen = arrangement] { m_views->arrange(chosen); });
    connect(a.viewAlone, &QAction::triggered, m_views, &ViewGrid::setAlone);
    connect(a.nextView, &QAction::triggered, m_views, &ViewGrid::activateNext);
    connect(a.linkedViews, &QAction::triggered, m_views, &ViewGrid::setLinked);
    connect(m_views, &ViewGrid::changed, this, &MainWindow::showViews);
    connect(m_views, &ViewGrid::activated, this,
            [this] { m_actions->perspective->setChecked(m_viewport->camera().perspective); });
    showViews();
}

/// The actions say what the views are.
void MainWindow::showViews()
{
    const Actions& a = *m_actions;
    QAction* const arrangements[] = {a.oneView, a.twoViews, a.fourViews};
    arrangements[static_cast<std::size_t>(m_views->arrangement())]->setChecked(true);
    a.viewAlone->setChecked(m_views->isAlone());
    a.linkedViews->setChecked(m_views->areLinked());
    const bool areSeveral = m_views->areSeveral() && !m_document.isEmpty();
    for (QAction* action : {a.viewAlone, a.linkedViews})
        action->setEnabled(areSeveral);
    a.nextView->setEnabled(areSeveral && !m_views->isAlone());
    const QString why = m_document.isEmpty() ? tr("Open a part first.") : tr("Show two or four views first.");
    for (QAction* action : {a.viewAlone, a.linkedViews, a.nextView})
        action->setProperty("whyDisabled", why);
}

} // namespace knead
