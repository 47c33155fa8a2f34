#include "ui/dialogs/other_part_dialog.h"

#include "ui/dialogs/dialog_buttons.h"
#include "ui/panels/form.h"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

namespace knead {

namespace {

// As "knead apply" allows.
constexpr double leastScale = 1e-3;
constexpr double mostScale = 1e3;

enum Size { same, asBoxesSay, factor };

} // namespace

OtherPartDialog::OtherPartDialog(const QString& file, QWidget* parent)
    : QDialog(parent)
    , m_mirror(makeChoice("otherPartMirror", this))
    , m_size(makeChoice("otherPartSize", this))
    , m_factor(makeField(Quantity::Number, "otherPartFactor", this))
{
    setObjectName("otherPartOptions");
    setWindowTitle(tr("Apply to another part"));
    m_mirror->addItem(tr("No"));
    for (const QChar axis : QStringLiteral("xyz"))
        m_mirror->addItem(tr("Across %1").arg(axis));
    m_size->addItem(tr("The same"));
    m_size->addItem(tr("Another one, as its box says"));
    m_size->addItem(tr("So many times as large"));
    m_factor->setRange(leastScale, mostScale);
    m_factor->setValue(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    auto* words = new QLabel(tr("%1, as compared with the part that is open:").arg(file), this);
    words->setWordWrap(true);
    column->addWidget(words);
    QFormLayout* form = makeForm(nullptr);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Mirrored"), m_mirror);
    form->addRow(tr("Size"), m_size);
    form->addRow(tr("Times"), m_factor);
    column->addLayout(form);
    column->addStretch();
    column->addWidget(makeDialogButtons(*this, QDialogButtonBox::Ok, "otherPartFind", tr("Find the faces again")));
    connect(m_size, &QComboBox::currentIndexChanged, this, &OtherPartDialog::sizeChosen);
    sizeChosen();
    resize(400, sizeHint().height());
}

void OtherPartDialog::sizeChosen()
{
    m_factor->setEnabled(m_size->currentIndex() == factor);
}

TransferOptions OtherPartDialog::options() const
{
    TransferOptions options;
    if (const int axis = m_mirror->currentIndex() - 1; axis >= 0)
        options.mirror = Vec3::Unit(axis);
    if (m_size->currentIndex() == asBoxesSay)
        options.scale.reset();
    else if (m_size->currentIndex() == factor)
        options.scale = m_factor->value();
    return options;
}

} // namespace knead
