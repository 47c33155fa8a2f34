#include "ui/frame/center.h"

#include "ui/panels/banner.h"
#include "ui/panels/home_page.h"
#include "ui/viewport/view_grid.h"

#include <QAction>
#include <QSettings>
#include <QStackedWidget>
#include <QToolBar>
#include <QVBoxLayout>

namespace knead {

namespace {

/// Where the settings keep whether a person wants a bar.
QString keyOf(const QToolBar& bar)
{
    return bar.objectName() + "/shown";
}

} // namespace

Center::Center(Document& document, const QString& examplesFolder, QWidget* parent)
    : QWidget(parent)
    , m_banner(new Banner(this))
    , m_row(new QHBoxLayout)
    , m_pages(new QStackedWidget(this))
    , m_home(new HomePage(examplesFolder, m_pages))
    , m_views(new ViewGrid(document, m_pages))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_pages->addWidget(m_home);
    m_pages->addWidget(m_views);
    m_row->setSpacing(0);
    m_row->addWidget(m_pages, 1);
    column->addLayout(m_row, 1);
    m_banner->layOver(*m_pages);
    connect(m_pages, &QStackedWidget::currentChanged, this, &Center::showBars);
    connect(m_pages, &QStackedWidget::currentChanged, this, &Center::turned);
}

void Center::addBar(QToolBar& bar, Side side)
{
    m_bars.push_back(&bar);
    m_row->insertWidget(side == Side::left ? 0 : m_row->count(), &bar);
    connect(bar.toggleViewAction(), &QAction::triggered, this,
            [key = keyOf(bar)](bool on) { QSettings().setValue(key, on); });
    showBars();
}

void Center::showBars()
{
    for (QToolBar* bar : m_bars)
        bar->setVisible(hasViews() && QSettings().value(keyOf(*bar), true).toBool());
}

void Center::showHome()
{
    m_pages->setCurrentWidget(m_home);
}

/// The bars first: the view is laid out, and drawn, once.
void Center::showViews()
{
    for (QToolBar* bar : m_bars)
        bar->setVisible(QSettings().value(keyOf(*bar), true).toBool());
    m_pages->setCurrentWidget(m_views);
}

bool Center::hasViews() const
{
    return m_pages->currentWidget() == m_views;
}

} // namespace knead
