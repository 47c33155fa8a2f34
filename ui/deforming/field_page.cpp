#include "ui/deforming/field_page.h"

#include "core/model/field_formats.h"
#include "core/model/length_units.h"
#include "ui/panels/form.h"
#include "ui/theme.h"
#include "ui/units.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace knead {

namespace {

constexpr double mostFieldFactor = 1e4;
constexpr std::array<const char*, 3> lockNames{"X", "Y", "Z"};

QLabel* makeSentences(const char* name, const char* role, QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText); // names of files are in it
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    setRole(*label, role);
    return label;
}

} // namespace

FieldPage::FieldPage(QWidget* parent)
    : QWidget(parent)
    , m_file(makeSentences("fieldFile", "heading", this))
    , m_step(makeChoice("fieldStep", this))
    , m_name(makeChoice("fieldName", this))
    , m_unit(makeChoice("fieldUnit", this))
    , m_inPlace(new QCheckBox(tr("Lies where the part does"), this))
    , m_factor(makeField(Quantity::Number, "fieldFactor", this))
    , m_kept(new QLabel(this))
    , m_keep(new QPushButton(tr("Choose faces"), this))
    , m_keepNothing(new QPushButton(tr("Keep none"), this))
    , m_fade(makeField(Quantity::Length, "fieldFade", this))
    , m_exaggeration(makeField(Quantity::Number, "fieldExaggeration", this))
    , m_arrows(new QCheckBox(tr("Arrows"), this))
    , m_colors(new QCheckBox(tr("Colors"), this))
    , m_largest(makeReading("fieldLargest", this))
    , m_sentences(makeSentences("fieldSentences", "dimmed", this))
{
    setObjectName("fieldPage");
    QFormLayout* form = makeForm(this);
    form->addRow(m_file);
    form->addRow(tr("Step"), m_step);
    form->addRow(tr("Field"), m_name);
    form->addRow(tr("Unit"), m_unit);
    form->addRow(m_inPlace);
    form->addRow(tr("Factor"), m_factor);
    auto* locks = new QHBoxLayout;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        m_locks[axis] = new QCheckBox(QString::fromLatin1(lockNames[axis]), this);
        m_locks[axis]->setObjectName(QStringLiteral("fieldLock%1").arg(lockNames[axis]));
        m_locks[axis]->setToolTip(tr("Nothing moves along this axis"));
        locks->addWidget(m_locks[axis]);
        connect(m_locks[axis], &QCheckBox::clicked, this, [this, axis](bool on) {
            m_form.locked[axis] = on;
            emit changed();
        });
    }
    locks->addStretch(1);
    form->addRow(tr("Locked"), locks);
    form->addRow(tr("Faces that stay"), m_kept);
    auto* keeping = new QHBoxLayout;
    keeping->addWidget(m_keep);
    keeping->addWidget(m_keepNothing);
    form->addRow(keeping);
    form->addRow(tr("Fades within"), m_fade);
    form->addRow(makeHeading(tr("To look at"), this));
    form->addRow(tr("Exaggerated"), m_exaggeration);
    auto* shown = new QHBoxLayout;
    shown->addWidget(m_arrows);
    shown->addWidget(m_colors);
    shown->addStretch(1);
    form->addRow(shown);
    form->addRow(tr("Largest way"), m_largest);
    form->addRow(m_sentences);

    m_file->setAccessibleName(tr("Field"));
    m_sentences->setAccessibleName(tr("Remarks"));
    m_kept->setObjectName("fieldKept");
    m_inPlace->setObjectName("fieldInPlace");
    m_inPlace->setToolTip(tr("Else the scan is laid over the part as a rigid thing first"));
    connect(m_inPlace, &QCheckBox::clicked, this, [this] { emit choiceChanged(choice()); });
    m_keep->setObjectName("fieldKeep");
    m_keep->setCheckable(true);
    m_keep->setToolTip(tr("Click faces in the view that are to stay exactly where they are, then press this again"));
    m_keepNothing->setObjectName("fieldKeepNothing");
    m_arrows->setObjectName("fieldArrows");
    m_colors->setObjectName("fieldColors");
    m_factor->setRange(-mostFieldFactor, mostFieldFactor);
    m_factor->setStatusTip(tr("Of the displacements; -1 goes the other way, as one compensates"));
    m_fade->setRange(0, 100);
    m_fade->setZeroText(tr("by the part"));
    m_fade->setStatusTip(tr("From the faces that stay to where the whole field holds"));
    m_exaggeration->setRange(-mostFieldFactor, mostFieldFactor);
    m_exaggeration->setStatusTip(tr("Only of what is seen before it is applied"));
    m_unit->setToolTip(tr("Of lengths in the file"));
    for (const LengthUnit& unit : lengthUnits())
        m_unit->addItem(QString::fromLatin1(unit.name));
    for (QComboBox* choices : {m_step, m_name, m_unit}) {
        choices->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        connect(choices, &QComboBox::activated, this, [this] { emit choiceChanged(choice()); });
    }
    connect(m_factor, &QuantityField::committed, this, [this](double typed) {
        m_form.factor = typed;
        emit changed();
    });
    connect(m_fade, &QuantityField::committed, this, [this](double typed) {
        m_form.fade = typed;
        emit changed();
    });
    connect(m_exaggeration, &QuantityField::committed, this, [this](double typed) {
        m_form.exaggeration = typed;
        emit lookChanged();
    });
    for (const auto& [box, value] :
         {std::pair(m_arrows, &FieldForm::showsArrows), std::pair(m_colors, &FieldForm::showsColors)})
        connect(box, &QCheckBox::clicked, this, [this, value](bool on) {
            m_form.*value = on;
            emit lookChanged();
        });
    connect(m_keep, &QPushButton::toggled, this, &FieldPage::keepToggled);
    connect(m_keepNothing, &QPushButton::clicked, this, &FieldPage::keepNothingClicked);
}

