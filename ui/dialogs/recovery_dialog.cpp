#include "ui/dialogs/recovery_dialog.h"

#include "ui/language/said.h"
#include "ui/theme.h"
#include "ui/units.h"

#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace knead {

namespace {

/// "today, 14:03"
QString timeWords(double time)
{
    if (time <= 0)
        return RecoveryDialog::tr("nobody knows when");
    const QDateTime moment = QDateTime::fromSecsSinceEpoch(static_cast<qint64>(time));
    const QString clock = moment.time().toString("HH:mm");
    const qint64 days = moment.date().daysTo(QDate::currentDate());
    if (days == 0)
        return RecoveryDialog::tr("today, %1").arg(clock);
    if (days == 1)
        return RecoveryDialog::tr("yesterday, %1").arg(clock);
    return QStringLiteral("%1, %2").arg(QLocale().toString(moment.date(), QLocale::ShortFormat), clock);
}

/// What was done after the part was opened.
QString amountWords(std::uint32_t entries)
{
    if (entries == 0)
        return RecoveryDialog::tr("damaged");
    if (entries == 1)
        return RecoveryDialog::tr("just begun");
    return entries == 2 ? RecoveryDialog::tr("1 change") : RecoveryDialog::tr("%1 changes").arg(entries - 1);
}

} // namespace

QString RecoveryDialog::nameOf(const Recovery& recovery)
{
    if (!recovery.projectFile.empty())
        return QFileInfo(QFile::decodeName(recovery.projectFile.c_str())).fileName();
    return recovery.part.empty() ? tr("Work without a name")
                                 : said(Message("RecoveryDialog", "%1, never saved").with(recovery.part));
}

RecoveryDialog::RecoveryDialog(std::vector<Recovery> found, QWidget* parent)
    : QDialog(parent)
    , m_found(std::move(found))
{
    setObjectName("recoveryDialog");
    setWindowTitle(tr("Recover unsaved work"));
    setMinimumWidth(480);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(10);
    auto* heading = new QLabel(tr("Knead ended before this was saved"), this);
    heading->setProperty("role", "heading");
    column->addWidget(heading);
    auto* text = new QLabel(tr("What is recovered opens unsaved, and stays here until you save or discard it."), this);
    text->setProperty("role", "dimmed");
    column->addWidget(text);
    addList(column);
    addButtons(column);
}

void RecoveryDialog::addList(QVBoxLayout* column)
{
    m_list = new QListWidget(this);
    m_list->setObjectName("recoveryList");
    m_list->setIconSize({28, 28});
    m_list->setUniformItemSizes(true);
    for (const Recovery& recovery : m_found) {
        const QString about = tr("%1  \u00b7  %2").arg(timeWords(recovery.lastChange), amountWords(recovery.entries));
        auto* item = new QListWidgetItem(icon("part"), nameOf(recovery) + "\n" + about, m_list);
        item->setToolTip(recovery.projectFile.empty() ? QString() : QFile::decodeName(recovery.projectFile.c_str()));
    }
    m_list->setCurrentRow(0);
    constexpr int mostShown = 5;
    const auto shown = std::min(static_cast<int>(m_found.size()), mostShown);
    m_list->setFixedHeight(shown * m_list->sizeHintForRow(0) + 2 * m_list->frameWidth());
    column->addWidget(m_list);
    connect(m_list, &QListWidget::itemDoubleClicked, this, &RecoveryDialog::recover);
}

void RecoveryDialog::addButtons(QVBoxLayout* column)
{
    auto* row = new QHBoxLayout;
    m_discard = new QPushButton(tr("Discard..."), this);
    m_discard->setObjectName("recoveryDiscard");
    auto* later = new QPushButton(tr("Later"), this);
    later->setObjectName("recoveryLater");
    m_recover = new QPushButton(tr("Recover"), this);
    m_recover->setObjectName("recoveryRecover");
    m_recover->setProperty("role", "primary");
    m_recover->setDefault(true);
    row->addWidget(m_discard);
    row->addStretch();
    row->addWidget(later);
    row->addWidget(m_recover);
    column->addLayout(row);
    connect(m_discard, &QPushButton::clicked, this, &RecoveryDialog::askToDiscard);
    connect(later, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_recover, &QPushButton::clicked, this, &RecoveryDialog::recover);
}

void RecoveryDialog::recover()
{
    const int row = m_list->currentRow();
    if (row < 0)
        return;
    const Recovery chosen = m_found[static_cast<std::size_t>(row)];
    accept();
    emit recoverClicked(chosen);
}

void RecoveryDialog::askToDiscard()
{
    const int row = m_list->currentRow();
    if (row < 0)
        return;
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Discard unsaved work"),
                                tr("Discard the unsaved work on \"%1\"? It cannot be brought back.")
                                    .arg(nameOf(m_found[static_cast<std::size_t>(row)])),
                                QMessageBox::Discard | QMessageBox::Cancel, this);
    box->setObjectName("discardBox");
    box->setIconPixmap(icon("warning").pixmap(32, 32));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(box, &QMessageBox::finished, this, [this, row](int button) {
        if (button == QMessageBox::Discard)
            discard(row);
    });
    box->open();
}

void RecoveryDialog::discard(int row)
{
    const Recovery chosen = m_found[static_cast<std::size_t>(row)];
    m_found.erase(m_found.begin() + row);
    delete m_list->takeItem(row);
    emit discardClicked(chosen);
    if (m_found.empty())
        accept();
}

} // namespace knead
