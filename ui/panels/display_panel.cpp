#include "ui/panels/display_panel.h"

#include "ui/panels/form.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QActionGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr int sliderSteps = 1000;
constexpr double farthest = 1e15; // of a typed range
constexpr double least = 1e-6;    // difference between its ends, in sizes of the larger one

} // namespace

DisplayPanel::DisplayPanel(Display& display, QWidget* parent)
    : QWidget(parent)
    , m_display(display)
    , m_shading(makeChoice("shading", this))
    , m_quantity(makeChoice("colorQuantity", this))
    , m_map(makeChoice("colorMap", this))
    , m_isAutomatic(boxFor(display.automaticRange(), this))
    , m_rangeRow(new QWidget(this))
    , m_mapLabel(new QLabel(tr("Map"), this))
    , m_rangeLabel(new QLabel(tr("From, to"), this))
    , m_sectionBox(new QWidget(this))
    , m_axis(makeChoice("sectionAxis", this))
    , m_offset(makeField(Quantity::Length, "sectionOffset", this))
    , m_slider(new QSlider(Qt::Horizontal, this))
{
    setObjectName("displayPanel");
    QFormLayout* form = makeForm(this);
    addSwitches(form);
    addColors(form);
    addSection(form);
    addCompare(form);
    connect(&display, &Display::changed, this, &DisplayPanel::bringUpToDate);
    bringUpToDate();
}

void DisplayPanel::addSwitches(QFormLayout* form)
{
    form->addRow(makeHeading(tr("Show"), this));
    for (QAction* action : m_display.shown())
        form->addRow(boxFor(action, this));
    for (const QAction* action : m_display.shadings()->actions()) {
        m_shading->addItem(action->text(), action->data());
        m_shading->setItemData(m_shading->count() - 1, action->toolTip(), Qt::ToolTipRole);
    }
    form->addRow(tr("Shading"), m_shading);
    connect(m_shading, &QComboBox::activated, this,
            [this](int index) { m_display.setShading(static_cast<Shading>(m_shading->itemData(index).toInt())); });
}

void DisplayPanel::addColors(QFormLayout* form)
{
    form->addRow(makeHeading(tr("Colors of the skin"), this));
    for (const QAction* action : m_display.colors()->actions())
        m_quantity->addItem(action->text(), action->data());
    m_isAutomatic->setObjectName("automaticRange");
    for (const ColorMapChoice& choice : colorMapChoices())
        m_map->addItem(QCoreApplication::translate("ColorMap", choice.title), static_cast<int>(choice.map));
    m_map->setToolTip(tr("All have even lightness; cividis looks nearly alike to people who see few colors"));
    auto* row = new QHBoxLayout(m_rangeRow);
    row->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Quantity"), m_quantity);
    form->addRow(m_mapLabel, m_map);
    form->addRow(m_isAutomatic);
    form->addRow(m_rangeLabel, m_rangeRow);
    connect(m_quantity, &QComboBox::activated, this, [this](int index) {
        const int number = m_quantity->itemData(index).toInt();
        m_display.setQuantity(number < 0 ? std::nullopt : std::optional(static_cast<SurfaceQuantity>(number)));
    });
    connect(m_map, &QComboBox::activated, this,
            [this](int index) { m_display.setMap(static_cast<ColorMap>(m_map->itemData(index).toInt())); });
}

void DisplayPanel::addSection(QFormLayout* form)
{
    form->addRow(makeHeading(tr("Look inside"), this));
    form->addRow(boxFor(m_display.section(), this));
    auto* inner = makeForm(m_sectionBox);
    inner->setContentsMargins(0, 0, 0, 0);
    m_axis->addItems({tr("X"), tr("Y"), tr("Z"), tr("Towards the eye")}); // in the order of Display::Section::Axis
    m_slider->setObjectName("sectionSlider");
    m_slider->setAccessibleName(tr("Place of the section plane"));
    m_slider->setRange(0, sliderSteps);
    inner->addRow(tr("Across"), m_axis);
    inner->addRow(tr("At"), m_offset);
    inner->addRow(m_slider);
    inner->addRow(boxFor(m_display.flip(), this));
    auto* hatched = boxFor(m_display.hatched(), this);
    hatched->setObjectName("sectionHatched");
    inner->addRow(hatched);
    form->addRow(m_sectionBox);
    connect(m_axis, &QComboBox::activated, this,
            [this](int index) { m_display.setSectionAxis(static_cast<Display::Section::Axis>(index)); });
    connect(m_offset, &QuantityField::committed, &m_display, &Display::setSectionOffset);
    connect(m_slider, &QSlider::valueChanged, this, [this](int value) {
        const auto [low, high] = m_display.sectionReach();
        m_display.setSectionOffset(low + (high - low) * value / sliderSteps);
    });
}

