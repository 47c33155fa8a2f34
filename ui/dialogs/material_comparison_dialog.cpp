#include "ui/dialogs/material_comparison_dialog.h"

#include "ui/materials/material_swatch.h"
#include "ui/panels/form.h"
#include "ui/units.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QEvent>
#include <QHeaderView>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr QSize dialogSize(620, 560);

/// Translated where the panel of materials has it.
QString wordOfCore(const char* text)
{
    return QCoreApplication::translate("MaterialPanel", text);
}

QString textOf(double number, Quantity quantity, const char* zero)
{
    return number == 0 && *zero != '\0' ? wordOfCore(zero) : formatQuantity(number, quantity);
}

/// Three digits, and never a power of ten: "2.5", "13.4", "1,050,000".
/// @pre ratio is at least 0.1
QString digitsOf(double ratio)
{
    constexpr double grouped = 999.5; // from here on the digits of whole numbers are in groups
    if (ratio < grouped)
        return localNumber(ratio, 'g', 3);
    const double unit = std::pow(10.0, std::floor(std::log10(ratio)) - 2);
    return formatCount(static_cast<std::size_t>(unit * std::round(ratio / unit)));
}

/// "2.5 times", "1/1,050 of it"; nothing where one of them means something else than a number.
QString ratioOf(double left, double right)
{
    constexpr double small = 0.1; // below, the inverse is easier to read
    if (left == right)
        return MaterialComparisonDialog::tr("same");
    if (left == 0 || right == 0)
        return {};
    const double ratio = right / left;
    return ratio < small ? MaterialComparisonDialog::tr("1/%1 of it").arg(digitsOf(1 / ratio))
                         : MaterialComparisonDialog::tr("%1 times").arg(digitsOf(ratio));
}

QTreeWidgetItem* rowOf(const QString& name, double left, double right, Quantity quantity, const char* zero = "")
{
    auto* row =
        new QTreeWidgetItem({name, textOf(left, quantity, zero), textOf(right, quantity, zero), ratioOf(left, right)});
    for (int column = 1; column < row->columnCount(); ++column)
        row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    if (left != right) {
        QFont font = row->font(1);
        font.setWeight(QFont::DemiBold);
        for (int column = 1; column < row->columnCount(); ++column)
            row->setFont(column, font);
    }
    return row;
}

} // namespace

MaterialComparisonDialog::MaterialComparisonDialog(std::vector<MaterialPreset> choices, std::size_t right,
                                                   QWidget* parent)
    : ModelessDialog(parent)
    , m_choices(std::move(choices))
    , m_left(makeChoice("comparedLeft", this))
    , m_right(makeChoice("comparedRight", this))
    , m_table(new QTreeWidget(this))
{
    setObjectName("materialComparison");
    setWindowTitle(tr("Compare materials"));
    resize(dialogSize);
    auto* row = new QHBoxLayout;
    for (QComboBox* choice : {m_left, m_right}) {
        choice->setIconSize({24, 24});
        choice->setMaxVisibleItems(20);
        for (const MaterialPreset& preset : m_choices)
            choice->addItem(materialSwatch(preset), materialName(preset));
        connect(choice, &QComboBox::currentIndexChanged, this, &MaterialComparisonDialog::showBoth);
        row->addWidget(choice, 1);
    }
    m_right->setCurrentIndex(static_cast<int>(right));
    m_table->setObjectName("comparedNumbers");
    m_table->setRootIsDecorated(false);
    m_table->setUniformRowHeights(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row);
    column->addWidget(m_table, 1);
    column->addWidget(buttons);
    showBoth();
}

void MaterialComparisonDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        showBoth();
    QDialog::changeEvent(event);
}

void MaterialComparisonDialog::showBoth()
{
    const MaterialPreset& left = m_choices[static_cast<std::size_t>(std::max(0, m_left->currentIndex()))];
    const MaterialPreset& right = m_choices[static_cast<std::size_t>(std::max(0, m_right->currentIndex()))];
    m_table->clear();
    m_table->setHeaderLabels({tr("Number"), materialName(left), materialName(right), tr("Right / left")});
    for (const MaterialField& field : materialFields())
        m_table->addTopLevelItem(rowOf(wordOfCore(field.name), left.material.*field.value, right.material.*field.value,
                                       quantityOfUnit(field.unit), field.zero));
    m_table->addTopLevelItem(
        rowOf(tr("Shear modulus"), left.material.shearModulus(), right.material.shearModulus(), Quantity::Pressure));
    m_table->addTopLevelItem(
        rowOf(tr("Speed of sound"), left.material.soundSpeed(), right.material.soundSpeed(), Quantity::Speed));
    for (int c = 0; c < m_table->columnCount(); ++c)
        m_table->resizeColumnToContents(c);
}

} // namespace knead
