#include "ui/deforming/deform_panel.h"

#include "ui/deforming/field_page.h"
#include "ui/deforming/number_page.h"
#include "ui/panels/panel_area.h"
#include "ui/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace knead {

DeformPanel::DeformPanel(QWidget* parent)
    : QWidget(parent)
    , m_pages(new QStackedWidget(this))
    , m_numbers(new NumberPage)
    , m_field(new FieldPage)
    , m_problem(new QLabel(this))
    , m_buttons(new QWidget(this))
    , m_apply(new QPushButton(tr("Apply"), this))
{
    setObjectName("deformPanel");
    auto* empty = new QWidget;
    auto* words = new QVBoxLayout(empty);
    auto* hint =
        new QLabel(tr("Parts are bent, twisted, tapered, stretched, sheared or scaled by numbers here, or by the "
                      "displacements of another program: File > Deform by a field."),
                   empty);
    hint->setWordWrap(true);
    setRole(*hint, "dimmed");
    auto* begin = new QPushButton(tr("Deform by numbers"), empty);
    begin->setObjectName("beginDeform");
    words->addWidget(hint);
    words->addWidget(begin);
    words->addStretch(1);
    m_pages->addWidget(empty);
    m_pages->addWidget(scrolled(m_numbers));
    m_pages->addWidget(scrolled(m_field));

    auto* cancel = new QPushButton(tr("Cancel"), this);
    cancel->setObjectName("cancelDeform");
    cancel->setToolTip(tr("Esc: everything stays as it is"));
    m_apply->setObjectName("applyDeform");
    m_apply->setToolTip(tr("Enter in the view: the parts become what is shown"));
    setRole(*m_apply, "primary");
    m_problem->setObjectName("deformProblem");
    m_problem->setWordWrap(true);
    m_problem->setTextFormat(Qt::PlainText);
    m_problem->setContentsMargins(10, 4, 10, 0);
    setRole(*m_problem, "slow");
    auto* row = new QHBoxLayout(m_buttons);
    row->setContentsMargins(10, 6, 10, 8);
    row->addStretch(1);
    row->addWidget(cancel);
    row->addWidget(m_apply);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_pages, 1);
    column->addWidget(m_problem);
    column->addWidget(m_buttons);
    connect(m_apply, &QPushButton::clicked, this, &DeformPanel::applyClicked);
    connect(cancel, &QPushButton::clicked, this, &DeformPanel::cancelClicked);
    connect(begin, &QPushButton::clicked, this, &DeformPanel::beginClicked);
    show(Page::none);
}

void DeformPanel::show(Page page)
{
    m_pages->setCurrentIndex(static_cast<int>(page));
    m_buttons->setVisible(page != Page::none);
    showProblem({});
}

void DeformPanel::showProblem(const QString& sentence)
{
    m_problem->setText(sentence);
    m_problem->setVisible(!sentence.isEmpty());
    m_apply->setEnabled(sentence.isEmpty());
}

QString DeformPanel::problem() const
{
    return m_problem->text();
}

} // namespace knead
