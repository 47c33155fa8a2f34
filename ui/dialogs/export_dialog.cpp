#include "ui/dialogs/export_dialog.h"

#include "core/model/length_units.h"
#include "ui/dialogs/dialog_buttons.h"
#include "ui/panels/form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSettings>
#include <QVBoxLayout>

namespace knead {

namespace {

constexpr int partsRole = Qt::UserRole;
constexpr int exportDialogWidth = 520; // [pixels]

QString aboutFormat(const FileFormat& format)
{
    if (format.isSmooth)
        return ExportDialog::tr("Smooth trimmed faces, one for each face of the part as it was opened, at the places "
                                "where the material has them now. The file is read back and compared.");
    return ExportDialog::tr("Triangles, as fine as the surface that is drawn.");
}

/// Whether a person can choose between text and binary.
bool hasText(const FileFormat& format)
{
    return format.text == FileFormat::Text::asAsked;
}

/// As high as it has lines at its width: a form leaves a label that breaks its words the room of a narrow one.
class Paragraph final : public QLabel {
public:
    using QLabel::QLabel;
    QSize sizeHint() const override { return {QLabel::sizeHint().width(), 1}; }
    QSize minimumSizeHint() const override { return {1, 1}; }
};

} // namespace

ExportDialog::ExportDialog(const QString& selected, bool hidden, QWidget* parent)
    : QDialog(parent)
{
    setObjectName("exportDialog");
    setWindowTitle(tr("Export the deformed parts"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    QFormLayout* form = makeForm(nullptr);
    form->setContentsMargins(0, 0, 0, 0);
    column->addLayout(form);

    m_format = makeChoice("exportFormat", this);
    for (const FileFormat& format : fileFormats)
        m_format->addItem(
            tr("%1 (.%2)").arg(QString::fromStdString(format.name), QString::fromStdString(format.endings.front())));
    form->addRow(tr("Format"), m_format);
    m_about = new Paragraph(this);
    m_about->setObjectName("exportAbout");
    m_about->setProperty("role", "dimmed");
    m_about->setWordWrap(true);
    form->addRow(QString(), m_about);

    m_parts = makeChoice("exportParts", this);
    m_parts->addItem(tr("All parts"), static_cast<int>(ExportRequest::Which::all));
    if (hidden)
        m_parts->addItem(tr("Visible parts"), static_cast<int>(ExportRequest::Which::visible));
    if (!selected.isEmpty())
        m_parts->addItem(tr("Only \"%1\"").arg(selected), static_cast<int>(ExportRequest::Which::selected));
    form->addRow(tr("Parts"), m_parts);

    m_unit = makeChoice("exportUnit", this);
    m_unit->addItem(tr("As in the file that was opened"), QString());
    for (const char* unit : exportUnits)
        m_unit->addItem(tr(unit), QString(unit));
    form->addRow(tr("Lengths"), m_unit);

    m_tolerance = makeField(Quantity::Length, "exportTolerance", this);
    m_tolerance->setRange(0, 1);
    m_tolerance->setZeroText(tr("Automatic: 0.01 % of the size"));
    m_tolerance->setToolTip(tr("How far faces in the file may lie beside the surface of the material. A larger one "
                               "gives smaller files."));
    form->addRow(tr("Tolerance"), m_tolerance);

    m_ap214 = new QCheckBox(tr("For older programs: AP214 instead of AP242"), this);
    m_ap214->setObjectName("exportAp214");
    form->addRow(QString(), m_ap214);
    m_text = new QCheckBox(tr("As text, which is larger and can be read"), this);
    m_text->setObjectName("exportText");
    form->addRow(QString(), m_text);
    m_onePerPart = new QCheckBox(tr("A file for each part"), this);
    m_onePerPart->setObjectName("exportOnePerPart");
    form->addRow(QString(), m_onePerPart);
    m_report = new QCheckBox(tr("Keep the report as a JSON file beside it"), this);
    m_report->setObjectName("exportKeepReport");
    form->addRow(QString(), m_report);

    column->addStretch();
    column->addWidget(makeDialogButtons(*this, QDialogButtonBox::Save, "exportSave", tr("Choose a place...")));

    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::formatChanged);
    m_format->setCurrentIndex(std::max(0, m_format->findText(QSettings().value("export/format").toString())));
    connect(this, &QDialog::accepted, this, [this] { QSettings().setValue("export/format", m_format->currentText()); });
    resize(exportDialogWidth, 1);
    formatChanged();
}

const FileFormat& ExportDialog::format() const
{
    return fileFormats[static_cast<std::size_t>(m_format->currentIndex())];
}

void ExportDialog::formatChanged()
{
    m_about->setText(aboutFormat(format()));
    m_tolerance->setEnabled(format().isSmooth);
    m_unit->setEnabled(!format().isInMetres);
    m_ap214->setVisible(format().takesAp214);
    m_text->setVisible(hasText(format()));
    layout()->activate();
    resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
}

ExportRequest ExportDialog::request() const
{
    ExportRequest request;
    request.which = static_cast<ExportRequest::Which>(m_parts->currentData(partsRole).toInt());
    request.options.unit = m_unit->currentData().toString().toStdString();
    request.options.tolerance = m_tolerance->value();
    request.options.useAp214 = m_ap214->isChecked() && format().takesAp214;
    request.options.isText = m_text->isChecked() && hasText(format());
    request.onePerPart = m_onePerPart->isChecked();
    request.keepsReport = m_report->isChecked();
    return request;
}

} // namespace knead
