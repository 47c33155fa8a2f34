#include "ui/panels/import_panel.h"

#include "core/message/message.h"
#include "core/model/length_units.h"
#include "ui/language/said.h"
#include "ui/panels/form.h"
#include "ui/units.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace knead {

namespace {

/// Where the surface of a part ends, or else the part.
ReportPlace openPlaceOf(const Model& model, std::size_t part)
{
    ReportPlace place;
    for (const std::vector<Vec3>& line : model.parts[part].openEdges)
        for (const Vec3& corner : line)
            place.box.extend(corner);
    return place.box.isEmpty() ? ReportPlace::ofPart(part) : place;
}

} // namespace

ImportPanel::ImportPanel(QWidget* parent)
    : QWidget(parent)
    , m_summary(new QLabel(this))
    , m_unit(makeChoice("takenUnit", this))
    , m_heal(new QPushButton(this))
    , m_fill(new QPushButton(tr("Close and fill"), this))
    , m_remarks(new QTextBrowser(this))
{
    setObjectName("importPanel");
    m_summary->setObjectName("importSummary");
    m_heal->setObjectName("takeUnhealed");
    m_fill->setObjectName("fillOpen");
    m_fill->setToolTip(
        tr("Opens the file again: flat openings get a plane face, other surfaces are filled where they wind around"));
    m_remarks->setObjectName("importRemarks");
    m_remarks->setAccessibleName(tr("Remarks"));
    m_remarks->setFrameShape(QFrame::NoFrame);
    m_remarks->setOpenLinks(false);
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
    connect(m_remarks, &QTextBrowser::anchorClicked, this,
            [this](const QUrl& link) { emit placeWanted(m_places.at(link.fragment().toULongLong())); });
    connect(m_heal, &QPushButton::clicked, this, [this] { emit healingChosen(!m_isHealed); });
}

void ImportPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_content)
        show(FilledModel(*m_content), m_isAsRead);
}

void ImportPanel::clear()
{
    m_content.reset();
    m_hasRemarks = false;
    m_summary->clear();
    m_remarks->clear();
    setEnabled(false);
}

void ImportPanel::show(const FilledModel& content, bool isAsRead)
{
    m_content = content;
    m_isAsRead = isAsRead;
    setEnabled(true);
    const Model& model = *content.model;
    const std::size_t parts = model.parts.size();
    m_summary->setText(tr("%1, %2, %3 filled")
                           .arg(model.format.empty() ? tr("several formats") : QString::fromStdString(model.format),
                                parts == 1 ? tr("1 part") : tr("%1 parts").arg(formatCount(parts)),
                                formatCount(content.bodies.size())));
    const QSignalBlocker blocker(m_unit);
    const std::string& chosen = content.request.options.unit;
    const std::string& unit = !chosen.empty() ? chosen : !model.unit.empty() ? model.unit : "mm";
    m_unit->setCurrentIndex(m_unit->findData(QString::fromStdString(unit)));
    m_isHealed = content.request.options.heal;
    const bool wasRepaired =
        std::any_of(model.parts.begin(), model.parts.end(), [](const Part& part) { return !part.repairs.empty(); });
    m_heal->setText(m_isHealed ? tr("Take without repairs") : tr("Repair"));
    m_heal->setVisible(isAsRead && (wasRepaired || !m_isHealed));
    const bool isOpen = std::any_of(content.surfaces.begin(), content.surfaces.end(), [&](const auto& surface) {
        return !model.parts[surface->body->part].canBeFilled();
    });
    m_fill->setVisible(isAsRead && isOpen && !content.request.fillsOpenParts);
    m_unit->setEnabled(isAsRead && content.request.paths.size() == 1); // other files have units of their own
    listRemarks(content);
}

void ImportPanel::listRemarks(const FilledModel& content)
{
    QString rows;
    m_places.clear();
    const auto add = [&](const QString& subject, const QString& sentence, const std::optional<ReportPlace>& place = {},
                         bool isRepair = false) {
        QString link;
        if (place) {
            link = QStringLiteral("<a href=\"#%1\">%2</a>").arg(m_places.size()).arg(PlaceRows::tr("Show me"));
            m_places.push_back(*place);
        }
        rows += QStringLiteral("<tr><td>%1&nbsp;</td><td><b>%2</b></td><td>%3 %4</td></tr>")
                    .arg(isRepair ? QString() : QStringLiteral("\u26a0"), subject.toHtmlEscaped(),
                         sentence.toHtmlEscaped(), link);
    };
    const Model& model = *content.model;
    if (model.unitRemark)
        add(tr("Size"), said(model.unitRemark->sentence));
    if (!content.fineness.warning.empty())
        add(tr("Filling"), said(content.fineness.warning));
    for (const Message& sentence : model.missing)
        add(tr("Missing"), said(sentence));
    for (const Message& sentence : model.warnings)
        add(tr("File"), said(sentence));
    for (const auto& [part, reason] : content.unfilled)
        add(QString::fromStdString(model.parts[part].path), tr("was not filled: %1").arg(said(reason)),
            openPlaceOf(model, part));
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        const Part& part = model.parts[p];
        for (const Message& sentence : part.warnings)
            add(QString::fromStdString(part.path), said(sentence), openPlaceOf(model, p));
        for (const Message& sentence : part.repairs)
            add(QString::fromStdString(part.path), tr("Repaired: %1").arg(said(sentence)), ReportPlace::ofPart(p),
                true);
    }
    m_hasRemarks = !rows.isEmpty();
    m_remarks->setHtml(m_hasRemarks ? "<table cellpadding=2>" + rows + "</table>"
                                    : tr("Nothing was wrong with this file."));
}

} // namespace knead
