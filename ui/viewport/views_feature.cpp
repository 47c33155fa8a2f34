#include "ui/viewport/views_feature.h"

#include "ui/commands/availability.h"
#include "ui/viewport/view_grid.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QMainWindow>

#include <utility>

namespace knead {

ViewsFeature::ViewsFeature(const Workbench& bench)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_actions(bench.window)
{
    connectViews();
    connectViewActions();
    sayWhyNot();
}

void ViewsFeature::connectViews()
{
    const ViewActions& a = m_actions;
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
    const ViewActions& a = m_actions;
    QAction* const arrangements[] = {a.oneView, a.twoViews, a.fourViews};
    arrangements[static_cast<std::size_t>(m_bench.views.arrangement())]->setChecked(true);
    a.viewAlone->setChecked(m_bench.views.isAlone());
    a.linkedViews->setChecked(m_bench.views.areLinked());
    m_bench.availability.update();
}

void ViewsFeature::sayWhyNot()
{
    const ViewActions& a = m_actions;
    m_bench.availability.needPart({a.fit, a.front, a.back, a.right, a.left, a.top, a.bottom, a.isometric, a.perspective,
                                   a.oneView, a.twoViews, a.fourViews});
    const auto needSeveral = [](bool areSeveral) {
        return areSeveral ? std::nullopt : std::optional(tr("Show two or four views first."));
    };
    m_bench.availability.needPart({a.viewAlone, a.linkedViews},
                                  [this, needSeveral] { return needSeveral(m_bench.views.areSeveral()); });
    m_bench.availability.needPart({a.nextView}, [this, needSeveral] {
        return needSeveral(m_bench.views.areSeveral() && !m_bench.views.isAlone());
    });
}

void ViewsFeature::connectViewActions()
{
    const ViewActions& a = m_actions;
    connect(a.fit, &QAction::triggered, &m_bench.viewport, &ViewportWidget::fit);
    const std::pair<QAction*, Vec3> views[] = {{a.front, {0, -1, 0}},    {a.back, {0, 1, 0}}, {a.right, {1, 0, 0}},
                                               {a.left, {-1, 0, 0}},     {a.top, {0, 0, 1}},  {a.bottom, {0, 0, -1}},
                                               {a.isometric, {1, -1, 1}}};
    for (const auto& [action, direction] : views)
        connect(action, &QAction::triggered, this, [this, towards = direction] { m_bench.viewport.lookFrom(towards); });
    connect(a.perspective, &QAction::toggled, &m_bench.viewport, &ViewportWidget::setPerspective);
}

} // namespace knead
