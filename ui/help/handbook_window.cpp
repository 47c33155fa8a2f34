#include "ui/help/handbook_window.h"

#include "ui/help/handbook.h"
#include "ui/help/page_browser.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QSplitter>
#include <QTextCursor>
#include <QUrl>
#include <QVBoxLayout>

namespace knead {

namespace {

constexpr int pageName = Qt::UserRole;

} // namespace

HandbookWindow::HandbookWindow(QWidget* parent)
    : ModelessDialog(parent)
    , m_search(new QLineEdit(this))
    , m_pages(new QListWidget(this))
    , m_text(new PageBrowser(this))
{
    setObjectName("handbook");
    setWindowTitle(tr("Handbook"));
    m_search->setObjectName("handbookSearch");
    m_search->setPlaceholderText(tr("Find"));
    m_search->setClearButtonEnabled(true);
    m_pages->setObjectName("handbookPages");
    m_text->setObjectName("handbookText");
    auto* left = new QWidget(this);
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(8, 8, 8, 8);
    column->addWidget(m_search);
    column->addWidget(m_pages, 1);
    auto* halves = new QSplitter(this);
    halves->setChildrenCollapsible(false);
    halves->addWidget(left);
    halves->addWidget(m_text);
    halves->setStretchFactor(1, 1);
    halves->setSizes({240, 680});
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(halves);
    connect(m_search, &QLineEdit::textChanged, this, &HandbookWindow::list);
    connect(m_search, &QLineEdit::returnPressed, this, &HandbookWindow::findNext);
    connect(m_pages, &QListWidget::currentRowChanged, this, &HandbookWindow::showPage);
    connect(m_text, &QTextBrowser::anchorClicked, this, &HandbookWindow::follow);
    list({});
    resize(940, 680);
}

void HandbookWindow::open(const QString& page)
{
    m_search->clear();
    int row = 0;
    for (int i = 0; i < m_pages->count(); ++i)
        if (m_pages->item(i)->data(pageName).toString() == page)
            row = i;
    m_pages->setCurrentRow(row);
    show();
    raise();
    activateWindow();
    m_search->setFocus();
}

QString HandbookWindow::page() const
{
    const QListWidgetItem* item = m_pages->currentItem();
    return item != nullptr ? item->data(pageName).toString() : QString();
}

/// The pages that have all words, with how often; all where nothing is wanted.
void HandbookWindow::list(const QString& wanted)
{
    const QString before = page();
    m_pages->clear();
    const bool isAll = wanted.trimmed().isEmpty();
    for (const handbook::Page& one : handbook::pages()) {
        const qsizetype hits = isAll ? 1 : handbook::hitsIn(one, wanted);
        if (hits == 0)
            continue;
        auto* item = new QListWidgetItem(isAll ? one.title : QStringLiteral("%1 (%2)").arg(one.title).arg(hits));
        item->setData(pageName, one.name);
        m_pages->addItem(item);
        if (one.name == before)
            m_pages->setCurrentItem(item);
    }
    if (m_pages->currentItem() == nullptr)
        m_pages->setCurrentRow(0);
    if (!isAll)
        findNext();
}

void HandbookWindow::showPage()
{
    const handbook::Page* shown = handbook::pageNamed(page());
    m_text->showPage(shown != nullptr ? shown->text : tr("No page has these words."));
}

/// The next place of the first word, from the top again after the last one.
void HandbookWindow::findNext()
{
    const QString word = m_search->text().trimmed().section(' ', 0, 0);
    if (word.isEmpty() || m_text->find(word))
        return;
    m_text->moveCursor(QTextCursor::Start);
    m_text->find(word);
}

void HandbookWindow::follow(const QUrl& link)
{
    if (!link.isRelative()) {
        QDesktopServices::openUrl(link);
        return;
    }
    const bool isRecipes = link.path().endsWith("examples/README.md");
    const QString name = isRecipes ? "recipes" : QFileInfo(link.path()).completeBaseName();
    if (handbook::pageNamed(name) != nullptr)
        open(name);
}

} // namespace knead
