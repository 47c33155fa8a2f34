#include "ui/panels/selection_panel.h"

#include "ui/materials/material_store.h"
#include "ui/materials/material_swatch.h"
#include "ui/panels/form.h"
#include "ui/selection/region_words.h"
#include "ui/selection/selection_model.h"
#include "ui/theme.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace knead {

namespace {

constexpr qint64 sizeInterval = 250;  // between readings while time runs [ms]
constexpr qint64 restPerReading = 10; // times as long as a reading takes, the window does something else
constexpr double farthest = 10;       // [m]
constexpr double usualReach = 2;      // [a]: what is proposed for "within"
constexpr double Material::*shown[] = {&Material::youngsModulus, &Material::density, &Material::yieldStress,
                                       &Material::tensileStrength};

} // namespace

SelectionPanel::SelectionPanel(Document& document, const MaterialStore& store, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_store(store)
{
    setObjectName("selectionPanel");
    makeForm(this);
    makeHead();
    makeRegionRows();
    makeMaterialRows();
    connect(&document.selected(), &SelectionModel::changed, this, &SelectionPanel::showRegion);
    connect(&document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Frame && (!m_document.isPlaying() || m_sinceSize.elapsed() > m_rest))
            showSize();
    });
    connect(&store, &MaterialStore::changed, this, &SelectionPanel::listPresets);
}

void SelectionPanel::makeHead()
{
    auto* form = qobject_cast<QFormLayout*>(layout());
    m_words = makeHeading({}, this);
    m_words->setObjectName("selectionWords");
    m_bodies = new QLabel(this);
    m_bodies->setObjectName("selectionBodies");
    m_bodies->setProperty("role", "dimmed");
    m_bodies->setWordWrap(true);
    form->addRow(m_words);
    form->addRow(m_bodies);
}

void SelectionPanel::makeRegionRows()
{
    auto* form = qobject_cast<QFormLayout*>(layout());
    const auto button = [this](const char* name, const char* image, const QString& text, const QString& tip,
                               void (SelectionPanel::*action)()) {
        auto* result = new QPushButton(icon(image), text, this);
        result->setObjectName(name);
        result->setToolTip(tip);
        connect(result, &QPushButton::clicked, this, action);
        return result;
    };
    m_fix = button("fixRegion", "fix", tr("Fix"), tr("Hold it in place (Shift+F)"), &SelectionPanel::fix);
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(m_fix, 1);
    row->addWidget(button("renormalizeRegion", "renormalize", tr("Re-normalize"),
                          tr("It takes its present shape for its own (Shift+N)"), &SelectionPanel::renormalize),
                   1);
    form->addRow(row);

    m_name = new QLineEdit(this);
    m_name->setObjectName("setName");
    m_name->setAccessibleName(tr("Name of the selection"));
    m_name->setToolTip(tr("Enter keeps the selection under this name in the model tree"));
    connect(m_name, &QLineEdit::returnPressed, this, &SelectionPanel::keep);
    auto* keeping = new QHBoxLayout;
    keeping->setSpacing(6);
    keeping->addWidget(m_name, 1);
    keeping->addWidget(
        button("keepRegion", "selection", tr("Save"), tr("Keep the selection under this name"), &SelectionPanel::keep));
    form->addRow(tr("Save as"), keeping);

    m_distance = makeField(Quantity::Length, "withinDistance", this);
    m_distance->setRange(0, farthest);
    m_distance->setToolTip(tr("Enter selects the objects that lie no farther from the selection than this"));
    connect(m_distance, &QuantityField::committed, this, &SelectionPanel::withinRequested);
    m_distance->installEventFilter(this);
    form->addRow(tr("All within"), m_distance);
}

