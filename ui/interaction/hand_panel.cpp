#include "ui/interaction/hand_panel.h"

#include "ui/panels/form.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QToolButton>

#include <utility>

namespace knead {

HandPanel::HandPanel(HandSettings& settings, const QList<QAction*>& modes, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_ownAxes(new QCheckBox(tr("Along the tool's own axes"), this))
    , m_holdsRest(new QCheckBox(tr("Hold the rest"), this))
    , m_spaceMouse(makeChoice("spaceMouseDrives", this))
    , m_connection(new QLabel(this))
{
    setObjectName("handPanel");
    QFormLayout* form = makeForm(this);
    const auto begin = [&](const QString& heading, QAction* mode) {
        form->addRow(makeHeading(heading, this));
        if (mode == nullptr)
            return;
        auto* button = new QToolButton(this);
        button->setDefaultAction(mode);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        form->addRow(button);
    };
    begin(tr("Handles"), modes.value(0));
    m_ownAxes->setObjectName("gizmoOwnAxes");
    form->addRow(m_ownAxes);
    add(tr("Move step"), "moveStep", Quantity::Length, 1e-6, 10, &HandChoices::moveStep,
        tr("Handles move in steps of this length while Ctrl is held"));
    add(tr("Turn step"), "turnStep", Quantity::Angle, 1e-4, 4, &HandChoices::turnStep,
        tr("Handles turn in steps of this angle while Ctrl is held"));
    begin(tr("Keyboard"), modes.value(1));
    add(tr("Key step"), "keyStep", Quantity::Length, 1e-6, 10, &HandChoices::keyStep,
        tr("A key press moves a tool by this length"));
    add(tr("Steps per second"), "stepsPerSecond", Quantity::Rate, 0.1, 1000, &HandChoices::stepsPerSecond,
        tr("While a key is held; a tool never goes faster than its speed limit"));
    begin(tr("Pressing"), modes.value(2));
    begin(tr("Brushes"), nullptr);
    add(tr("Radius"), "sculptRadius", Quantity::Length, 0, 10, &HandChoices::sculptRadius,
        tr("Of what a brush takes or presses; also with [ and ]"));
    add(tr("Strength"), "sculptStrength", Quantity::Number, 0.1, 20, &HandChoices::sculptStrength,
        tr("Of the force that suits the material; also with Shift and the mouse wheel"));
    m_holdsRest->setObjectName("holdsRestBox");
    m_holdsRest->setToolTip(
        tr("What is far from the brush is held as by the other hand, where nothing else holds the part"));
    form->addRow(m_holdsRest);
    begin(tr("Pulling"), modes.value(3));
    add(tr("Spring stiffness"), "pullStiffness", Quantity::Stiffness, 0, 1e12, &HandChoices::pullStiffness,
        tr("Of the spring between the mouse and the material"));
    add(tr("Largest pull"), "pullLimit", Quantity::Force, 0, 1e12, &HandChoices::pullLimit,
        tr("The hand does not pull harder than this"));
    begin(tr("3D mouse"), nullptr);
    m_connection->setObjectName("spaceMouseState");
    m_connection->setProperty("role", "dimmed");
    m_connection->setWordWrap(true);
    form->addRow(m_connection);
    m_spaceMouse->addItems({tr("Camera"), tr("Selected tool")});
    form->addRow(tr("Drives"), m_spaceMouse);
    add(tr("Rate"), "spaceMouseRate", Quantity::Number, 0.1, 10, &HandChoices::spaceMouseRate,
        tr("Of its speeds; 1 is usual"));
    for (const Number& number : m_numbers)
        if (number.value == &HandChoices::pullStiffness || number.value == &HandChoices::pullLimit)
            number.field->setZeroText(tr("by the material"));
        else if (number.value == &HandChoices::sculptRadius)
            number.field->setZeroText(tr("by the part"));
    for (const auto& [box, choice] :
         {std::pair(m_ownAxes, &HandChoices::ownAxes), std::pair(m_holdsRest, &HandChoices::holdsRest)})
        connect(box, &QCheckBox::toggled, this, [this, to = choice](bool on) {
            HandChoices choices = m_settings.choices();
            choices.*to = on;
            m_settings.set(choices);
        });
    connect(m_spaceMouse, &QComboBox::activated, this, [this](int index) {
        HandChoices choices = m_settings.choices();
        choices.spaceMouseDrivesTool = index == 1;
        m_settings.set(choices);
    });
    connect(&settings, &HandSettings::changed, this, &HandPanel::showChoices);
    showChoices();
    showSpaceMouse(false);
}

void HandPanel::add(const QString& title, const char* name, Quantity quantity, double low, double high,
                    double HandChoices::*value, const QString& tip)
{
    QuantityField* field = makeField(quantity, name, this);
    field->setRange(low, high);
    field->setStatusTip(tip);
    connect(field, &QuantityField::committed, this, [this, value](double typed) {
        HandChoices choices = m_settings.choices();
        choices.*value = typed;
        m_settings.set(choices);
    });
    auto* form = qobject_cast<QFormLayout*>(layout());
    form->addRow(title, field);
    form->labelForField(field)->setToolTip(tip);
    m_numbers.push_back({field, value});
}

void HandPanel::showChoices()
{
    const HandChoices& choices = m_settings.choices();
    for (const Number& number : m_numbers)
        number.field->setValue(choices.*number.value);
    m_ownAxes->setChecked(choices.ownAxes);
    m_holdsRest->setChecked(choices.holdsRest);
    m_spaceMouse->setCurrentIndex(choices.spaceMouseDrivesTool ? 1 : 0);
}

void HandPanel::showSpaceMouse(bool isConnected)
{
    m_connection->setText(isConnected ? tr("Connected. First button: fit; second: camera or tool.")
                                      : tr("None: it works as soon as spacenavd runs."));
}

} // namespace knead
