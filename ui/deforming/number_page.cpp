#include "ui/deforming/number_page.h"

#include "ui/panels/form.h"
#include "ui/theme.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QStandardItemModel>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knead {

namespace {

constexpr double mostTurns = 20;   // of a bend or a twist
constexpr double mostFactor = 1e3; // of a taper, a stretch, a scale
constexpr std::array<double, 3> staysOf{0, 0.5, 1};

/// "Z": the axis of the world that a direction is nearest to.
QString axisName(const Vec3& direction)
{
    Eigen::Index axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    return QStringLiteral("XYZ").mid(static_cast<int>(axis), 1);
}

} // namespace

NumberPage::NumberPage(QWidget* parent)
    : QWidget(parent)
    , m_kinds(new QButtonGroup(this))
    , m_parts(makeChoice("deformParts", this))
    , m_along(makeChoice("deformAxis", this))
    , m_side(makeChoice("deformSide", this))
    , m_stays(makeChoice("deformStays", this))
    , m_eases(new QCheckBox(tr("Begins and ends gently"), this))
    , m_how(makeChoice("deformHow", this))
    , m_letsGo(new QCheckBox(tr("Let go at the end"), this))
{
    setObjectName("numberPage");
    QFormLayout* form = makeForm(this);
    addKinds(form);
    addRows(form);
    connectFields();
}

void NumberPage::addKinds(QFormLayout* form)
{
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    for (const NumberKindLook& look : numberKindLooks()) {
        auto* button = new QToolButton(this);
        QString text = QCoreApplication::translate("Actions", look.text);
        button->setText(text.remove(QStringLiteral("...")));
        button->setObjectName(QStringLiteral("deformKind") + look.name);
        button->setIcon(icon(look.icon));
        button->setToolTip(QCoreApplication::translate("Actions", look.tip));
        button->setAccessibleName(button->text());
        button->setCheckable(true);
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        button->setIconSize({24, 24});
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        const int number = static_cast<int>(look.kind);
        m_kinds->addButton(button, number);
        grid->addWidget(button, 0, number);
    }
    form->addRow(grid);
}

void NumberPage::addRows(QFormLayout* form)
{
    m_parts->addItems({tr("All"), tr("The selected ones")});
    form->addRow(tr("Parts"), m_parts);
    m_along->addItems({QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z"), tr("The longest side"),
                       tr("Normal of the selected face")});
    m_along->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    form->addRow(tr("Axis"), m_along);
    m_from = addField(form, tr("First plane"), "deformFrom", Quantity::Length,
                      tr("Where it begins, along the axis from the origin"));
    m_to = addField(form, tr("Second plane"), "deformTo", Quantity::Length,
                    tr("Where it ends, along the axis from the origin"));
    m_side->addItems({QStringLiteral("Z"), QStringLiteral("Y")});
    form->addRow(tr("Toward"), m_side);
    m_angle = addField(form, tr("Angle"), "deformAngle", Quantity::Angle,
                       tr("Of the second plane against the first one; below 0 the other way"));
    m_radius = addField(form, tr("Radius"), "deformRadius", Quantity::Length,
                        tr("Of the line that keeps its length; the angle follows"));
    m_neutral = addField(form, tr("Neutral line"), "deformNeutral", Quantity::Number,
                         tr("What keeps its length: 0 at the inner side, 1 at the outer one. Sheet metal has some "
                            "0.33 to 0.5, its k-factor"));
    m_neutralPlace = addField(form, tr("Neutral place"), "deformNeutralPlace", Quantity::Length,
                              tr("The same as a place along the side that it bends toward"));
    m_factor =
        addField(form, tr("Factor"), "deformFactor", Quantity::Number, tr("Of the second plane; 1 changes nothing"));
    m_length = addField(form, tr("New length"), "deformLength", Quantity::Length,
                        tr("Between the planes afterwards; the factor follows"));
    m_shift = addField(form, tr("Shift"), "deformShift", Quantity::Length, tr("Of the second plane, sideways"));
    m_stays->addItems({tr("The first plane"), tr("The middle"), tr("The second plane")});
    form->addRow(tr("Stays in place"), m_stays);
    m_eases->setObjectName("deformEases");
    m_eases->setToolTip(tr("Without a crease at the planes; in the middle there is then more of it"));
    form->addRow(m_eases);
    m_how->addItems({tr("Exactly"), tr("By physics")});
    m_how->setToolTip(tr("Exactly: all goes as the formula says. By physics: what lies beyond the planes is held by "
                         "grips that go as the formula says, and the material between them finds its own shape"));
    form->addRow(tr("How"), m_how);
    m_duration = addField(form, tr("Time it takes"), "deformDuration", Quantity::Time,
                          tr("Of the way of the grips; material that flows resists less when it is slow"));
    m_letsGo->setObjectName("deformLetsGo");
    m_letsGo->setToolTip(tr("The grip that has moved most opens, so that elastic material springs back"));
    form->addRow(m_letsGo);
    m_duration->setRange(0.01, 3600);
    m_angle->setRange(-mostTurns * std::numbers::pi, mostTurns * std::numbers::pi);
    m_radius->setRange(1e-6, 1e6);
    m_neutral->setRange(-10, 10);
    m_factor->setRange(1 / mostFactor, mostFactor);
    m_length->setRange(1e-9, 1e6);
}

QuantityField* NumberPage::addField(QFormLayout* form, const QString& title, const char* name, Quantity quantity,
                                    const QString& tip)
{
    QuantityField* field = makeField(quantity, name, this);
    field->setStatusTip(tip);
    form->addRow(title, field);
    form->labelForField(field)->setToolTip(tip);
    return field;
}