void DisplayPanel::addCompare(QFormLayout* form)
{
    form->addRow(makeHeading(tr("Compare"), this));
    form->addRow(boxFor(m_display.compare(), this));
    auto* hint = new QLabel(tr("Drag the line in the view: the original on the left, now on the right."), this);
    hint->setProperty("role", "dimmed");
    hint->setWordWrap(true);
    form->addRow(hint);
}

/// Fields know one kind of unit, so that another quantity gets others.
void DisplayPanel::makeRangeFields(SurfaceQuantity quantity)
{
    delete m_least;
    delete m_most;
    m_rangeQuantity = quantity;
    m_least = makeField(unitKindOf(quantity), "rangeLeast", m_rangeRow);
    m_most = makeField(unitKindOf(quantity), "rangeMost", m_rangeRow);
    for (QuantityField* field : {m_least, m_most}) {
        m_rangeRow->layout()->addWidget(field);
        field->setMinimumWidth(40);
        connect(field, &QuantityField::committed, this, &DisplayPanel::chooseRange);
    }
}

void DisplayPanel::chooseRange()
{
    m_display.setRange(std::pair(m_least->value(), m_most->value()));
}

void DisplayPanel::bringUpToDate()
{
    const SceneOptions& options = m_display.view().options();
    m_shading->setCurrentIndex(m_shading->findData(static_cast<int>(options.shading)));
    m_shading->setEnabled(m_display.shadings()->actions().front()->isEnabled());
    showColors(options);
    showSection(options);
}

void DisplayPanel::showColors(const SceneOptions& options)
{
    const std::optional<SurfaceQuantity> quantity = options.colors.quantity;
    m_quantity->setCurrentIndex(m_quantity->findData(quantity ? static_cast<int>(*quantity) : -1));
    m_quantity->setEnabled(m_display.section()->isEnabled());
    m_map->setCurrentIndex(m_map->findData(static_cast<int>(options.colors.map)));
    for (QWidget* widget : std::initializer_list<QWidget*>{m_map, m_mapLabel})
        widget->setVisible(quantity && !hasSign(*quantity));
    m_isAutomatic->setVisible(quantity.has_value());
    const bool isFixed = quantity && options.colors.range;
    m_rangeRow->setVisible(isFixed);
    m_rangeLabel->setVisible(isFixed);
    if (!isFixed)
        return;
    if (m_rangeQuantity != quantity)
        makeRangeFields(*quantity);
    const auto [from, to] = *options.colors.range;
    const double gap = least * std::max(std::abs(from), std::abs(to));
    m_least->setRange(-farthest, to - gap);
    m_most->setRange(from + gap, farthest);
    m_least->setValue(from);
    m_most->setValue(to);
}

void DisplayPanel::showSection(const SceneOptions& options)
{
    m_sectionBox->setVisible(options.section.plane.has_value());
    if (!options.section.plane)
        return;
    const Display::Section& plane = m_display.sectionPlane();
    const auto [low, high] = m_display.sectionReach();
    m_axis->setCurrentIndex(static_cast<int>(plane.axis));
    m_offset->setRange(low, high);
    m_offset->setValue(plane.offset);
    const QSignalBlocker blocker(m_slider);
    m_slider->setValue(static_cast<int>(std::lround(sliderSteps * (plane.offset - low) / std::max(high - low, 1e-12))));
}

} // namespace knead
