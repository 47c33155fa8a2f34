#include "ui/panels/property_pages.h"

#include "ui/document/document.h"
#include "ui/panels/fixture_panel.h"
#include "ui/panels/material_panel.h"
#include "ui/panels/panel_area.h"
#include "ui/panels/tool_panel.h"

#include <QLabel>
#include <QScrollArea>

namespace knead {

PropertyPages::PropertyPages(Document& document, MaterialStore& materials, QWidget* parent)
    : QStackedWidget(parent)
{
    setObjectName("properties");
    auto* nothing = new QLabel(tr("Nothing selected."), this);
    nothing->setProperty("role", "dimmed");
    nothing->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    nothing->setMargin(12);
    auto* material = new MaterialPanel(document, materials);
    connect(material, &MaterialPanel::refillRequested, this, &PropertyPages::refillRequested);
    addWidget(nothing);
    addWidget(scrolled(material));
    addWidget(scrolled(new ToolPanel(document)));
    addWidget(scrolled(new FixturePanel(document)));
}

} // namespace knead
