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

constexpr const char* selectionBarShown = "selectionBar/shown";

bool isBarWanted()
{
    return QSettings().value(selectionBarShown, true).toBool();
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
    connect(m_pages, &QStackedWidget::currentChanged, this, &Center::showBar);
    connect(m_pages, &QStackedWidget::currentChanged, this, &Center::turned);
}

void Center::setBar(QToolBar& bar)
{
    m_bar = &bar;
    m_row->insertWidget(0, m_bar);
    connect(m_bar->toggleViewAction(), &QAction::triggered, this,
            [](bool on) { QSettings().setValue(selectionBarShown, on); });
    showBar();
}

void Center::showBar()
{
    if (m_bar != nullptr)
        m_bar->setVisible(hasViews() && isBarWanted());
}

/// The bar first: the view is laid out, and drawn, once.
void Center::showViews()
{
    m_bar->setVisible(isBarWanted());
    m_pages->setCurrentWidget(m_views);
}

bool Center::hasViews() const
{
    return m_pages->currentWidget() == m_views;
}

} // namespace knead
