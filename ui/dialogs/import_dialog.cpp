#include "ui/dialogs/import_dialog.h"

#include "core/model/length_units.h"
#include "ui/dialogs/dialog_buttons.h"
#include "ui/panels/form.h"
#include "ui/theme.h"
#include "ui/units.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSettings>
#include <QSpinBox>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <numeric>

namespace knead {

namespace {

constexpr int pathRole = Qt::UserRole; ///< path of the part; set for every item of the tree

struct Detail {
    const char* name;
    double relativeDeflection;
    double angle; ///< [rad]
};

constexpr std::array details{
    Detail{QT_TRANSLATE_NOOP("ImportDialog", "Coarse (0.2 % of the size)"), 1.0 / 500, 0.5},
    Detail{QT_TRANSLATE_NOOP("ImportDialog", "Normal (0.05 % of the size)"), 1.0 / 2000, 0.2},
    Detail{QT_TRANSLATE_NOOP("ImportDialog", "Fine (0.0125 % of the size)"), 1.0 / 8000, 0.1},
};
constexpr int normalDetail = 1;

QString fileName(const FilePreview& preview)
{
    return QFileInfo(QFile::decodeName(preview.file.c_str())).fileName();
}

/// "STEP AP214, 12.2 MB, 20 parts, 5,318 faces"
QString factsOf(const FilePreview& preview)
{
    QStringList facts{QString::fromStdString(preview.format),
                      QLocale::c().formattedDataSize(static_cast<qint64>(preview.size), 1)};
    if (preview.parts > 0)
        facts << (preview.parts == 1 ? ImportDialog::tr("1 part")
                                     : ImportDialog::tr("%1 parts").arg(formatCount(preview.parts)));
    if (preview.solids > 0)
        facts << (preview.solids == 1 ? ImportDialog::tr("1 solid")
                                      : ImportDialog::tr("%1 solids").arg(formatCount(preview.solids)));
    if (preview.faces > 0)
        facts << ImportDialog::tr("%1 faces").arg(formatCount(preview.faces));
    return facts.join(", ");
}

/// The state of an item follows from those below it.
void updateParents(QTreeWidgetItem* item)
{
    for (QTreeWidgetItem* parent = item->parent(); parent != nullptr; parent = parent->parent()) {
        int checked = 0;
        int unchecked = 0;
        for (int i = 0; i < parent->childCount(); ++i) {
            const Qt::CheckState state = parent->child(i)->checkState(0);
            checked += state == Qt::Checked ? 1 : 0;
            unchecked += state == Qt::Unchecked ? 1 : 0;
        }
        parent->setCheckState(0, checked == parent->childCount()     ? Qt::Checked
                                 : unchecked == parent->childCount() ? Qt::Unchecked
                                                                     : Qt::PartiallyChecked);
    }
}

void checkBelow(QTreeWidgetItem* item, Qt::CheckState state)
{
    item->setCheckState(0, state);
    for (int i = 0; i < item->childCount(); ++i)
        checkBelow(item->child(i), state);
}

std::size_t countLeaves(const QTreeWidgetItem* item, bool onlyChecked)
{
    if (item->childCount() == 0)
        return !onlyChecked || item->checkState(0) == Qt::Checked ? 1 : 0;
    std::size_t leaves = 0;
    for (int i = 0; i < item->childCount(); ++i)
        leaves += countLeaves(item->child(i), onlyChecked);
    return leaves;
}

} // namespace

ImportDialog::ImportDialog(std::vector<FilePreview> previews, QWidget* parent)
    : QDialog(parent)
    , m_previews(std::move(previews))
{
    setObjectName("importDialog");
    setWindowTitle(m_previews.size() == 1 ? tr("Open %1").arg(fileName(m_previews.front()))
                                          : tr("Open %1 files").arg(m_previews.size()));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    column->addWidget(makeFacts());
    m_buttons = makeDialogButtons(*this, QDialogButtonBox::Open, "importOpen");
    const auto leaves = std::accumulate(m_previews.begin(), m_previews.end(), std::size_t{0},
                                        [](std::size_t sum, const FilePreview& p) { return sum + p.parts; });
    if (m_previews.size() == 1 && leaves > 1)
        column->addWidget(makeParts(), 1);
    column->addWidget(makeChoices());
    column->addWidget(m_buttons);
    resize(520, m_parts != nullptr ? 660 : sizeHint().height());
    if (m_parts != nullptr)
        showChosen();
}

QWidget* ImportDialog::makeFacts()
{
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    for (const FilePreview& preview : m_previews) {
        QLabel* name = makeHeading(fileName(preview), box);
        name->setWordWrap(true);
        column->addWidget(name);
        auto* facts = new QLabel(factsOf(preview), box);
        facts->setObjectName("importFacts");
        facts->setProperty("role", "dimmed");
        column->addWidget(facts);
    }
    return box;
}

QWidget* ImportDialog::makeParts()
{
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout;
    m_chosen = new QLabel(box);
    m_chosen->setObjectName("importChosen");
    row->addWidget(m_chosen, 1);
    for (const bool all : {true, false}) {
        auto* button = new QToolButton(box);
        button->setObjectName(all ? "importAll" : "importNone");
        button->setText(all ? tr("All") : tr("None"));
        button->setAutoRaise(true);
        connect(button, &QToolButton::clicked, this, [this, all] { checkAll(all); });
        row->addWidget(button);
    }
    column->addLayout(row);
    m_parts = new QTreeWidget(box);
    m_parts->setObjectName("importParts");
    m_parts->setHeaderHidden(true);
    m_parts->setUniformRowHeights(true);
    m_parts->setIndentation(16);
    for (const PartNode& child : m_previews.front().tree.children)
        addNodes(child, {}, m_parts->invisibleRootItem());
    m_parts->expandToDepth(2);
    connect(m_parts, &QTreeWidget::itemChanged, this, &ImportDialog::itemChanged);
    column->addWidget(m_parts, 1);
    return box;
}

void ImportDialog::addNodes(const PartNode& node, const QString& path, QTreeWidgetItem* parent)
{
    const QString name = QString::fromStdString(node.name);
    const QString own = path.isEmpty() ? name : path + '/' + name;
    auto* item = new QTreeWidgetItem(parent, {name});
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setIcon(0, icon(node.children.empty() ? "part" : "assembly"));
    item->setCheckState(0, Qt::Checked);
    item->setData(0, pathRole, own);
    for (const PartNode& child : node.children)
        addNodes(child, own, item);
}

QWidget* ImportDialog::makeChoices()
{
    auto* box = new QWidget(this);
    QFormLayout* form = makeForm(box);
    form->setContentsMargins(0, 0, 0, 0);
    m_detail = makeChoice("importDetail", box);
    for (const Detail& detail : details)
        m_detail->addItem(tr(detail.name));
    m_detail->setCurrentIndex(normalDetail);
    m_detail->setToolTip(tr("How far the triangles that are drawn and filled may lie beside the surfaces of the file"));
    form->addRow(tr("Triangles"), m_detail);

    m_unit = makeChoice("importUnit", box);
    m_unit->addItem(tr("As the file says"), QString());
    for (const LengthUnit& unit : lengthUnits())
        m_unit->addItem(tr(unit.name), QString(unit.name));
    m_unit->setToolTip(tr("The unit that the numbers in the file are taken in"));
    form->addRow(tr("Lengths"), m_unit);

    addFineness(form);

    m_touching = makeChoice("importTouching", box);
    m_touching->addItems({tr("Stay separate"), tr("Are glued together")}); // in the order of Touching
    m_touching->setToolTip(tr("What solids do that touch each other at rest"));
    form->addRow(tr("Touching solids"), m_touching);

    m_heal = new QCheckBox(tr("Repair shapes: sew surfaces, close gaps"), box);
    m_heal->setObjectName("importHeal");
    m_heal->setChecked(true);
    form->addRow(QString(), m_heal);
    m_fillsOpen = new QCheckBox(tr("Close flat openings, fill in spite of small holes"), box);
    m_fillsOpen->setObjectName("importFillsOpen");
    m_fillsOpen->setToolTip(
        tr("Flat openings of any size get a plane face; other surfaces are filled where they wind around. What is open "
           "too wide is only shown."));
    form->addRow(QString(), m_fillsOpen);
    addLimits(form);
    return box;
}

/// How long and with how much memory the reader may work before it is given up; remembered.
void ImportDialog::addLimits(QFormLayout* form)
{
    auto* row = new QHBoxLayout;
    const auto add = [&](const char* name, const char* key, const QString& automatic, const QString& suffix,
                         const QString& tip, int most) {
        auto* box = new QSpinBox(this);
        box->setObjectName(name);
        box->setRange(0, most);
        box->setSpecialValueText(automatic);
        box->setSuffix(suffix);
        box->setToolTip(tip);
        box->setValue(QSettings().value(key, 0).toInt());
        connect(this, &QDialog::accepted, box, [box, key] { QSettings().setValue(key, box->value()); });
        row->addWidget(box);
        return box;
    };
    m_minutes = add("importMinutes", "import/minutes", tr("Time: automatic"), tr(" min"),
                    tr("Reading is given up after this processor time; automatic: by the size of the file"), 10'000);
    m_gibibytes = add("importMemory", "import/gibibytes", tr("Memory: automatic"), tr(" GiB"),
                      tr("Reading is given up when it wants more memory; automatic: by the size of the file"), 1'000);
    form->addRow(tr("Reading may take"), row);
}

/// How finely to fill, in the order of the pages: automatic, objects, cells across the wall, spacing.
void ImportDialog::addFineness(QFormLayout* form)
{
    m_fineness = makeChoice("importFineness", this);
    m_fineness->addItems({tr("For real time"), tr("About so many objects"), tr("Cells across the thinnest wall"),
                          tr("Spacing of the objects")});
    m_fineness->setToolTip(tr("How finely to fill with objects; finer is slower"));
    m_values = new QStackedWidget(this);
    m_values->addWidget(new QWidget(m_values));
    m_objects = new QSpinBox(m_values);
    m_objects->setObjectName("importObjects");
    m_objects->setRange(100, 10'000'000);
    m_objects->setSingleStep(1000);
    m_objects->setGroupSeparatorShown(true);
    m_objects->setValue(10'000);
    m_values->addWidget(m_objects);
    m_cells = new QSpinBox(m_values);
    m_cells->setObjectName("importCells");
    m_cells->setRange(1, 50);
    m_cells->setValue(static_cast<int>(goodCellsAcrossWall));
    m_values->addWidget(m_cells);
    m_spacing = makeField(Quantity::Length, "importSpacing", m_values);
    m_spacing->setValue(1e-3);
    m_values->addWidget(m_spacing);
    connect(m_fineness, &QComboBox::currentIndexChanged, m_values, &QStackedWidget::setCurrentIndex);
    auto* row = new QHBoxLayout;
    row->addWidget(m_fineness, 2);
    row->addWidget(m_values, 1);
    form->addRow(tr("Filling"), row);
}

void ImportDialog::itemChanged(QTreeWidgetItem* item)
{
    if (m_isUpdating)
        return;
    const QScopedValueRollback updating(m_isUpdating, true);
    checkBelow(item, item->checkState(0) == Qt::Unchecked ? Qt::Unchecked : Qt::Checked);
    updateParents(item);
    showChosen();
}

void ImportDialog::checkAll(bool checked)
{
    const QScopedValueRollback updating(m_isUpdating, true);
    for (int i = 0; i < m_parts->topLevelItemCount(); ++i)
        checkBelow(m_parts->topLevelItem(i), checked ? Qt::Checked : Qt::Unchecked);
    showChosen();
}

void ImportDialog::showChosen()
{
    const std::size_t chosen = countLeaves(m_parts->invisibleRootItem(), true);
    const std::size_t all = countLeaves(m_parts->invisibleRootItem(), false);
    m_chosen->setText(chosen == all ? tr("All %1 parts").arg(formatCount(all))
                                    : tr("%1 of %2 parts").arg(formatCount(chosen), formatCount(all)));
    m_buttons->button(QDialogButtonBox::Open)->setEnabled(chosen > 0);
}

/// The highest items that are wanted whole.
void ImportDialog::addChosen(const QTreeWidgetItem* item, std::vector<std::string>& paths) const
{
    for (int i = 0; i < item->childCount(); ++i) {
        const QTreeWidgetItem* child = item->child(i);
        if (child->checkState(0) == Qt::Checked)
            paths.push_back(child->data(0, pathRole).toString().toStdString());
        else if (child->checkState(0) == Qt::PartiallyChecked)
            addChosen(child, paths);
    }
}

ImportChoices ImportDialog::request() const
{
    ImportChoices request;
    for (const FilePreview& preview : m_previews)
        request.paths.push_back(preview.file);
    const Detail& detail = details[static_cast<std::size_t>(m_detail->currentIndex())];
    request.options.relativeDeflection = detail.relativeDeflection;
    request.options.angularDeflection = detail.angle;
    request.options.unit = m_unit->currentData().toString().toStdString();
    request.options.timeLimit = 60.0 * m_minutes->value();
    request.options.memoryLimit = static_cast<double>(1U << 30U) * m_gibibytes->value();
    request.options.heal = m_heal->isChecked();
    request.touching = static_cast<Touching>(m_touching->currentIndex());
    request.fillsOpenParts = m_fillsOpen->isChecked();
    request.options.capsFlatOpenings = m_fillsOpen->isChecked();
    if (m_values->currentWidget() == m_objects)
        request.spacing = {SpacingChoice::Kind::Objects, static_cast<double>(m_objects->value())};
    else if (m_values->currentWidget() == m_cells)
        request.spacing = {SpacingChoice::Kind::CellsAcrossWall, static_cast<double>(m_cells->value())};
    else if (m_values->currentWidget() == m_spacing)
        request.spacing = {SpacingChoice::Kind::Length, m_spacing->value()};
    if (m_parts != nullptr &&
        countLeaves(m_parts->invisibleRootItem(), true) != countLeaves(m_parts->invisibleRootItem(), false))
        addChosen(m_parts->invisibleRootItem(), request.options.parts);
    return request;
}

} // namespace knead
