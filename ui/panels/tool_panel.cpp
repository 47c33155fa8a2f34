#include "ui/panels/tool_panel.h"

#include "ui/document/tool_kinds.h"
#include "ui/language/said.h"
#include "ui/panels/form.h"
#include "ui/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr const char* axisNames[] = {"X", "Y", "Z"};
constexpr double noise = 1e-6;      // of the size of a tool
constexpr double plateThinness = 8; // a plate made of something thicker is this much thinner than wide

int indexOf(ToolKind kind)
{
    return static_cast<int>(&lookOf(kind) - toolKindLooks().data());
}

QComboBox* makeKindChoice(QWidget* parent)
{
    QComboBox* choice = makeChoice("toolKind", parent);
    for (const ToolKindLook& look : toolKindLooks())
        choice->addItem(icon(look.icon), QCoreApplication::translate("Actions", look.name));
    return choice;
}

} // namespace

ToolPanel::ToolPanel(Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_name(makeHeading({}, this))
    , m_kind(makeKindChoice(this))
    , m_speed(makeField(Quantity::Speed, "toolSpeed", this))
    , m_forceLimit(makeField(Quantity::Force, "toolForceLimit", this))
    , m_friction(makeField(Quantity::Number, "toolFriction", this))
    , m_adhesion(makeField(Quantity::Pressure, "toolAdhesion", this))
    , m_rolls(new QCheckBox(tr("Rolls freely"), this))
    , m_force(makeReading("toolForce", this))
    , m_peak(makeReading("toolPeakForce", this))
{
    setObjectName("toolPanel");
    QFormLayout* form = makeForm(this);
    form->addRow(m_name);
    form->addRow(tr("Force"), m_force);
    form->addRow(tr("Largest so far"), m_peak);
    m_force->setProperty("role", "heading");
    connect(m_kind, &QComboBox::activated, this, &ToolPanel::chooseKind);
    form->addRow(tr("Form"), m_kind);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        m_position[axis] = makeField(Quantity::Length, QStringLiteral("toolPosition%1").arg(axisNames[axis]), this);
        connect(m_position[axis], &QuantityField::committed, this,
                [this, axis](double place) { m_document.placeTool(m_tool, static_cast<int>(axis), place); });
        form->addRow(said(Message("ToolPanel", "Position %1").with(axisNames[axis])), m_position[axis]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        m_size[axis] = makeField(Quantity::Length, QStringLiteral("toolSize%1").arg(axisNames[axis]), this);
        m_size[axis]->setRange(1e-6, 100);
        connect(m_size[axis], &QuantityField::committed, this, [this, axis](double length) {
            m_document.reshapeTool(m_tool,
                                   [=](ToolState& tool) { tool.size[static_cast<Eigen::Index>(axis)] = length; });
        });
        form->addRow(said(Message("ToolPanel", "Size %1").with(axisNames[axis])), m_size[axis]);
    }
    m_speed->setRange(1e-6, 100);
    m_speed->setStatusTip(tr("Arrow keys and PgUp/PgDn drive at this speed; dragging is never faster"));
    m_forceLimit->setRange(1e-9, 1e12);
    m_forceLimit->setStatusTip(tr("The tool stalls rather than push harder"));
    m_friction->setRange(0, 2);
    m_adhesion->setRange(0, 1e9);
    m_adhesion->setStatusTip(tr("Tension that holds what has touched the tool; 0: nothing sticks to it"));
    for (const auto& [field, value] : {std::pair(m_speed, &ToolState::speedLimit),
                                       {m_forceLimit, &ToolState::forceLimit},
                                       {m_friction, &ToolState::friction},
                                       {m_adhesion, &ToolState::adhesion}})
        connect(field, &QuantityField::committed, this, [this, value](double number) {
            m_document.reshapeTool(m_tool, [=](ToolState& tool) { tool.*value = number; });
        });
    form->addRow(tr("Speed limit"), m_speed);
    form->addRow(tr("Force limit"), m_forceLimit);
    form->addRow(tr("Friction"), m_friction);
    form->addRow(tr("Adhesion"), m_adhesion);
    m_rolls->setObjectName("toolRolls");
    m_rolls->setStatusTip(tr("The tool turns as it is moved over material, so that it does not rub it"));
    m_rolls->setToolTip(m_rolls->statusTip());
    connect(m_rolls, &QCheckBox::clicked, this,
            [this](bool on) { m_document.reshapeTool(m_tool, [on](ToolState& tool) { tool.rollsFreely = on; }); });
    form->addRow(QString(), m_rolls);

    auto* remove = new QPushButton(icon("delete"), tr("Remove tool"), this);
    remove->setObjectName("removeTool");
    connect(remove, &QPushButton::clicked, this, [this] { m_document.removeSelected(); });
    form->addRow(QString(), remove);
    connect(&document, &Document::changed, this, &ToolPanel::documentChanged);
}

void ToolPanel::documentChanged(Document::Change what)
{
    const Selection& selection = m_document.selection();
    if (selection.kind != Selection::Kind::Tool)
        return;
    if (what == Document::Change::Selection || what == Document::Change::Moment) {
        m_tool = selection.id;
        for (const auto& group : {m_position, m_size})
            for (QuantityField* field : group)
                field->restore();
        m_speed->restore();
        m_forceLimit->restore();
        m_friction->restore();
        m_adhesion->restore();
    }
    showTool();
}

void ToolPanel::showTool()
{
    const std::optional<ToolState> tool = m_document.toolWithEdits(m_tool);
    if (!tool)
        return;
    m_name->setText(QString::fromStdString(tool->name));
    showKind(*tool);
    m_force->setText(formatReading(tool->force.norm(), Quantity::Force));
    m_peak->setText(formatReading(tool->peakForce, Quantity::Force));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        const double place = tool->pose.position[i]; // what rounding left of zero is no place
        m_position[axis]->setValue(std::abs(place) < noise * tool->size.maxCoeff() ? 0 : place);
        m_size[axis]->setValue(tool->size[i]);
    }
    m_speed->setValue(tool->speedLimit);
    m_forceLimit->setValue(tool->forceLimit);
    m_friction->setValue(tool->friction);
    m_adhesion->setValue(tool->adhesion);
    m_rolls->setChecked(tool->rollsFreely);
    m_rolls->setVisible(canRoll(tool->kind));
}

