#include "ui/panels/material_panel.h"

#include "core/aggregate/spacing_choice.h"
#include "core/session/material_facts.h"
#include "ui/language/said.h"
#include "ui/materials/material_store.h"
#include "ui/materials/material_swatch.h"
#include "ui/panels/form.h"
#include "ui/theme.h"
#include "ui/units.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace knead {

namespace {

/// Numbers of a material that belong together.
struct Group {
    const char* name;
    std::vector<double Material::*> values;
};

const std::vector<Group>& groups()
{
    static const std::vector<Group> all{
        {"Elastic",
         {&Material::density, &Material::youngsModulus, &Material::poissonRatio, &Material::dampingRatio,
          &Material::shapeDamping}},
        {"Rubber", {&Material::rubberlike, &Material::secondInvariantShare, &Material::lockingElongation}},
        {"Flow", {&Material::yieldStress, &Material::hardening, &Material::relaxationTime}},
        {"Strength", {&Material::tensileStrength, &Material::elongationAtBreak, &Material::toughness}},
        {"Surface", {&Material::friction, &Material::adhesion, &Material::healingTime}},
    };
    return all;
}

} // namespace

MaterialPanel::MaterialPanel(Document& document, MaterialStore& store, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_store(store)
{
    setObjectName("materialPanel");
    makeForm(this);
    makeBodyRows();
    makePresetRows();
    makeFirmnessRow();
    makeFactRows();
    makeMaterialRows();
    makeFillingRows();
    connect(&document, &Document::changed, this, &MaterialPanel::documentChanged);
    connect(&document, &Document::appearanceChanged, this, [this] {
        if (m_body < m_document.content().bodies.size())
            m_name->setText(m_document.nameOfBody(m_body));
    });
}

void MaterialPanel::makeBodyRows()
{
    auto* form = qobject_cast<QFormLayout*>(layout());
    m_name = makeHeading({}, this);
    m_facts = new QLabel(this);
    m_facts->setObjectName("bodyFacts");
    m_facts->setProperty("role", "dimmed");
    m_facts->setWordWrap(true);
    form->addRow(m_name);
    form->addRow(m_facts);

    m_kind = makeChoice("bodyKind", this);
    m_kind->addItems({tr("Deformable"), tr("Rigid"), tr("Glue")}); // in the order of BodyKind
    m_kind->setItemData(1, tr("Keeps its shape and moves as a whole"), Qt::ToolTipRole);
    m_kind->setItemData(2, tr("Keeps shape and place; its adhesion holds what touches it"), Qt::ToolTipRole);
    connect(m_kind, &QComboBox::activated, this, &MaterialPanel::chooseKind);
    form->addRow(tr("Body"), m_kind);
}

void MaterialPanel::makeFactRows()
{
    auto* form = qobject_cast<QFormLayout*>(layout());
    form->addRow(makeHeading(tr("What follows"), this));
    const auto add = [&](const char* name, const QString& label, const QString& tip) {
        QLabel* reading = makeReading(name, this);
        reading->setToolTip(tip);
        form->addRow(label, reading);
        return reading;
    };
    m_soundSpeed = add("soundSpeed", tr("Speed of sound"), tr("Of a thin bar: the root of stiffness by density"));
    m_stableStep = add("stableStep", tr("Stable time step"),
                       tr("Longest step of an explicit scheme, for all bodies together; shorter for stiff, light and "
                          "finely filled ones"));
    m_ratio = add("expectedRatio", tr("Expected speed"),
                  tr("Simulated by wall time on this machine: measured while time ran, else by a rule"));
    m_wallCells = add(
        "wallCells", tr("Cells across walls"),
        said(Message("MaterialPanel", "Across the thinnest wall: with fewer than %1 its bending comes out too stiff")
                 .with(numberMessage(fewestCellsAcrossWall))));
}

void MaterialPanel::makeMaterialRows()
{
    auto* form = qobject_cast<QFormLayout*>(layout());
    for (const Group& group : groups()) {
        form->addRow(makeHeading(tr(group.name), this));
        for (double Material::*value : group.values) {
            const MaterialField& row = fieldOf(value);
            QuantityField* field = makeField(quantityOfUnit(row.unit), QString::fromLatin1(row.key), this);
            field->setRange(row.minimum, row.maximum);
            field->setTip(Message("MaterialPanel", "%1 to %2, with any unit; 1.2e6 and 1,2 are taken too"));
            if (*row.zero != '\0')
                field->setZeroText(tr(row.zero));
            connect(field, &QuantityField::committed, this, [this, value](double number) { commit(value, number); });
            form->addRow(tr(row.name), field);
            m_fields.emplace_back(value, field);
        }
    }
}

void MaterialPanel::makeFillingRows()
{
    auto* form = qobject_cast<QFormLayout*>(layout());
    form->addRow(makeHeading(tr("Filling"), this));
    m_spacing = makeField(Quantity::Length, "spacing", this);
    m_spacing->setRange(1e-6, 10);
    m_spacing->setStatusTip(tr("Distance between neighboring objects"));
    m_cells = makeField(Quantity::Number, "cellsAcross", this);
    m_cells->setRange(2, 2000);
    m_cells->setStatusTip(tr("Objects along the longest side of the part"));
    m_refill = new QPushButton(icon("refill"), tr("Refill"), this);
    m_refill->setObjectName("refill");
    m_refill->setToolTip(tr("Fill all bodies again with this spacing; the simulation starts anew"));
    connect(m_spacing, &QuantityField::committed, this, &MaterialPanel::showSpacing);
    connect(m_cells, &QuantityField::committed, this, [this](double cells) { showSpacing(m_document.size() / cells); });
    connect(m_refill, &QPushButton::clicked, this, [this] { emit refillRequested(m_spacing->value()); });
    form->addRow(tr("Spacing"), m_spacing);
    form->addRow(tr("Cells across"), m_cells);
    form->addRow(QString(), m_refill);
}

double MaterialPanel::cellsAcross(double spacing) const
{
    return m_document.size() / spacing;
}

void MaterialPanel::showSpacing(double spacing)
{
    m_spacing->setValue(spacing);
    m_cells->setValue(cellsAcross(spacing));
}

void MaterialPanel::documentChanged(Document::Change what)
{
    if (m_document.content().bodies.empty()) // only surfaces, which have no material
        return;
    switch (what) {
    case Document::Change::Model:
        m_isPosted = false;
        for (QuantityField* field : {m_spacing, m_cells})
            field->restore();
        showSpacing(m_document.content().spacing);
        showBody();
        break;
    case Document::Change::Filling:
        showBody();
        break;
    case Document::Change::Selection:
        if (m_document.selection().kind == Selection::Kind::Body && m_document.selection().id != m_body)
            showBody();
        break;
    case Document::Change::Frame:
        showMaterial();
        break;
    case Document::Change::Moment: // what was posted before is not to come
        showBody();
        break;
    case Document::Change::Fixtures:
    case Document::Change::History:
        break;
    }
}

void MaterialPanel::showBody()
{
    const Selection& selection = m_document.selection();
    m_body = selection.kind == Selection::Kind::Body ? selection.id : 0;
    m_isPosted = false;
    m_postedKind.reset();
    const FilledBody& body = *m_document.content().bodies[m_body];
    m_name->setText(m_document.nameOfBody(m_body));
    m_facts->setText(tr("%1 objects, %2 connections\n%3 of material")
                         .arg(formatCount(body.aggregate->size()), formatCount(body.aggregate->connectionCount()),
                              formatQuantity(body.aggregate->meshVolume, Quantity::Volume)));
    for (const auto& [value, field] : m_fields)
        field->restore();
    showMaterial();
}

/// Shows what the simulation has, unless a change of ours is still on its way to it.
void MaterialPanel::showMaterial()
{
    const Snapshot& now = *m_document.frame()->snapshot;
    const BodyKind kind = now.bodies[m_body].kind;
    if (!m_postedKind || *m_postedKind == kind || !now.health.ok) {
        m_postedKind.reset();
        m_kind->setCurrentIndex(static_cast<int>(kind));
    }
    const Material& material = now.materials[m_body];
    if (material != m_material)
        m_stepSeconds = 0;
    measureSteps(now);
    showFacts();
    if (m_isPosted && material != m_material && now.health.ok)
        return;
    m_isPosted = false;
    m_material = material;
    for (const auto& [value, field] : m_fields)
        field->setValue(material.*value);
    findFirmness();
    showPreset();
}

/// Stages of a step, as they were measured while time ran with these numbers.
void MaterialPanel::measureSteps(const Snapshot& now)
{
    constexpr double smoothing = 0.1;
    if (now.integrator != m_measuredIntegrator)
        m_stepSeconds = 0;
    m_measuredIntegrator = now.integrator;
    const double seconds = std::accumulate(now.stages.begin(), now.stages.end(), 0.0);
    if (now.playing && seconds > 0)
        m_stepSeconds = m_stepSeconds == 0 ? seconds : m_stepSeconds + smoothing * (seconds - m_stepSeconds);
}

void MaterialPanel::showFacts()
{
    constexpr double keepsUp = 0.95;
    constexpr double leastRatio = 0.01; // that is worth a number
    const MaterialFacts facts = factsOf(m_document.content(), *m_document.frame()->snapshot, m_body, m_stepSeconds);
    m_soundSpeed->setText(formatReading(facts.soundSpeed, Quantity::Speed));
    m_stableStep->setText(formatReading(facts.stableStep, Quantity::Time));
    const QString ratio = facts.ratio < leastRatio ? tr("less than %1").arg(localNumber(leastRatio, 'g', 2))
                                                   : localNumber(facts.ratio, 'g', 2);
    const QString about = facts.isMeasured ? ratio : tr("about %1").arg(ratio);
    m_ratio->setText(facts.ratio >= keepsUp ? tr("keeps up with real time") : tr("%1 of real time").arg(about));
    showWallCells(facts.cellsAcrossWall);
    setRole(*m_ratio, facts.isMeasured && facts.ratio < keepsUp ? "slow" : ""); // a guess is no reason to worry
}

/// With what too few of them do to bending.
void MaterialPanel::showWallCells(double cells)
{
    const double error = bendingErrorOf(cells);
    const bool isCoarse = cells > 0 && error > bendingErrorOf(fewestCellsAcrossWall);
    const QString number = localNumber(cells, 'g', 2);
    m_wallCells->setText(cells == 0          ? tr("not measured")
                         : !isCoarse         ? number
                         : std::isinf(error) ? tr("%1: many times too stiff").arg(number)
                                             : tr("%1: up to %2 % too stiff").arg(number).arg(100 * error));
    setRole(*m_wallCells, isCoarse ? "slow" : "");
}

void MaterialPanel::chooseKind(int index)
{
    m_postedKind = static_cast<BodyKind>(index);
    m_document.post(SetBodyKind{m_body, *m_postedKind});
    if (isLocked())
        showBody();
}

bool MaterialPanel::isLocked() const
{
    return m_document.isLocked({Selection::Kind::Body, m_body});
}

void MaterialPanel::commit(double Material::*value, double number)
{
    m_material.*value = number;
    const MaterialField& field = fieldOf(value);
    const Message shown = number == 0 && *field.zero != '\0'
                              ? Message("MaterialPanel", field.zero)
                              : Message::verbatim(formatQuantity(number, quantityOfUnit(field.unit)).toStdString());
    post(Message("MaterialPanel", "%1 of %2 → %3")
             .with(Message("MaterialPanel", field.name), m_name->text().toStdString(), shown));
}

void MaterialPanel::post(const Message& what)
{
    m_isPosted = true;
    m_stepSeconds = 0;
    m_document.post(SetMaterial{m_body, m_material}, what);
    if (isLocked()) // it was refused: what the body has stays
        showBody();
}

} // namespace knead
