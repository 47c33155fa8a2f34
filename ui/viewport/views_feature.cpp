#include "ui/viewport/views_feature.h"

#include "ui/actions.h"
#include "ui/viewport/view_grid.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QMainWindow>

#include <utility>

namespace knead {

ViewsFeature::ViewsFeature(const Workbench& bench, Actions& actions)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_actions(actions)
{
    connectViews();
    connectViewActions();
}

void ViewsFeature::connectViews()
{
    const Actions& a = m_actions;
    const std::pair<QAction*, ViewArrangement> arrangements[] = {
        {a.oneView, ViewArrangement::one}, {a.twoViews, ViewArrangement::two}, {a.fourViews, ViewArrangement::four}};
    for (const auto& [action, arrangement] : arrangements)
        connect(action, &QAction::triggered, this, [this, chosen = arrangement] { m_bench.views.arrange(chosen); });
    connect(a.viewAlone, &QAction::triggered, &m_bench.views, &ViewGrid::setAlone);
    connect(a.nextView, &QAction::triggered, &m_bench.views, &ViewGrid::activateNext);
    connect(a.linkedViews, &QAction::triggered, &m_bench.views, &ViewGrid::setLinked);
    connect(&m_bench.views, &ViewGrid::changed, this, &ViewsFeature::showArrangement);
    connect(&m_bench.views, &ViewGrid::activated, this,
            [this] { m_actions.perspective->setChecked(m_bench.viewport.camera().perspective); });
    showArrangement();
}

void ViewsFeature::showArrangement()
{
    const Actions& a = m_actions;
    QAction* const arrangements[] = {a.oneView, a.twoViews, a.fourViews};
    arrangements[static_cast<std::size_t>(m_bench.views.arrangement())]->setChecked(true);
    a.viewAlone->setChecked(m_bench.views.isAlone());
    a.linkedViews->setChecked(m_bench.views.areLinked());
    const bool areSeveral = m_bench.views.areSeveral() && !m_bench.document.isEmpty();
    for (QAction* action : {a.viewAlone, a.linkedViews})
        action->setEnabled(areSeveral);
    a.nextView->setEnabled(areSeveral && !m_bench.views.isAlone());
    const QString why = m_bench.document.isEmpty() ? tr("Open a part first.") : tr("Show two or four views first.");
    for (QAction* action : {a.viewAlone, a.linkedViews, a.nextView})
        action->setProperty("whyDisabled", why);
}

void ViewsFeature::connectViewActions()
{
    const Actions& a = m_actions;
    connect(a.fit, &QAction::triggered, &m_bench.viewport, &ViewportWidget::fit);
    const std::pair<QAction*, Vec3> views[] = {{a.front, {0, -1, 0}},    {a.back, {0, 1, 0}}, {a.right, {1, 0, 0}},
                                               {a.left, {-1, 0, 0}},     {a.top, {0, 0, 1}},  {a.bottom, {0, 0, -1}},
                                               {a.isometric, {1, -1, 1}}};
    for (const auto& [action, direction] : views)
        connect(action, &QAction::triggered, this, [this, towards = direction] { m_bench.viewport.lookFrom(towards); });
    connect(a.perspective, &QAction::toggled, &m_bench.viewport, &ViewportWidget::setPerspective);
    for (QAction* action : {a.objects, a.allObjects, a.edges, a.openEdges, a.grid})
        connect(action, &QAction::toggled, this, &ViewsFeature::followSwitches);
}

void ViewsFeature::followSwitches()
{
    SceneOptions options = m_bench.viewport.options();
    const ObjectDisplay shown = m_actions.allObjects->isChecked() ? ObjectDisplay::All : ObjectDisplay::Surface;
    options.objects = m_actions.objects->isChecked() ? shown : ObjectDisplay::Off;
    options.edges = m_actions.edges->isChecked();
    options.openEdges = m_actions.openEdges->isChecked();
    options.grid = m_actions.grid->isChecked();
    m_bench.viewport.setOptions(options);
}

} // namespace knead
