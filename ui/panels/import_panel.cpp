#include "ui/panels/import_panel.h"

#include "core/model/length_units.h"
#include "ui/panels/form.h"
#include "ui/theme.h"
#include "ui/units.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace knead {

namespace {

constexpr int nameColumn = 0;
constexpr int remarkColumn = 1;
constexpr int nameWidth = 220;

QString text(const std::string& sentence)
{
    return QString::fromStdString(sentence);
}

} // namespace

ImportPanel::ImportPanel(QWidget* parent)
    : QWidget(parent)
    , m_summary(new QLabel(this))
    , m_unit(makeChoice("takenUnit", this))
    , m_heal(new QPushButton(this))
    , m_fill(new QPushButton(tr("Try to fill open surfaces"), this))
    , m_remarks(new QTreeWidget(this))
{
    setObjectName("importPanel");
    m_summary->setObjectName("importSummary");
    m_heal->setObjectName("takeUnhealed");
    m_fill->setObjectName("fillOpen");
    m_fill->setToolTip(tr("Fills where the surface winds around; what is open too wide stays a surface"));
    m_remarks->setObjectName("importRemarks");
    m_remarks->setColumnCount(2);
    m_remarks->setHeaderLabels({tr("Part"), tr("What was found and done")});
    m_remarks->setRootIsDecorated(false);
    m_remarks->setWordWrap(true);
    m_remarks->setSelectionMode(QAbstractItemView::NoSelection);
    m_remarks->setFocusPolicy(Qt::NoFocus);
    m_remarks->header()->setStretchLastSection(true);
    m_remarks->setColumnWidth(nameColumn, nameWidth);
    for (const LengthUnit& unit : lengthUnits())
        m_unit->addItem(tr(unit.name), QString(unit.name));
    m_unit->setToolTip(
        tr("The unit that the numbers in the file are taken in. Another one opens the part anew in it."));

    auto* row = new QHBoxLayout;
    row->addWidget(m_summary, 1);
    row->addWidget(new QLabel(tr("Lengths in"), this));
    row->addWidget(m_unit);
    row->addWidget(m_heal);
    row->addWidget(m_fill);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 6, 8, 6);
    column->addLayout(row);
    column->addWidget(m_remarks, 1);
    setEnabled(false);

    connect(m_unit, &QComboBox::activated, this,
            [this](int index) { emit unitChosen(m_unit->itemData(index).toString()); });
    connect(m_fill, &QPushButton::clicked, this, &ImportPanel::fillingChosen);
    connect(m_heal, &QPushButton::clicked, this, [this] { emit healingChosen(!m_isHealed); });
}

void ImportPanel::show(const Content& content)
{
    setEnabled(true);
    const Model& model = *content.model;
    const std::size_t parts = model.parts.size();
    m_summary->setText(tr("%1, %2, %3 filled")
                           .arg(model.format.empty() ? tr("several formats") : text(model.format),
                                parts == 1 ? tr("1 part") : tr("%1 parts").arg(formatCount(parts)),
                                formatCount(content.bodies.size())));
    const QSignalBlocker blocker(m_unit);
    const std::string& chosen = content.request.options.unit;
    const std::string& unit = !chosen.empty() ? chosen : !model.unit.empty() ? model.unit : "mm";
    m_unit->setCurrentIndex(m_unit->findData(text(unit)));
    m_isHealed = content.request.options.heal;
    const bool wasRepaired =
        std::any_of(model.parts.begin(), model.parts.end(), [](const Part& part) { return !part.repairs.empty(); });
    m_heal->setText(m_isHealed ? tr("Take without repairs") : tr("Repair"));
    m_heal->setVisible(wasRepaired || !m_isHealed);
    m_fill->setVisible(!content.surfaces.empty() && !content.request.fillsOpenParts);
    listRemarks(content);
}

void ImportPanel::listRemarks(const Content& content)
{
    m_remarks->clear();
    const auto add = [this](const QString& name, const QString& remark, const char* sign) {
        auto* item = new QTreeWidgetItem(m_remarks, {name, remark});
        item->setIcon(remarkColumn, icon(sign));
        item->setToolTip(remarkColumn, remark);
        item->setToolTip(nameColumn, name);
    };
    const Model& model = *content.model;
    if (model.unitRemark)
        add(tr("Size"), text(model.unitRemark->sentence), "warning");
    if (!content.fineness.warning.empty())
        add(tr("Filling"), text(content.fineness.warning), "warning");
    for (const std::string& sentence : model.missing)
        add(tr("Missing"), text(sentence), "warning");
    for (const std::string& sentence : model.warnings)
        add(tr("File"), text(sentence), "warning");
    for (const Part& part : model.parts) {
        for (const std::string& sentence : part.warnings)
            add(text(part.path), text(sentence), "warning");
        for (const std::string& sentence : part.repairs)
            add(text(part.path), text(sentence), "repair");
    }
    if (m_remarks->topLevelItemCount() == 0)
        add(tr("All"), tr("Nothing was wrong with this file."), "part");
}

bool ImportPanel::hasRemarks() const
{
    return m_remarks->topLevelItemCount() > 1 ||
           (m_remarks->topLevelItemCount() == 1 && m_remarks->topLevelItem(0)->text(nameColumn) != tr("All"));
}

} // namespace knead
