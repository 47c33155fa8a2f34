#include "ui/dialogs/picture_dialog.h"

#include "ui/dialogs/dialog_buttons.h"
#include "ui/panels/form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSettings>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace knead {

namespace {

constexpr int smallestSide = 16; // [pixels]

QString pixelsText(const QSize& size)
{
    return QStringLiteral("%1 × %2").arg(size.width()).arg(size.height());
}

} // namespace

PictureDialog::PictureDialog(const QSize& viewSize, QWidget* parent)
    : QDialog(parent)
    , m_viewSize(
          viewSize.expandedTo({smallestSide, smallestSide}).boundedTo({Picture::largestSide, Picture::largestSide}))
{
    setObjectName("pictureDialog");
    setWindowTitle(tr("Save a picture"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    QFormLayout* form = makeForm(nullptr);
    form->setContentsMargins(0, 0, 0, 0);
    QWidget* numbers = makeSizes(m_viewSize);
    m_kind = makeChoice("pictureKind", this);
    m_kind->addItem(tr("PNG, exact"), static_cast<int>(Picture::Kind::png));
    m_kind->addItem(tr("JPEG, small"), static_cast<int>(Picture::Kind::jpeg));
    m_clear = makeBox("pictureClear", tr("Transparent background"));
    m_ground = makeBox("pictureGround", tr("With grid and shadow"));
    m_cube = makeBox("pictureCube", tr("With the view cube"));
    form->addRow(tr("Size"), m_size);
    form->addRow(QString(), numbers);
    form->addRow(tr("Format"), m_kind);
    for (QCheckBox* box : {m_clear, m_ground, m_cube})
        form->addRow(QString(), box);
    column->addLayout(form);
    column->addStretch();
    column->addWidget(makeDialogButtons(*this, QDialogButtonBox::Save, "pictureSave", tr("Choose a place...")));
    connect(m_size, &QComboBox::currentIndexChanged, this, &PictureDialog::sizeChosen);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &PictureDialog::kindChosen);
    connect(this, &QDialog::accepted, this, &PictureDialog::remember);
    restore();
    resize(380, sizeHint().height());
}

QCheckBox* PictureDialog::makeBox(const char* name, const QString& text)
{
    auto* box = new QCheckBox(text, this);
    box->setObjectName(name);
    return box;
}

/// @return the numbers of a size of one's own
QWidget* PictureDialog::makeSizes(const QSize& viewSize)
{
    m_size = makeChoice("pictureSize", this);
    m_size->addItem(tr("%1, as the view").arg(pixelsText(viewSize)), viewSize);
    for (const QSize& size : {QSize(1920, 1080), QSize(3840, 2160)})
        m_size->addItem(pixelsText(size), size);
    m_size->addItem(tr("Other"), QSize());
    auto* numbers = new QWidget(this);
    auto* row = new QHBoxLayout(numbers);
    row->setContentsMargins(0, 0, 0, 0);
    const auto makeNumber = [&](const char* name, const QString& title) {
        auto* number = new QSpinBox(numbers);
        number->setObjectName(name);
        number->setAccessibleName(title);
        number->setRange(smallestSide, Picture::largestSide);
        return number;
    };
    m_width = makeNumber("pictureWidth", tr("Width"));
    m_height = makeNumber("pictureHeight", tr("Height"));
    row->addWidget(m_width, 1);
    row->addWidget(new QLabel(QStringLiteral("×"), numbers));
    row->addWidget(m_height, 1);
    return numbers;
}

/// The numbers show the chosen size, and can be typed where it is another one.
void PictureDialog::sizeChosen()
{
    const QSize size = m_size->currentData().toSize();
    for (QSpinBox* number : {m_width, m_height})
        number->setEnabled(!size.isValid());
    if (!size.isValid())
        return;
    m_width->setValue(size.width());
    m_height->setValue(size.height());
}

void PictureDialog::kindChosen()
{
    const bool isPng = picture().kind == Picture::Kind::png;
    m_clear->setEnabled(isPng);
    m_clear->setToolTip(isPng ? QString() : tr("Only PNG files can have a transparent background."));
}

void PictureDialog::restore()
{
    const QSettings settings;
    const QString size = settings.value("picture/size", "view").toString();
    const QSize own = settings.value("picture/ownSize", QSize(2560, 1440)).toSize();
    const int fixed = m_size->findText(size);
    const int other = m_size->count() - 1;
    m_size->setCurrentIndex(size == "own" ? other : std::max(0, fixed));
    sizeChosen();
    if (m_size->currentIndex() == other) {
        m_width->setValue(own.width());
        m_height->setValue(own.height());
    }
    m_kind->setCurrentIndex(settings.value("picture/isJpeg", false).toBool() ? 1 : 0);
    m_clear->setChecked(settings.value("picture/clear", false).toBool());
    m_ground->setChecked(settings.value("picture/ground", true).toBool());
    m_cube->setChecked(settings.value("picture/cube", false).toBool());
    kindChosen();
}

void PictureDialog::remember() const
{
    QSettings settings;
    const bool isOwn = m_size->currentIndex() == m_size->count() - 1;
    const QString fixed = m_size->currentIndex() == 0 ? QStringLiteral("view") : m_size->currentText();
    settings.setValue("picture/size", isOwn ? QStringLiteral("own") : fixed);
    if (isOwn)
        settings.setValue("picture/ownSize", QSize(m_width->value(), m_height->value()));
    settings.setValue("picture/isJpeg", picture().kind == Picture::Kind::jpeg);
    settings.setValue("picture/clear", m_clear->isChecked());
    settings.setValue("picture/ground", m_ground->isChecked());
    settings.setValue("picture/cube", m_cube->isChecked());
}

Picture PictureDialog::picture() const
{
    Picture picture;
    picture.kind = static_cast<Picture::Kind>(m_kind->currentData().toInt());
    picture.size = QSize(m_width->value(), m_height->value());
    picture.isClear = m_clear->isChecked() && picture.kind == Picture::Kind::png;
    picture.hasGround = m_ground->isChecked();
    picture.hasCube = m_cube->isChecked();
    return picture;
}

} // namespace knead
