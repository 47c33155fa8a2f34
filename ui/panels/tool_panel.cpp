#include "ui/panels/tool_panel.h"

#include "ui/document/tool_kinds.h"
#include "ui/panels/form.h"
#include "ui/theme.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>

#include <algorithm>

namespace knead {

namespace {

constexpr const char* axisNames[] = {"X", "Y", "Z"};
constexpr double plateThinness = 8; // a plate made of something thicker is this much thinner than wide

int indexOf(ToolKind kind)
{
    return static_cast<int>(&lookOf(kind) - toolKindLooks().data());
}

QComboBox* makeKindChoice(QWidget* parent)
{
    QComboBox* choice = makeChoice("toolKind", parent);
    for (const ToolKindLook& look : toolKindLooks())
        choice->addItem(icon(look.icon), QObject::tr(look.name));
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
        connect(m_position[axis], &QuantityField::committed, this, &ToolPanel::place);
        form->addRow(tr("Position %1").arg(axisNames[axis]), m_position[axis]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        m_size[axis] = makeField(Quantity::Length, QStringLiteral("toolSize%1").arg(axisNames[axis]), this);
        m_size[axis]->setRange(1e-6, 100);
        connect(m_size[axis], &QuantityField::committed, this, &ToolPanel::reshape);
        form->addRow(tr("Size %1").arg(axisNames[axis]), m_size[axis]);
    }
    m_speed->setRange(1e-6, 100);
    m_speed->setStatusTip(tr("Arrow keys and PgUp/PgDn drive at this speed; dragging is never faster"));
    m_forceLimit->setRange(1e-9, 1e12);
    m_forceLimit->setStatusTip(tr("The tool stalls rather than push harder"));
    m_friction->setRange(0, 2);
    connect(m_speed, &QuantityField::committed, this, &ToolPanel::reshape);
    connect(m_forceLimit, &QuantityField::committed, this, &ToolPanel::reshape);
    connect(m_friction, &QuantityField::committed, this, &ToolPanel::reshape);
    form->addRow(tr("Speed limit"), m_speed);
    form->addRow(tr("Force limit"), m_forceLimit);
    form->addRow(tr("Friction"), m_friction);

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
    }
    showTool();
}

void ToolPanel::showTool()
{
    const ToolState* tool = m_document.tool(m_tool);
    if (tool == nullptr)
        return;
    m_name->setText(QString::fromStdString(tool->name));
    showKind(*tool);
    m_force->setText(formatReading(tool->force.norm(), Quantity::Force));
    m_peak->setText(formatReading(tool->peakForce, Quantity::Force));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        m_position[axis]->setValue(tool->pose.position[i]);
        m_size[axis]->setValue(tool->size[i]);
    }
    m_speed->setValue(tool->speedLimit);
    m_forceLimit->setValue(tool->forceLimit);
    m_friction->setValue(tool->friction);
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

/// While paused the tool is put there; while running it goes there.
void ToolPanel::place()
{
    const ToolState* tool = m_document.tool(m_tool);
    if (tool == nullptr)
        return;
    Pose pose = tool->pose;
    for (std::size_t axis = 0; axis < 3; ++axis)
        pose.position[static_cast<Eigen::Index>(axis)] = m_position[axis]->value();
    if (m_document.frame()->snapshot->playing)
        m_document.post(SetManipulatorMotion{m_tool, GoTo{pose}});
    else
        m_document.post(PlaceManipulator{m_tool, pose});
}

void ToolPanel::chooseKind(int index)
{
    const ToolState* tool = m_document.tool(m_tool);
    if (tool == nullptr)
        return;
    const ToolKind kind = toolKindLooks()[static_cast<std::size_t>(index)].kind;
    Vec3 size = tool->size;
    if (kind == ToolKind::plate)
        size.z() = std::min(size.z(), size.head<2>().maxCoeff() / plateThinness);
    if (tool->kind == ToolKind::plate)
        size.z() = size.head<2>().maxCoeff();
    m_shownKind.reset(); // what the simulation has is shown again, also when it refuses
    m_document.post(ReshapeManipulator{m_tool, fittingSize(kind, size, tool->part.get()), tool->friction,
                                       tool->speedLimit, tool->forceLimit, kind, tool->part});
}

void ToolPanel::reshape()
{
    const ToolState* tool = m_document.tool(m_tool);
    if (tool == nullptr)
        return;
    const Vec3 size(m_size[0]->value(), m_size[1]->value(), m_size[2]->value());
    m_document.post(ReshapeManipulator{m_tool, fittingSize(tool->kind, size, tool->part.get()), m_friction->value(),
                                       m_speed->value(), m_forceLimit->value(), tool->kind, tool->part});
}

} // namespace knead