void SelectionPanel::makeMaterialRows()
{
    auto* form = qobject_cast<QFormLayout*>(layout());
    form->addRow(makeHeading(tr("Material of its own"), this));
    m_preset = makeChoice("regionPreset", this);
    m_preset->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_preset->setMinimumContentsLength(10);
    m_preset->setMaxVisibleItems(20);
    m_preset->setPlaceholderText(tr("Choose"));
    listPresets();
    connect(m_preset, &QComboBox::activated, this, &SelectionPanel::choosePreset);
    form->addRow(tr("Material"), m_preset);
    for (double Material::*value : shown) {
        const MaterialField& row = fieldOf(value);
        QuantityField* field =
            makeField(quantityOfUnit(row.unit), QStringLiteral("region_") + QString::fromLatin1(row.key), this);
        field->setRange(row.minimum, row.maximum);
        if (*row.zero != '\0')
            field->setZeroText(QCoreApplication::translate("MaterialPanel", row.zero));
        connect(field, &QuantityField::committed, this, [this, value](double number) {
            m_material.*value = number;
            postMaterial({});
        });
        form->addRow(QCoreApplication::translate("MaterialPanel", row.name), field);
        m_fields.emplace_back(value, field);
    }
    auto* hint =
        new QLabel(tr("Takes effect at once, also while time runs. The rest of the part stays what it is."), this);
    hint->setProperty("role", "dimmed");
    hint->setWordWrap(true);
    form->addRow(hint);
}

void SelectionPanel::listPresets()
{
    m_preset->clear();
    for (const MaterialPreset& preset : m_store.all())
        m_preset->addItem(materialSwatch(preset), QString::fromStdString(preset.name));
    m_preset->setCurrentIndex(-1);
}

/// Another selection: its material begins with that of its part.
void SelectionPanel::showRegion()
{
    const Region& region = m_document.selected().region();
    if (region.isEmpty() || m_document.isEmpty())
        return;
    showSize();
    m_material = m_document.frame()->snapshot->materials[region.items.begin()->first];
    m_preset->setCurrentIndex(-1);
    for (const auto& [value, field] : m_fields) {
        field->restore();
        field->setValue(m_material.*value);
    }
    m_name->setText(QString::fromStdString(m_document.notes().freeSetName()));
    m_distance->restore();
    if (m_distance->value() == 0)
        m_distance->setValue(usualReach * m_document.content().spacing);
}

void SelectionPanel::showSize()
{
    const Region& region = m_document.selected().region();
    if (region.isEmpty() || m_document.isEmpty())
        return;
    m_sinceSize.start();
    const QString words = wordsFor(region, sizeOf(region, m_document.content(), *m_document.frame()));
    m_rest = std::max(sizeInterval, restPerReading * m_sinceSize.restart());
    m_words->setText(words);
    emit read(words);
    QStringList names;
    for (const auto& [body, items] : region.items)
        names << m_document.nameOfBody(body);
    m_bodies->setText(region.level == Level::Part ? names.join(", ") : tr("of %1").arg(names.join(", ")));
}

/// Enter also takes the distance that is proposed; the field itself tells only of one that was typed.
bool SelectionPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_distance && event->type() == QEvent::KeyPress && !m_distance->isModified()) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            emit withinRequested(m_distance->value());
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void SelectionPanel::fix()
{
    m_document.fixRegion(m_document.selected().region());
}

void SelectionPanel::renormalize()
{
    m_document.renormalizeRegion(m_document.selected().region());
}

void SelectionPanel::glue()
{
    m_document.setKindOf(m_document.selected().region(), BodyKind::glue);
}

void SelectionPanel::beginWithin()
{
    m_distance->setFocus(Qt::ShortcutFocusReason);
    m_distance->selectAll();
}

void SelectionPanel::beginKeeping()
{
    m_name->setFocus(Qt::ShortcutFocusReason);
    m_name->selectAll();
}

void SelectionPanel::choosePreset(int index)
{
    const MaterialPreset& preset = m_store.all()[static_cast<std::size_t>(index)];
    m_material = preset.material;
    for (const auto& [value, field] : m_fields)
        field->setValue(m_material.*value);
    postMaterial(Message("MaterialName", preset.name));
}

void SelectionPanel::postMaterial(const Message& name)
{
    m_document.setMaterialOf(m_document.selected().region(), m_material, name);
}

void SelectionPanel::keep()
{
    if (!m_document.keepSet(m_name->text(), m_document.selected().region()))
        emit m_document.notice(tr("A selection needs a name: type one, then save it."));
    else
        m_name->clearFocus();
}

} // namespace knead
