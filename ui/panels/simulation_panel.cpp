#include "ui/panels/simulation_panel.h"

#include "ui/document/table_kinds.h"
#include "ui/language/said.h"
#include "ui/materials/material_swatch.h"
#include "ui/panels/choice_menu.h"
#include "ui/panels/form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QThread>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr std::array<double, 9> speeds{0.01, 0.05, 0.1, 0.25, 0.5, 1, 2, 4, 10};
constexpr int realTimeIndex = 5;       // index
constexpr double largestGravity = 1e4; // [m/s^2]

struct Planet {
    const char* name;
    double gravity; ///< downwards [m/s^2]
};
constexpr std::array<Planet, 5> planets{{{QT_TRANSLATE_NOOP("SimulationPanel", "None"), 0},
                                         {QT_TRANSLATE_NOOP("SimulationPanel", "Earth"), 9.81},
                                         {QT_TRANSLATE_NOOP("SimulationPanel", "Moon"), 1.62},
                                         {QT_TRANSLATE_NOOP("SimulationPanel", "Mars"), 3.73},
                                         {QT_TRANSLATE_NOOP("SimulationPanel", "Jupiter"), 24.79}}};

QString speedText(double speed)
{
    if (speed == 1)
        return SimulationPanel::tr("Real time");
    return speed < 1 ? said(Message("SimulationPanel", "1/%1 of real time").with(numberMessage(1 / speed)))
                     : said(Message("SimulationPanel", "%1 times real time").with(numberMessage(speed)));
}

/// What all materials have; none where they differ.
std::optional<double> common(const std::vector<Material>& materials, double Material::*value)
{
    for (const Material& material : materials)
        if (material.*value != materials.front().*value)
            return std::nullopt;
    return materials.front().*value;
}

} // namespace

