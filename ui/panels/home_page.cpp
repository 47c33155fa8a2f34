#include "ui/panels/home_page.h"

#include "ui/theme.h"

#include <QDir>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace knead {

namespace {

/// "l_bracket.step" becomes "L bracket".
QString readableName(const QFileInfo& file)
{
    QString name = file.completeBaseName().replace('_', ' ').replace('-', ' ');
    if (!name.isEmpty())
        name[0] = name[0].toUpper();
    return name;
}

QLabel* centered(const QString& text, const char* role, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setAlignment(Qt::AlignCenter);
    label->setProperty("role", role);
    label->setWordWrap(true);
    return label;
}

/// Everything in a layout.
void takeAway(QLayout* layout)
{
    while (QLayoutItem* item = layout->takeAt(0)) {
        if (QWidget* widget = item->widget()) {
            widget->hide();
            widget->deleteLater(); // it may be what was clicked
        }
        if (item->layout() != nullptr)
            takeAway(item->layout());
        delete item;
    }
}

} // namespace

HomePage::HomePage(const QString& examplesFolder, QWidget* parent)
    : QWidget(parent)
{
    setObjectName("homePage");
    auto* zone = new QFrame(this);
    zone->setObjectName("dropZone");
    zone->setFixedWidth(700);
    auto* column = new QVBoxLayout(zone);
    column->setContentsMargins(36, 32, 36, 32);
    column->setSpacing(14);
    auto* sign = new QLabel(zone);
    sign->setPixmap(icon("knead").pixmap(72, 72));
    sign->setAlignment(Qt::AlignCenter);
    column->addWidget(sign);
    column->addWidget(centered(tr("Drop STEP, IGES, mesh or project files here"), "big", zone));
    column->addWidget(centered(tr("It becomes a lump of real material to push, bend and squeeze."), "dimmed", zone));
    auto* open = new QPushButton(tr("Open a file..."), zone);
    open->setObjectName("homeOpen");
    open->setProperty("role", "primary");
    open->setMinimumHeight(34);
    connect(open, &QPushButton::clicked, this, &HomePage::openClicked);
    auto* openRow = new QHBoxLayout;
    openRow->addStretch();
    openRow->addWidget(open);
    openRow->addStretch();
    column->addLayout(openRow);

    const QFileInfoList examples = QDir(examplesFolder).entryInfoList({"*.step", "*.stp"}, QDir::Files, QDir::Name);
    if (!examples.isEmpty()) {
        column->addSpacing(10);
        column->addWidget(centered(tr("or begin with an example"), "dimmed", zone));
        auto* row = new QHBoxLayout;
        row->addStretch();
        for (const QFileInfo& example : examples) {
            auto* button = new QPushButton(icon("part"), readableName(example), zone);
            button->setObjectName("example_" + example.completeBaseName());
            connect(button, &QPushButton::clicked, this,
                    [this, path = example.absoluteFilePath()] { emit fileChosen(path); });
            row->addWidget(button);
        }
        row->addStretch();
        column->addLayout(row);
    }

    m_recent = new QVBoxLayout;
    m_recent->setSpacing(14);
    column->addLayout(m_recent);

    auto* page = new QVBoxLayout(this);
    page->addStretch();
    page->addWidget(zone, 0, Qt::AlignHCenter);
    page->addStretch();
}

void HomePage::showRecent(const QStringList& paths)
{
    constexpr qsizetype most = 4;
    constexpr int longestName = 110; // [pixels]
    takeAway(m_recent);
    if (paths.isEmpty())
        return;
    m_recent->addSpacing(10);
    m_recent->addWidget(centered(tr("or go on with"), "dimmed", this));
    auto* row = new QHBoxLayout;
    row->addStretch();
    for (const QString& path : paths.first(std::min(most, paths.size()))) {
        const QString name = fontMetrics().elidedText(QFileInfo(path).fileName(), Qt::ElideMiddle, longestName);
        auto* button = new QPushButton(icon("part"), name, this);
        button->setObjectName("recent_" + QFileInfo(path).fileName());
        button->setToolTip(path);
        connect(button, &QPushButton::clicked, this, [this, path] { emit fileChosen(path); });
        row->addWidget(button);
    }
    row->addStretch();
    m_recent->addLayout(row);
}

} // namespace knead
