#include "ui/dialogs/record_dialog.h"

#include "ui/dialogs/dialog_buttons.h"
#include "ui/document/entry_names.h"
#include "ui/panels/form.h"
#include "ui/theme.h"
#include "ui/units.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSettings>
#include <QVBoxLayout>

namespace knead {

namespace {

QString sizeText(const QSize& size)
{
    return QStringLiteral("%1 × %2").arg(size.width()).arg(size.height());
}

/// Videos have even sizes.
QSize even(const QSize& size)
{
    return {size.width() - size.width() % 2, size.height() - size.height() % 2};
}

} // namespace

RecordDialog::RecordDialog(Recording::Kind kind, double end, const ShownView& view, QWidget* parent)
    : QDialog(parent)
    , m_kind(kind)
{
    setObjectName("recordDialog");
    setWindowTitle(kind == Recording::Kind::video ? tr("Record a video") : tr("Record pictures"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    makeFields(end);
    makeSizes(even(view.size));
    QFormLayout* form = makeForm(nullptr);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("From"), m_from);
    form->addRow(tr("To"), m_to);
    form->addRow(tr("Speed"), m_speed);
    form->addRow(tr("Pictures per second"), m_rate);
    form->addRow(tr("Size"), m_size);
    if (!view.name.isEmpty()) {
        auto* of = new QLabel(tr("What the active view shows: %1").arg(view.name), this);
        of->setObjectName("recordView");
        setRole(*of, "dimmed");
        form->addRow(QString(), of);
    }
    form->addRow(QString(), m_readings);
    form->addRow(QString(), m_extent);
    column->addLayout(form);
    column->addStretch();
    column->addWidget(makeDialogButtons(*this, QDialogButtonBox::Save, "recordSave", tr("Choose a place...")));
    connect(this, &QDialog::accepted, this, &RecordDialog::remember);
    restore();
    showExtent();
    resize(460, sizeHint().height());
}

void RecordDialog::makeFields(double end)
{
    m_from = makeField(Quantity::Time, "recordFrom", this);
    m_to = makeField(Quantity::Time, "recordTo", this);
    for (QuantityField* field : {m_from, m_to}) {
        field->setRange(0, end);
        connect(field, &QuantityField::committed, this, &RecordDialog::showExtent);
    }
    m_from->setValue(0);
    m_to->setValue(end);
    m_speed = makeChoice("recordSpeed", this);
    for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0})
        m_speed->addItem(speed == 1 ? tr("As simulated") : tr("%1 times").arg(localNumber(speed, 'g', 6)), speed);
    m_rate = makeChoice("recordRate", this);
    for (const int rate : {24, 25, 30, 50, 60})
        m_rate->addItem(QString::number(rate), rate);
    m_readings = new QCheckBox(tr("With the time, and forces on tools"), this);
    m_readings->setObjectName("recordReadings");
    m_extent = new QLabel(this);
    m_extent->setObjectName("recordExtent");
    m_extent->setProperty("role", "dimmed");
    m_extent->setWordWrap(true);
    for (QComboBox* choice : {m_speed, m_rate})
        connect(choice, &QComboBox::currentIndexChanged, this, &RecordDialog::showExtent);
}

void RecordDialog::makeSizes(const QSize& viewSize)
{
    m_size = makeChoice("recordSize", this);
    m_size->addItem(tr("%1, as the view").arg(sizeText(viewSize)), viewSize);
    for (const QSize& size : {QSize(1280, 720), QSize(1920, 1080), QSize(3840, 2160)})
        m_size->addItem(sizeText(size), size);
    connect(m_size, &QComboBox::currentIndexChanged, this, &RecordDialog::showExtent);
}

void RecordDialog::restore()
{
    const QSettings settings;
    const auto choose = [](QComboBox* choice, const QVariant& wanted) {
        choice->setCurrentIndex(std::max(0, choice->findData(wanted)));
    };
    choose(m_speed, settings.value("record/speed", 1.0).toDouble());
    choose(m_rate, settings.value("record/rate", 30).toInt());
    choose(m_size, settings.value("record/size", QSize(1920, 1080)).toSize());
    m_readings->setChecked(settings.value("record/readings", true).toBool());
}

void RecordDialog::remember() const
{
    QSettings settings;
    const Recording now = recording();
    settings.setValue("record/speed", now.speed);
    settings.setValue("record/rate", now.rate);
    settings.setValue("record/size", now.size);
    settings.setValue("record/readings", now.hasReadings);
}

Recording RecordDialog::recording() const
{
    Recording recording;
    recording.kind = m_kind;
    recording.from = std::min(m_from->value(), m_to->value());
    recording.to = std::max(m_from->value(), m_to->value());
    recording.speed = m_speed->currentData().toDouble();
    recording.rate = m_rate->currentData().toInt();
    recording.size = m_size->currentData().toSize();
    recording.hasReadings = m_readings->isChecked();
    return recording;
}

void RecordDialog::showExtent()
{
    const Recording now = recording();
    const std::size_t count = now.pictures();
    const QString pictures = count == 1 ? tr("1 picture") : tr("%1 pictures").arg(formatCount(count));
    const double shown = static_cast<double>(count) / now.rate;
    m_extent->setText(m_kind == Recording::Kind::video
                          ? tr("%1: a video of %2 (Ogg Theora)").arg(pictures, timeText(shown))
                          : tr("%1: PNG files in a folder of their own").arg(pictures));
}

} // namespace knead