/// Only the measures that the form has can be typed.
void ToolPanel::showKind(const ToolState& tool)
{
    // Only what came from a file can be a part.
    qobject_cast<QStandardItemModel*>(m_kind->model())->item(indexOf(ToolKind::part))->setEnabled(tool.part != nullptr);
    if (m_shownKind == tool.kind)
        return;
    m_shownKind = tool.kind;
    m_kind->setCurrentIndex(indexOf(tool.kind));
    auto* form = qobject_cast<QFormLayout*>(layout());
    const auto& measures = lookOf(tool.kind).measures;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto measure = std::find_if(measures.begin(), measures.end(),
                                          [axis](const ToolMeasure& m) { return m.axis == static_cast<int>(axis); });
        const bool isMeasured = measure != measures.end();
        m_size[axis]->setVisible(isMeasured);
        form->labelForField(m_size[axis])->setVisible(isMeasured);
        if (isMeasured)
            qobject_cast<QLabel*>(form->labelForField(m_size[axis]))->setText(tr(measure->name));
    }
}

void ToolPanel::chooseKind(int index)
{
    const ToolKind kind = toolKindLooks()[static_cast<std::size_t>(index)].kind;
    m_shownKind.reset(); // what the simulation has is shown again, also when it refuses
    m_document.reshapeTool(m_tool, [kind](ToolState& tool) {
        if (tool.kind == ToolKind::plate)
            tool.size.z() = tool.size.head<2>().maxCoeff();
        if (kind == ToolKind::plate)
            tool.size.z() = std::min(tool.size.z(), tool.size.head<2>().maxCoeff() / plateThinness);
        tool.kind = kind;
    });
}

} // namespace knead