void FieldPage::fill(QComboBox* choice, const std::vector<std::string>& texts, std::size_t current)
{
    choice->clear();
    for (const std::string& text : texts)
        choice->addItem(QString::fromStdString(text));
    choice->setCurrentIndex(static_cast<int>(current));
    choice->setEnabled(texts.size() > 1);
}

FieldChoice FieldPage::choice() const
{
    FieldChoice choice;
    if (m_step->currentIndex() >= 0)
        choice.step = static_cast<std::size_t>(m_step->currentIndex());
    choice.name = m_name->currentText().toStdString();
    choice.unit = m_unit->currentText().toStdString();
    choice.isInPlace = !m_inPlace->isHidden() && m_inPlace->isChecked();
    return choice;
}

void FieldPage::show(const FieldFile& file, std::size_t nodes, bool isInPlace)
{
    m_file->setText(tr("%1: %2, %3 nodes")
                        .arg(QFileInfo(QFile::decodeName(file.path.c_str())).fileName(),
                             QString::fromStdString(file.format), formatCount(nodes)));
    fill(m_step, file.steps, file.step);
    const auto name = std::ranges::find(file.names, file.name); // a scan has none
    fill(m_name, file.names, name == file.names.end() ? 0 : static_cast<std::size_t>(name - file.names.begin()));
    m_unit->setCurrentText(QString::fromStdString(file.unit));
    m_unit->setEnabled(file.format != projectFormat);
    m_inPlace->setVisible(file.format == scanFormat);
    m_inPlace->setChecked(isInPlace);
    m_factor->setValue(m_form.factor);
    m_fade->setValue(m_form.fade);
    m_exaggeration->setValue(m_form.exaggeration);
    for (std::size_t axis = 0; axis < 3; ++axis)
        m_locks[axis]->setChecked(m_form.locked[axis]);
    m_arrows->setChecked(m_form.showsArrows);
    m_colors->setChecked(m_form.showsColors);
}

void FieldPage::showSentences(const QStringList& sentences)
{
    m_sentences->setText(sentences.join(QStringLiteral("\n\n")));
    m_sentences->setVisible(!sentences.isEmpty());
}

void FieldPage::showKept(std::size_t faces)
{
    m_kept->setText(faces == 0 ? tr("none") : formatCount(faces));
    m_keepNothing->setEnabled(faces > 0);
    m_fade->setEnabled(faces > 0);
}

bool FieldPage::isChoosing() const
{
    return m_keep->isChecked();
}

void FieldPage::endChoosing()
{
    m_keep->setChecked(false);
}

void FieldPage::showLargest(double way)
{
    m_largest->setText(formatReading(way, Quantity::Length));
}

} // namespace knead
