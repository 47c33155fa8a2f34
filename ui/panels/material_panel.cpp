#include "ui/panels/material_panel.h"

#include "ui/panels/form.h"
#include "ui/theme.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

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
        {"Flow", {&Material::yieldStress, &Material::hardening, &Material::relaxationTime}},
        {"Strength", {&Material::tensileStrength, &Material::elongationAtBreak}},
        {"Surface", {&Material::friction, &Material::adhesion, &Material::healingTime}},
    };
    return all;
}

const MaterialField& fieldOf(double Material::*value)
{
    const auto& fields = materialFields();
    return *std::find_if(fields.begin(), fields.end(), [value](const MaterialField& f) { return f.value == value; });
}

} // namespace

MaterialPanel::MaterialPanel(Document& document, std::vector<MaterialPreset> presets, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_presets(std::move(presets))
{
    setObjectName("materialPanel");
    makeForm(this);
    makeBodyRows();
    makeMaterialRows();
    makeFillingRows();
    makeStepRows();
    connect(&document, &Document::changed, this, &MaterialPanel::documentChanged);
    connect(&document, &Document::looksChanged, this, [this] {
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

void MaterialPanel::makeMaterialRows()
{
    auto* form = qobject_cast<QFormLayout*>(layout());
    m_preset = makeChoice("materialPreset", this);
    m_preset->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_preset->setMinimumContentsLength(10);
    m_preset->setMaxVisibleItems(20);
    m_preset->setPlaceholderText(tr("Own numbers"));
    for (const MaterialPreset& preset : m_presets) {
        m_preset->addItem(QString::fromStdString(preset.name));
        m_preset->setItemData(m_preset->count() - 1, QString::fromStdString(preset.source), Qt::ToolTipRole);
    }
    connect(m_preset, &QComboBox::activated, this, &MaterialPanel::choosePreset);
    form->addRow(tr("Material"), m_preset);

    for (const Group& group : groups()) {
        form->addRow(makeHeading(tr(group.name), this));
        for (double Material::*value : group.values) {
            const MaterialField& row = fieldOf(value);
            QuantityField* field = makeField(quantityOfUnit(row.unit), QString::fromLatin1(row.key), this);
            field->setRange(row.minimum, row.maximum);
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

void MaterialPanel::makeStepRows()
{
    auto* form = qobject_cast<QFormLayout*>(layout());
    form->addRow(makeHeading(tr("Steps"), this));
    m_integrator = makeChoice("integrator", this);
    // In the order of Integrator.
    m_integrator->addItems({tr("Semi-implicit Euler"), tr("Forward Euler"), tr("Implicit Euler"), tr("Automatic")});
    m_integrator->setItemData(0, tr("Keeps vibrations; stiff materials take small steps"), Qt::ToolTipRole);
    m_integrator->setItemData(1, tr("As published; needs damping"), Qt::ToolTipRole);
    m_integrator->setItemData(2, tr("A step per frame for any stiffness; fast vibrations die out"), Qt::ToolTipRole);
    m_integrator->setItemData(3, tr("Implicit where the semi-implicit scheme would be slower than real time"),
                              Qt::ToolTipRole);
    connect(m_integrator, &QComboBox::activated, this, &MaterialPanel::chooseIntegrator);
    form->addRow(tr("Integrator"), m_integrator);
    m_integratorReason = new QLabel(this);
    m_integratorReason->setObjectName("integratorReason");
    m_integratorReason->setProperty("role", "dimmed");
    m_integratorReason->setWordWrap(true);
    form->addRow(m_integratorReason);
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
    case Document::Change::Content:
        m_isPosted = false;
        for (QuantityField* field : {m_spacing, m_cells})
            field->restore();
        showSpacing(m_document.content().spacing);
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
    m_postedIntegrator.reset();
    const ContentBody& body = *m_document.content().bodies[m_body];
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
    if (!m_postedIntegrator || *m_postedIntegrator == now.wantedIntegrator || !now.notice.empty()) {
        m_postedIntegrator.reset();
        m_integrator->setCurrentIndex(static_cast<int>(now.wantedIntegrator));
    }
    m_integratorReason->setText(QString::fromStdString(now.integratorReason));
    const Material& material = now.materials[m_body];
    if (m_isPosted && material != m_material && now.health.ok)
        return;
    m_isPosted = false;
    m_material = material;
    for (const auto& [value, field] : m_fields)
        field->setValue(material.*value);
    const auto preset = std::find_if(m_presets.begin(), m_presets.end(),
                                     [&](const MaterialPreset& p) { return p.material == material; });
    m_preset->setCurrentIndex(preset == m_presets.end() ? -1 : static_cast<int>(preset - m_presets.begin()));
}

void MaterialPanel::choosePreset(int index)
{
    const MaterialPreset& preset = m_presets[static_cast<std::size_t>(index)];
    m_material = preset.material;
    for (const auto& [value, field] : m_fields)
        field->restore();
    post(tr("Material of %1 → %2").arg(m_name->text(), QString::fromStdString(preset.name)));
}

void MaterialPanel::chooseKind(int index)
{
    m_postedKind = static_cast<BodyKind>(index);
    m_document.post(SetBodyKind{m_body, *m_postedKind});
}

void MaterialPanel::chooseIntegrator(int index)
{
    m_postedIntegrator = static_cast<Integrator>(index);
    m_document.post(SetIntegrator{*m_postedIntegrator});
}

void MaterialPanel::commit(double Material::*value, double number)
{
    m_material.*value = number;
    const MaterialField& field = fieldOf(value);
    const QString shown =
        number == 0 && *field.zero != '\0' ? tr(field.zero) : formatQuantity(number, quantityOfUnit(field.unit));
    post(tr("%1 of %2 → %3").arg(tr(field.name), m_name->text(), shown));
}

void MaterialPanel::post(const QString& what)
{
    m_isPosted = true;
    m_document.post(SetMaterial{m_body, m_material}, what);
}

} // namespace knead
