// How materials are chosen, kept under a name of one's own, and compared.
#include "ui/panels/material_panel.h"

#include "ui/dialogs/material_comparison_dialog.h"
#include "ui/document/table_kinds.h"
#include "ui/language/said.h"
#include "ui/materials/material_store.h"
#include "ui/materials/material_swatch.h"
#include "ui/panels/form.h"
#include "ui/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QToolButton>

namespace knead {

namespace {

constexpr int swatchSize = 20; // [pixels]

} // namespace

void MaterialPanel::makePresetRows()
{
    auto* form = qobject_cast<QFormLayout*>(layout());
    m_preset = makeChoice("materialPreset", this);
    m_preset->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_preset->setMinimumContentsLength(10);
    m_preset->setMaxVisibleItems(20);
    m_preset->setIconSize({swatchSize, swatchSize});
    m_preset->setPlaceholderText(tr("Own numbers"));
    listPresets();
    connect(m_preset, &QComboBox::activated, this, &MaterialPanel::choosePreset);
    connect(&m_store, &MaterialStore::changed, this, [this] {
        listPresets();
        showPreset();
    });
    form->addRow(tr("Material"), m_preset);

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(2);
    const auto add = [&](const char* name, const char* picture, const QString& tip) {
        auto* button = new QToolButton(this);
        button->setObjectName(name);
        button->setIcon(icon(picture));
        button->setToolTip(tip);
        button->setAccessibleName(tip);
        button->setAutoRaise(true);
        buttons->addWidget(button);
        return button;
    };
    const QToolButton* save = add("saveMaterial", "save", tr("Save these numbers as a material of your own"));
    m_rename = add("renameMaterial", "rename", tr("Rename this material of your own"));
    m_delete = add("deleteMaterial", "delete", tr("Delete this material of your own; bodies keep its numbers"));
    const QToolButton* compared =
        add("compareMaterials", "compare-two", tr("Compare with another material, side by side"));
    buttons->addStretch(1);
    connect(save, &QToolButton::clicked, this, [this] {
        askForName(tr("Save material"), {}, [this](const QString& name) { m_store.save(name, m_material); });
    });
    connect(m_rename, &QToolButton::clicked, this, [this] {
        if (const auto own = ownPreset()) {
            const MaterialPreset& preset = m_store.all()[*own];
            askForName(tr("Rename material"), QString::fromStdString(preset.name),
                       [this, id = preset.id](const QString& name) { rename(id, name); });
        }
    });
    connect(m_delete, &QToolButton::clicked, this, [this] {
        if (const auto own = ownPreset())
            m_store.remove(*own);
    });
    connect(compared, &QToolButton::clicked, this, &MaterialPanel::compare);
    form->addRow(QString(), buttons);
    m_whence = new QToolButton(this);
    m_whence->setObjectName("materialWhence");
    m_whence->setText(tr("Where the numbers come from"));
    m_whence->setCheckable(true);
    m_whence->setAutoRaise(true);
    m_whence->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_whence->setArrowType(Qt::RightArrow);
    form->addRow(m_whence);
    connect(m_whence, &QToolButton::toggled, this, &MaterialPanel::showSource);
    m_source = new QLabel(this);
    m_source->setObjectName("materialSource");
    m_source->setProperty("role", "dimmed");
    m_source->setWordWrap(true);
    form->addRow(m_source);
}

void MaterialPanel::showPreset()
{
    const auto preset = m_store.find(isKneaded(m_material) ? m_firmBase : m_material, m_chosenName);
    m_preset->setCurrentIndex(preset ? static_cast<int>(*preset) : -1);
    const auto own = ownPreset();
    m_rename->setEnabled(own.has_value());
    m_delete->setEnabled(own.has_value());
    m_source->setText(preset ? QString::fromStdString(m_store.all()[*preset].source) : QString());
    showSource();
}

/// Literature, in English: for who asks.
void MaterialPanel::showSource()
{
    const bool isKnown = !m_source->text().isEmpty();
    m_whence->setVisible(isKnown);
    m_whence->setArrowType(m_whence->isChecked() ? Qt::DownArrow : Qt::RightArrow);
    m_source->setVisible(isKnown && m_whence->isChecked());
}

void MaterialPanel::listPresets()
{
    m_preset->clear();
    for (const MaterialPreset& preset : m_store.all()) {
        m_preset->addItem(materialSwatch(preset), materialName(preset));
        m_preset->setItemData(m_preset->count() - 1, QString::fromStdString(preset.source), Qt::ToolTipRole);
    }
}

std::optional<std::size_t> MaterialPanel::ownPreset() const
{
    const auto preset = m_store.find(m_material, m_chosenName);
    return preset && m_store.isOwn(*preset) ? preset : std::nullopt;
}

void MaterialPanel::choosePreset(int index)
{
    const MaterialPreset& preset = m_store.all()[static_cast<std::size_t>(index)];
    m_material = m_firmBase = preset.material;
    m_chosenName = QString::fromStdString(preset.name);
    for (const auto& [value, field] : m_fields)
        field->restore();
    m_document.beginGesture();
    post(Message("MaterialPanel", "Material of %1 → %2")
             .with(m_name->text().toStdString(), Message("MaterialName", preset.name)));
    if (isKneaded(m_material))
        layOnTable();
    m_document.endGesture();
}

/// What is kneaded lies on a table that holds it, under its weight: unless a person said otherwise, something holds it, or the work has
/// begun.
void MaterialPanel::layOnTable()
{
    const Snapshot& now = *m_document.frame()->snapshot;
    const bool isUntouched =
        now.step == 0 && now.floorHeight && now.gravity.isZero() && now.fixtures.empty() && now.floorAdhesion == 0;
    if (!isUntouched)
        return;
    const TableKind& sticky = tableKinds()[stickyTable];
    m_document.post(SetGravity{Vec3(0, 0, -9.81)});
    m_document.post(SetFloor{now.floorHeight, sticky.friction, sticky.adhesion});
}

/// A dialog that the window does not wait for.
void MaterialPanel::askForName(const QString& title, const QString& proposed,
                               std::function<void(const QString& name)> take)
{
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName("materialNameDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    dialog->setLabelText(tr("Name of the material"));
    dialog->setTextValue(proposed);
    connect(dialog, &QInputDialog::textValueSelected, this, [this, take = std::move(take)](const QString& name) {
        m_chosenName = name.trimmed();
        take(name);
    });
    dialog->open();
}

/// Unless it has been deleted meanwhile.
void MaterialPanel::rename(const std::string& id, const QString& name)
{
    if (const auto index = m_store.withId(id))
        m_store.rename(*index, name);
}

void MaterialPanel::compare()
{
    std::vector<MaterialPreset> choices = m_store.all();
    const auto shown = m_store.find(m_material, m_chosenName);
    choices.insert(choices.begin(), {"now", tr("%1 now").arg(m_name->text()).toStdString(), "", m_material});
    if (shown) // it looks as its preset does
        choices.front().id = m_store.all()[*shown].id;
    const std::size_t right = shown && *shown + 2 < choices.size() ? *shown + 2 : 1;
    auto* dialog = new MaterialComparisonDialog(std::move(choices), right, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}

} // namespace knead
