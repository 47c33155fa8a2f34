#include "ui/panels/home_page.h"

#include "ui/commands/listed_actions.h"
#include "ui/language/retranslation.h"
#include "ui/panels/picture_card.h"
#include "ui/project/thumbnails.h"
#include "ui/theme.h"

#include <QDir>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>

namespace knead {

namespace {

constexpr int cardsInRow = 6;
constexpr int cardGap = 8; // six cards and a scroll bar have room in the smallest window that is usual
constexpr int pageWidth = cardsInRow * PictureCard::pictureSize.width() + (cardsInRow - 1) * cardGap;

/// "l_bracket.step" becomes "L bracket".
QString readableName(const QFileInfo& file)
{
    QString name = file.completeBaseName().replace('_', ' ').replace('-', ' ');
    if (!name.isEmpty())
        name[0] = name[0].toUpper();
    return name;
}

QLabel* label(const QString& text, const char* role, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setProperty("role", role);
    label->setWordWrap(true);
    return label;
}

/// Home is written as ~.
QString folderOf(const QString& path)
{
    QString folder = QFileInfo(path).absolutePath();
    if (folder.startsWith(QDir::homePath()))
        folder.replace(0, QDir::homePath().size(), "~");
    return folder;
}

QGridLayout* makeGrid(QWidget* owner)
{
    auto* grid = new QGridLayout(owner);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(cardGap);
    grid->setColumnStretch(cardsInRow, 1);
    return grid;
}

} // namespace

HomePage::HomePage(const QString& examplesFolder, QWidget* parent)
    : QScrollArea(parent)
    , m_examplesFolder(examplesFolder)
{
    setObjectName("homePage");
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setFocusPolicy(Qt::NoFocus);
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout;
    column->setSpacing(12);
    column->addWidget(makeWaiting());
    column->addWidget(makeTrial());
    column->addWidget(makeZone());
    m_recent = new QWidget(page);
    m_recentGrid = makeGrid(m_recent);
    m_recentTitle = label(tr("Go on with"), "title", page);
    m_recentTitle->setObjectName("recentTitle");
    column->addSpacing(6);
    column->addWidget(m_recentTitle);
    column->addWidget(m_recent);
    addExamples(column, examplesFolder);
    column->addStretch();
    auto* row = new QHBoxLayout(page);
    row->setContentsMargins(10, 18, 10, 18);
    row->setSpacing(0); // six cards in a row have room in the smallest window that is usual
    row->addStretch();
    row->addLayout(column);
    row->addStretch();
    setWidget(page);
    listCards();
}

/// What happens at once: the largest thing on the page.
QWidget* HomePage::makeTrial()
{
    auto* trial = new QFrame(this);
    trial->setObjectName("trial");
    trial->setMaximumWidth(pageWidth);
    trial->setMinimumWidth(std::min(pageWidth, 560));
    auto* sign = new QLabel(trial);
    sign->setPixmap(icon("sculpt-thumb").pixmap(QSize(56, 56), devicePixelRatioF()));
    auto* begin = new QPushButton(tr("Try it"), trial);
    begin->setObjectName("homeTry");
    begin->setProperty("role", "primary");
    begin->setMinimumSize(120, 40);
    connect(begin, &QPushButton::clicked, this, &HomePage::tryClicked);
    auto* words = new QVBoxLayout;
    words->setSpacing(4);
    words->addStretch();
    words->addWidget(label(tr("Try it: press a thumb into clay"), "big", trial));
    words->addWidget(
        label(tr("A block of clay opens. Hold the left button on it; then pull it, and export it. Two minutes."),
              "dimmed", trial));
    words->addStretch();
    auto* row = new QHBoxLayout(trial);
    row->setContentsMargins(24, 20, 24, 20);
    row->setSpacing(20);
    row->addWidget(sign);
    row->addLayout(words, 1);
    row->addWidget(begin);
    return trial;
}

/// Where to drop a file, or to open one.
QWidget* HomePage::makeZone()
{
    m_zone = new QFrame(this);
    m_zone->setObjectName("dropZone");
    m_zone->setMaximumWidth(pageWidth);
    m_zone->setMinimumWidth(std::min(pageWidth, 560));
    auto* sign = new QLabel(m_zone);
    sign->setPixmap(icon("knead").pixmap(QSize(40, 40), devicePixelRatioF()));
    auto* open = new QPushButton(tr("Open a file..."), m_zone);
    open->setObjectName("homeOpen");
    open->setMinimumHeight(34);
    connect(open, &QPushButton::clicked, this, &HomePage::openClicked);
    setFocusProxy(open);
    auto* words = new QVBoxLayout;
    words->setSpacing(4);
    words->addStretch();
    words->addWidget(label(tr("Drop STEP, IGES, mesh or project files here"), "title", m_zone));
    words->addWidget(label(tr("It becomes a lump of real material to push, bend and squeeze."), "dimmed", m_zone));
    words->addStretch();
    auto* row = new QHBoxLayout(m_zone);
    row->setContentsMargins(24, 12, 24, 12);
    row->setSpacing(20);
    row->addWidget(sign);
    row->addLayout(words, 1);
    row->addWidget(open);
    return m_zone;
}

QWidget* HomePage::makeWaiting()
{
    m_waiting = new QFrame(this);
    m_waiting->setObjectName("waitingWork");
    m_waiting->setMaximumWidth(pageWidth);
    auto* sign = new QLabel(m_waiting);
    sign->setPixmap(icon("warning").pixmap(QSize(28, 28), devicePixelRatioF()));
    auto* words = new QVBoxLayout;
    words->setSpacing(2);
    words->addWidget(label(tr("Unsaved work is waiting"), "heading", m_waiting));
    m_waitingNames = label({}, "dimmed", m_waiting);
    m_waitingNames->setObjectName("waitingNames");
    words->addWidget(m_waitingNames);
    auto* recover = new QPushButton(tr("Recover..."), m_waiting);
    recover->setObjectName("homeRecover");
    connect(recover, &QPushButton::clicked, this, &HomePage::recoverClicked);
    auto* row = new QHBoxLayout(m_waiting);
    row->setContentsMargins(18, 12, 18, 12);
    row->setSpacing(14);
    row->addWidget(sign);
    row->addLayout(words, 1);
    row->addWidget(recover);
    m_waiting->hide();
    return m_waiting;
}

void HomePage::addExamples(QVBoxLayout* column, const QString& folder)
{
    const QFileInfoList examples = QDir(folder).entryInfoList({"*.step", "*.stp"}, QDir::Files, QDir::Name);
    if (examples.isEmpty())
        return;
    column->addSpacing(6);
    column->addWidget(label(tr("Begin with an example"), "title", this));
    auto* all = new QWidget(this);
    QGridLayout* grid = makeGrid(all);
    for (const QFileInfo& example : examples) {
        const QImage picture(example.absolutePath() + '/' + example.completeBaseName() + ".png");
        if (picture.isNull())
            continue; // it belongs to a recipe
        auto* card = new PictureCard(picture, readableName(example), example.fileName(), all);
        card->setObjectName("example_" + example.completeBaseName());
        connect(card, &QPushButton::clicked, this,
                [this, path = example.absoluteFilePath()] { emit fileChosen(path); });
        grid->addWidget(card, grid->count() / cardsInRow, grid->count() % cardsInRow);
    }
    column->addWidget(all);
}

void HomePage::fillExamples(QMenu& menu)
{
    const QDir folder(m_examplesFolder);
    const QString recipeEnding = QStringLiteral(".recipe.json");
    const auto add = [&](const QFileInfo& file, const QString& name) {
        QAction* action = menu.addAction(name);
        action->setObjectName("example-" + file.fileName());
        action->setToolTip(file.fileName());
        action->setProperty(opensFile, true);
        connect(
            action, &QAction::triggered, this, [this, path = file.absoluteFilePath()] { emit fileChosen(path); },
            Qt::QueuedConnection);
    };
    for (const QFileInfo& part : folder.entryInfoList({"*.step", "*.stp"}, QDir::Files, QDir::Name))
        if (folder.exists(part.completeBaseName() + ".png")) // else it belongs to a recipe
            add(part, readableName(part));
    menu.addSeparator();
    for (const QFileInfo& recipe : folder.entryInfoList({'*' + recipeEnding}, QDir::Files, QDir::Name))
        add(recipe, readableName(QFileInfo(recipe.fileName().chopped(recipeEnding.size()) + ".json")));
    menu.setEnabled(!menu.isEmpty());
}

void HomePage::showRecent(const QStringList& paths)
{
    constexpr qsizetype most = 6;
    m_recentPaths = paths.first(std::min(most, paths.size()));
    if (isVisible()) // else when it is shown: pictures take their time to read
        listCards();
}

void HomePage::listCards()
{
    while (QLayoutItem* item = m_recentGrid->takeAt(0)) {
        item->widget()->hide();
        item->widget()->setObjectName({});
        item->widget()->deleteLater(); // it may be what was clicked
        delete item;
    }
    for (const QString& path : m_recentPaths) {
        const QFileInfo file(path);
        auto* card = new PictureCard(thumbnails::of(path), file.fileName(), folderOf(path), m_recent);
        card->setObjectName("recent_" + file.fileName());
        card->setToolTip(path);
        connect(card, &QPushButton::clicked, this, [this, path] { emit fileChosen(path); });
        m_recentGrid->addWidget(card, m_recentGrid->count() / cardsInRow, m_recentGrid->count() % cardsInRow);
    }
    m_recent->setVisible(!m_recentPaths.isEmpty());
    m_recentTitle->setVisible(!m_recentPaths.isEmpty());
}

void HomePage::showWaiting(const QStringList& names)
{
    const auto list = [names] {
        QStringList now;
        for (const QString& name : names)
            now << saidAnew(name);
        return now.join(", ");
    };
    m_waitingNames->setText(noted(list(), list));
    m_waiting->setVisible(!names.isEmpty());
}

void HomePage::showDrop(bool isOver)
{
    m_zone->setProperty("isOver", isOver);
    m_zone->style()->unpolish(m_zone);
    m_zone->style()->polish(m_zone);
}

/// Pictures may have come meanwhile.
void HomePage::showEvent(QShowEvent* event)
{
    listCards();
    QScrollArea::showEvent(event);
}

} // namespace knead
