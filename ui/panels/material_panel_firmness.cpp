// Softer or firmer by one slider, as clay is when it is wet or dry, warm or cold.
#include "ui/panels/material_panel.h"

#include "core/aggregate/firmness.h"
#include "ui/document/table_kinds.h"
#include "ui/language/said.h"
#include "ui/materials/material_store.h"
#include "ui/panels/form.h"
#include "ui/units.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

#include <cmath>

namespace knead {

namespace {

constexpr int notches = 8;   // of the slider either way from the middle
constexpr int perDouble = 4; // notches

double factorOf(int notch)
{
    return std::exp2(static_cast<double>(notch) / perDouble);
}

/// The notch at which a material has the numbers of another one; none: nowhere.
std::optional<int> notchOf(const Material& base, const Material& material)
{
    if (!isKneaded(base) || !isKneaded(material))
        return {};
    const double notch = std::round(perDouble * std::log2(material.yieldStress / base.yieldStress));
    if (std::abs(notch) > notches)
        return {};
    const auto found = static_cast<int>(notch);
    return firmer(base, factorOf(found)) == material ? std::optional(found) : std::nullopt;
}

} // namespace

void MaterialPanel::makeFirmnessRow()
{
    auto* form = qobject_cast<QFormLayout*>(layout());
    m_firmnessRow = new QWidget(this);
    auto* row = new QHBoxLayout(m_firmnessRow);
    row->setContentsMargins(0, 0, 0, 0);
    m_firmness = new QSlider(Qt::Horizontal, m_firmnessRow);
    m_firmness->setObjectName("materialFirmness");
    m_firmness->setAccessibleName(tr("Softer / firmer"));
    m_firmness->setRange(-notches, notches);
    m_firmness->setPageStep(perDouble);
    m_firmness->setTickPosition(QSlider::TicksBelow);
    m_firmness->setTickInterval(perDouble);
    m_firmness->setToolTip(tr("Softer to the left, as warm or wet clay; firmer to the right, as cold or dry clay"));
    m_firmnessReading = new QLabel(m_firmnessRow);
    m_firmnessReading->setObjectName("materialFirmnessReading");
    m_firmnessReading->setMinimumWidth(fontMetrics().horizontalAdvance(tr("%1 times").arg("0.25")));
    row->addWidget(m_firmness, 1);
    row->addWidget(m_firmnessReading);
    form->addRow(tr("Softer / firmer"), m_firmnessRow);
    connect(m_firmness, &QSlider::valueChanged, this, [this](int notch) {
        showFirmnessReading(notch);
        if (!m_firmness->isSliderDown())
            chooseFirmness(notch);
    });
    connect(m_firmness, &QSlider::sliderReleased, this, [this] { chooseFirmness(m_firmness->value()); });
}

void MaterialPanel::showFirmnessReading(int notch)
{
    m_firmnessReading->setText(
        notch == 0
            ? tr("as it is")
            : said(Message("MaterialPanel", "%1 times").with(localNumber(factorOf(notch), 'g', 2).toStdString())));
}

/// Of which material the present one is a softer or firmer kind: of the one that it was, of a preset, or of itself.
void MaterialPanel::findFirmness()
{
    m_firmnessRow->setVisible(isKneaded(m_material));
    qobject_cast<QFormLayout*>(layout())->labelForField(m_firmnessRow)->setVisible(isKneaded(m_material));
    if (!isKneaded(m_material) || m_firmness->isSliderDown())
        return;
    std::optional<int> notch = notchOf(m_firmBase, m_material);
    for (const MaterialPreset& preset : m_store.all())
        if (!notch && (notch = notchOf(preset.material, m_material)))
            m_firmBase = preset.material;
    if (!notch)
        m_firmBase = m_material;
    const QSignalBlocker blocker(m_firmness);
    m_firmness->setValue(notch.value_or(0));
    showFirmnessReading(m_firmness->value());
}

void MaterialPanel::chooseFirmness(int notch)
{
    const Material wanted = firmer(m_firmBase, factorOf(notch));
    if (wanted == m_material)
        return;
    m_material = wanted;
    for (const auto& [value, field] : m_fields)
        field->restore();
    post(notch == 0  ? Message("MaterialPanel", "Firmness of %1 as it was").with(m_name->text().toStdString())
         : notch < 0 ? Message("MaterialPanel", "%1 softer").with(m_name->text().toStdString())
                     : Message("MaterialPanel", "%1 firmer").with(m_name->text().toStdString()));
}

} // namespace knead