void NumberPage::connectFields()
{
    connect(m_kinds, &QButtonGroup::idClicked, this,
            [this](int id) { change([id](NumberForm& f) { f.kind = static_cast<NumberKind>(id); }); });
    connect(m_parts, &QComboBox::activated, this, &NumberPage::partsChanged);
    connect(m_along, &QComboBox::activated, this, [this](int index) {
        change([&](NumberForm& f) {
            f.along = static_cast<NumberForm::Along>(index);
            takeReach(f, m_subject);
        });
    });
    connect(m_side, &QComboBox::activated, this,
            [this](int index) { change([index](NumberForm& f) { f.isOtherSide = index == 1; }); });
    connect(m_stays, &QComboBox::activated, this, [this](int index) {
        change([index](NumberForm& f) { f.stays = staysOf[static_cast<std::size_t>(index)]; });
    });
    connect(m_eases, &QCheckBox::clicked, this, [this](bool on) { change([on](NumberForm& f) { f.eases = on; }); });
    connect(m_how, &QComboBox::activated, this,
            [this](int index) { change([index](NumberForm& f) { f.isByPhysics = index == 1; }); });
    connect(m_letsGo, &QCheckBox::clicked, this, [this](bool on) { change([on](NumberForm& f) { f.letsGo = on; }); });
    for (const auto& [field, value] : {std::pair(m_from, &NumberForm::from),
                                       {m_to, &NumberForm::to},
                                       {m_angle, &NumberForm::angle},
                                       {m_neutral, &NumberForm::neutral},
                                       {m_factor, &NumberForm::factor},
                                       {m_shift, &NumberForm::shift},
                                       {m_duration, &NumberForm::duration}})
        connect(field, &QuantityField::committed, this,
                [this, value](double typed) { change([=](NumberForm& f) { f.*value = typed; }); });
    connect(m_radius, &QuantityField::committed, this, [this](double radius) {
        change([radius](NumberForm& f) { f.angle = std::copysign((f.to - f.from) / radius, f.angle); });
    });
    connect(m_length, &QuantityField::committed, this,
            [this](double length) { change([length](NumberForm& f) { f.factor = length / (f.to - f.from); }); });
    connect(m_neutralPlace, &QuantityField::committed, this,
            [this](double place) { change([&](NumberForm& f) { f.neutral = neutralShare(f, m_subject, place); }); });
}

void NumberPage::change(const std::function<void(NumberForm&)>& change)
{
    NumberForm next = m_form;
    change(next);
    set(next);
    emit changed(m_form);
}

void NumberPage::show(const NumberForm& form, const NumberSubject& subject, bool hasManyParts)
{
    m_subject = subject;
    setRowVisible(m_parts, hasManyParts);
    if (!hasManyParts)
        m_parts->setCurrentIndex(0);
    const auto* along = qobject_cast<QStandardItemModel*>(m_along->model());
    along->item(static_cast<int>(NumberForm::Along::face))->setEnabled(subject.faceNormal.has_value());
    set(form);
}

void NumberPage::set(const NumberForm& form)
{
    m_form = form;
    showRows();
    showValues();
}

bool NumberPage::isOfSelected() const
{
    return m_parts->currentIndex() == 1;
}

void NumberPage::setRowVisible(QWidget* field, bool on)
{
    field->setVisible(on);
    if (QWidget* label = qobject_cast<QFormLayout*>(layout())->labelForField(field))
        label->setVisible(on);
}

/// Only what the kind has.
void NumberPage::showRows()
{
    const NumberKind kind = m_form.kind;
    const bool bends = kind == NumberKind::bend;
    setRowVisible(m_side, hasSide(kind));
    setRowVisible(m_angle, hasAngle(kind));
    setRowVisible(m_factor, hasFactor(kind));
    setRowVisible(m_length, kind == NumberKind::stretch);
    setRowVisible(m_shift, kind == NumberKind::shear);
    for (QuantityField* field : {m_radius, m_neutral, m_neutralPlace})
        setRowVisible(field, bends);
    m_eases->setVisible(!m_form.isByPhysics);
    setRowVisible(m_duration, m_form.isByPhysics);
    m_letsGo->setVisible(m_form.isByPhysics);
}

void NumberPage::showValues()
{
    m_kinds->button(static_cast<int>(m_form.kind))->setChecked(true);
    m_along->setCurrentIndex(static_cast<int>(m_form.along));
    const NumberAxes axes = axesOf(m_form, m_subject);
    for (int side = 0; side < 2; ++side)
        m_side->setItemText(side, axisName(axes.sides[static_cast<std::size_t>(side)]));
    m_side->setCurrentIndex(m_form.isOtherSide ? 1 : 0);
    m_from->setValue(m_form.from);
    m_to->setValue(m_form.to);
    m_angle->setValue(m_form.angle);
    m_factor->setValue(m_form.factor);
    m_length->setValue(m_form.factor * (m_form.to - m_form.from));
    m_shift->setValue(m_form.shift);
    m_neutral->setValue(m_form.neutral);
    m_neutralPlace->setValue(neutralPlace(m_form, m_subject));
    if (m_form.angle == 0)
        m_radius->setNoValue(tr("straight"));
    else
        m_radius->setValue(radiusOfLine(m_form));
    const auto* const stays = std::ranges::find(staysOf, m_form.stays);
    m_stays->setCurrentIndex(static_cast<int>(stays - staysOf.begin()));
    m_eases->setChecked(m_form.eases);
    m_how->setCurrentIndex(m_form.isByPhysics ? 1 : 0);
    m_duration->setValue(m_form.duration);
    m_letsGo->setChecked(m_form.letsGo);
}

void NumberPage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        showValues();
}

} // namespace knead