SimulationPanel::SimulationPanel(Document& document, QAction* keepUp, bool choosesThreads, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
{
    setObjectName("simulationPanel");
    QFormLayout* form = makeForm(this);
    makeTimeRows(form);
    makeGravityRows(form);
    makeTableRows(form);
    makeDampingRows(form);
    makeStepRows(form, keepUp);
    if (choosesThreads)
        makeThreadRow(form);
    connect(&document, &Document::changed, this, &SimulationPanel::documentChanged);
    setEnabled(false);
}

void SimulationPanel::makeTimeRows(QFormLayout* form)
{
    form->addRow(makeHeading(tr("Time"), this));
    m_speed = makeChoice("simulationSpeed", this);
    for (const double speed : speeds)
        m_speed->addItem(speedText(speed));
    m_speed->setCurrentIndex(realTimeIndex);
    m_speed->setToolTip(tr("How fast simulated time runs when the machine keeps up: slow motion shows what is quick"));
    connect(m_speed, &QComboBox::activated, this, &SimulationPanel::chooseSpeed);
    form->addRow(tr("Speed"), m_speed);
    m_time = makeReading("simulatedTime", this);
    m_step = makeReading("timeStepInUse", this);
    m_step->setToolTip(tr("Simulated time of one step; the largest stable one with a margin"));
    form->addRow(tr("Simulated"), m_time);
    form->addRow(tr("Time step"), m_step);
}

void SimulationPanel::makeGravityRows(QFormLayout* form)
{
    form->addRow(makeHeading(tr("Gravity"), this));
    m_planet = makeChoice("gravityPreset", this);
    for (const Planet& planet : planets)
        m_planet->addItem(tr(planet.name));
    m_planet->setPlaceholderText(tr("Own numbers"));
    connect(m_planet, &QComboBox::activated, this, &SimulationPanel::choosePlanet);
    form->addRow(tr("As on"), m_planet);
    constexpr const char* axes[] = {"X", "Y", "Z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        m_gravity[axis] = makeField(Quantity::Acceleration, QStringLiteral("gravity%1").arg(axes[axis]), this);
        m_gravity[axis]->setRange(-largestGravity, largestGravity);
        connect(m_gravity[axis], &QuantityField::committed, this, &SimulationPanel::commitGravity);
        form->addRow(said(Message("SimulationPanel", "Along %1").with(axes[axis])), m_gravity[axis]);
    }
}

void SimulationPanel::makeTableRows(QFormLayout* form)
{
    form->addRow(makeHeading(tr("Table"), this));
    m_table = makeChoice("tableKind", this);
    m_table->addItem(tr("None"));
    for (const TableKind& kind : tableKinds()) {
        m_table->addItem(QCoreApplication::translate("TableKinds", kind.name));
        m_table->setItemData(m_table->count() - 1, QCoreApplication::translate("TableKinds", kind.tip),
                             Qt::ToolTipRole);
    }
    m_table->setPlaceholderText(tr("Own numbers"));
    connect(m_table, &QComboBox::activated, this, &SimulationPanel::chooseTable);
    form->addRow(tr("Surface"), m_table);
    m_tableFriction = makeField(Quantity::Number, "tableFriction", this);
    m_tableFriction->setRange(0, 2);
    m_tableFriction->setToolTip(tr("In a contact it is the geometric mean with that of the material"));
    connect(m_tableFriction, &QuantityField::committed, this,
            [this](double number) { commitTable(number, m_tableAdhesion->value()); });
    form->addRow(tr("Friction"), m_tableFriction);
    m_tableAdhesion = makeField(Quantity::Pressure, "tableAdhesion", this);
    m_tableAdhesion->setRange(0, 1e9);
    m_tableAdhesion->setToolTip(tr("Tension that holds down what has touched the table; 0: nothing sticks to it"));
    connect(m_tableAdhesion, &QuantityField::committed, this,
            [this](double number) { commitTable(m_tableFriction->value(), number); });
    form->addRow(tr("Adhesion"), m_tableAdhesion);
}

void SimulationPanel::makeDampingRows(QFormLayout* form)
{
    form->addRow(makeHeading(tr("Damping of all bodies"), this));
    const auto add = [&](double Material::*value, const char* name) {
        const MaterialField& field = fieldOf(value);
        QuantityField* edit = makeField(quantityOfUnit(field.unit), name, this);
        edit->setRange(field.minimum, field.maximum);
        connect(edit, &QuantityField::committed, this,
                [this, value, label = field.name](double number) { commitDamping(value, number, label); });
        form->addRow(QCoreApplication::translate("MaterialPanel", field.name), edit);
        return edit;
    };
    m_damping = add(&Material::dampingRatio, "allDampingRatio");
    m_shapeDamping = add(&Material::shapeDamping, "allShapeDamping");
}

void SimulationPanel::makeStepRows(QFormLayout* form, QAction* keepUp)
{
    form->addRow(makeHeading(tr("Steps"), this));
    m_integrator = makeChoice("integrator", this);
    // In the order of Integrator.
    m_integrator->addItems({tr("Semi-implicit Euler"), tr("Forward Euler"), tr("Implicit Euler"), tr("Automatic")});
    m_integrator->setItemData(0, tr("Keeps vibrations; stiff materials take small steps"), Qt::ToolTipRole);
    m_integrator->setItemData(1, tr("As published; needs damping"), Qt::ToolTipRole);
    m_integrator->setItemData(2, tr("A step per frame for any stiffness; fast vibrations die out"), Qt::ToolTipRole);
    m_integrator->setItemData(3, tr("Implicit where the semi-implicit scheme would be slower than real time"),
                              Qt::ToolTipRole);
    connect(m_integrator, &QComboBox::activated, this, &SimulationPanel::chooseIntegrator);
    form->addRow(tr("Integrator"), m_integrator);
    m_integratorReason = new QLabel(this);
    m_integratorReason->setObjectName("integratorReason");
    m_integratorReason->setProperty("role", "dimmed");
    m_integratorReason->setWordWrap(true);
    form->addRow(m_integratorReason);
    form->addRow(boxFor(keepUp, this));
}

void SimulationPanel::makeThreadRow(QFormLayout* form)
{
    const int most = std::max(1, QThread::idealThreadCount());
    m_threads = makeChoice("threads", this);
    m_threads->addItem(said(Message("SimulationPanel", "All %1").with(most)));
    for (int threads = 1; threads < most; ++threads)
        m_threads->addItem(QString::number(threads));
    m_threads->setToolTip(tr("How many threads compute; the results are the same bits with any number"));
    connect(m_threads, &QComboBox::activated, this, &SimulationPanel::threadsChosen);
    form->addRow(tr("Threads"), m_threads);
}

QList<QMenu*> SimulationPanel::newMenus(QWidget* window) const
{
    return {menuOf(m_speed, tr("Speed"), window), menuOf(m_planet, tr("Gravity as on"), window),
            menuOf(m_table, tr("Table"), window), menuOf(m_integrator, tr("Integrator"), window)};
}

void SimulationPanel::showThreads(int threads)
{
    if (m_threads != nullptr)
        m_threads->setCurrentIndex(threads < m_threads->count() ? threads : 0);
}

void SimulationPanel::documentChanged(Document::Change what)
{
    const bool isSimulated = !m_document.content().bodies.empty();
    setEnabled(isSimulated);
    if (!isSimulated)
        return;
    if (what == Document::Change::Model || what == Document::Change::Moment) { // what was posted before is not to come
        m_postedIntegrator.reset();
        m_gravityRequest = m_tableRequest = m_dampingRequest = 0;
    }
    if (what != Document::Change::Selection && what != Document::Change::Fixtures && what != Document::Change::History)
        showState();
}

/// Shows what the simulation has, unless a change of ours is still on its way to it.
void SimulationPanel::showState()
{
    const Snapshot& now = *m_document.frame()->snapshot;
    m_time->setText(formatReading(now.time, Quantity::Time));
    m_step->setText(formatReading(now.timeStep, Quantity::Time));
    if (m_document.hasSeen(m_gravityRequest))
        showGravity(now.gravity);
    if (m_document.hasSeen(m_tableRequest))
        showTable(now);
    if (m_document.hasSeen(m_dampingRequest))
        showDamping(now);
    if (!m_postedIntegrator || *m_postedIntegrator == now.wantedIntegrator || !now.notice.empty()) {
        m_postedIntegrator.reset();
        m_integrator->setCurrentIndex(static_cast<int>(now.wantedIntegrator));
    }
    m_integratorReason->setText(said(now.integratorReason));
}

void SimulationPanel::showGravity(const Vec3& gravity)
{
    if (!gravity.isZero())
        m_wantedGravity = gravity;
    for (int axis = 0; axis < 3; ++axis)
        m_gravity[static_cast<std::size_t>(axis)]->setValue(gravity[axis] == 0 ? 0 : gravity[axis]); // no "-0"
    const auto planet = std::find_if(planets.begin(), planets.end(),
                                     [&](const Planet& one) { return gravity == Vec3(0, 0, -one.gravity); });
    m_planet->setCurrentIndex(planet == planets.end() ? -1 : static_cast<int>(planet - planets.begin()));
}

void SimulationPanel::showTable(const Snapshot& now)
{
    const bool isThere = now.floorHeight.has_value();
    const int kind = tableKindOf(now.floorFriction, now.floorAdhesion);
    m_table->setCurrentIndex(!isThere ? 0 : kind < 0 ? -1 : kind + 1);
    for (QuantityField* field : {m_tableFriction, m_tableAdhesion})
        field->setEnabled(isThere);
    m_tableFriction->setValue(now.floorFriction);
    m_tableAdhesion->setValue(now.floorAdhesion);
}

/// A field without a number where the bodies differ.
void SimulationPanel::showDamping(const Snapshot& now)
{
    for (const auto& [field, value] :
         {std::pair(m_damping, &Material::dampingRatio), std::pair(m_shapeDamping, &Material::shapeDamping)}) {
        if (const auto all = common(now.materials, value))
            field->setValue(*all);
        else
            field->setNoValue(tr("different"));
    }
}

void SimulationPanel::chooseSpeed(int index)
{
    const double speed = speeds[static_cast<std::size_t>(index)];
    m_document.setSpeed(speed);
    emit speedChanged(speed);
}

void SimulationPanel::choosePlanet(int index)
{
    const Planet& planet = planets[static_cast<std::size_t>(index)];
    m_document.post(SetGravity{Vec3(0, 0, planet.gravity == 0 ? 0 : -planet.gravity)});
}

void SimulationPanel::chooseTable(int index)
{
    const Snapshot& now = *m_document.frame()->snapshot;
    if (index == 0) {
        m_document.post(SetFloor{{}, now.floorFriction, now.floorAdhesion});
        m_tableRequest = m_document.requests();
    } else {
        const TableKind& kind = tableKinds()[static_cast<std::size_t>(index) - 1];
        commitTable(kind.friction, kind.adhesion);
    }
}

/// Where it is, or below the part as it was opened.
void SimulationPanel::commitTable(double friction, double adhesion)
{
    const std::optional<double> height = m_document.frame()->snapshot->floorHeight;
    m_document.post(SetFloor{height.value_or(m_document.content().box.min().z()), friction, adhesion});
    m_tableRequest = m_document.requests();
}

void SimulationPanel::commitGravity()
{
    m_document.post(SetGravity{Vec3(m_gravity[0]->value(), m_gravity[1]->value(), m_gravity[2]->value())});
    m_gravityRequest = m_document.requests();
}

/// One entry of the history, however many bodies there are.
void SimulationPanel::commitDamping(double Material::*value, double number, const char* name)
{
    if (m_document.hasSeen(m_dampingRequest))
        m_damped = m_document.frame()->snapshot->materials;
    bool isRefused = false; // by a body that is locked
    m_document.beginGesture();
    for (BodyId body = 0; body < m_damped.size(); ++body) {
        Material& material = m_damped[body];
        material.*value = number;
        m_document.post(SetMaterial{body, material},
                        Message("SimulationPanel", "%1 of all bodies").with(Message("MaterialPanel", name)));
        isRefused = isRefused || m_document.isLocked({Selection::Kind::Body, body});
    }
    m_dampingRequest = m_document.requests();
    m_document.endGesture();
    if (isRefused) { // those of others are on their way
        m_dampingRequest = 0;
        showDamping(*m_document.frame()->snapshot);
    }
}

void SimulationPanel::chooseIntegrator(int index)
{
    m_postedIntegrator = static_cast<Integrator>(index);
    m_document.post(SetIntegrator{*m_postedIntegrator});
}

} // namespace knead
