#include "ui/help/page_browser.h"

#include <QPixmap>
#include <QResizeEvent>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextTable>

#include <algorithm>

namespace knead {

namespace {

constexpr int pageMargin = 18;

/// Headings and tables come without room around them.
void makeRoom(QTextDocument& document)
{
    QTextCursor cursor(&document);
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        QTextBlockFormat format = block.blockFormat();
        constexpr int line = 120;                                      // of a line's height [%]
        if (!block.text().contains(QChar::ObjectReplacementCharacter)) // a picture's is its own
            format.setLineHeight(line, QTextBlockFormat::ProportionalHeight);
        if (format.headingLevel() > 1) {
            format.setTopMargin(18);
            format.setBottomMargin(6);
        }
        cursor.setPosition(block.position());
        cursor.setBlockFormat(format);
    }
    for (QTextFrame* frame : document.rootFrame()->childFrames())
        if (auto* table = qobject_cast<QTextTable*>(frame)) {
            QTextTableFormat format = table->format();
            format.setCellPadding(4);
            format.setCellSpacing(0);
            format.setBorder(0);
            table->setFormat(format);
        }
}

} // namespace

PageBrowser::PageBrowser(QWidget* parent)
    : QTextBrowser(parent)
{
    setOpenLinks(false);
    document()->setDocumentMargin(pageMargin);
}

void PageBrowser::showPage(const QString& markdown)
{
    setMarkdown(markdown);
    makeRoom(*document());
    moveCursor(QTextCursor::Start);
}

/// Pictures come smoothly scaled: the document would drop lines of theirs.
QVariant PageBrowser::loadResource(int type, const QUrl& name)
{
    if (type != QTextDocument::ImageResource)
        return QTextBrowser::loadResource(type, name);
    QPixmap picture(":/handbook/" + name.path());
    if (picture.isNull())
        return {};
    const double pixels = devicePixelRatioF();
    const auto most = static_cast<int>(pixels * textWidth());
    if (picture.width() > most)
        picture = picture.scaledToWidth(most, Qt::SmoothTransformation);
    picture.setDevicePixelRatio(pixels);
    return picture;
}

void PageBrowser::resizeEvent(QResizeEvent* event)
{
    QTextBrowser::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        fitPictures();
}

int PageBrowser::textWidth() const
{
    return std::max(1, viewport()->width() - 2 * pageMargin);
}

void PageBrowser::fitPictures()
{
    bool isAny = false;
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next())
        for (auto piece = block.begin(); !piece.atEnd(); ++piece) {
            const QTextImageFormat format = piece.fragment().charFormat().toImageFormat();
            if (!format.isValid())
                continue;
            const QUrl name(format.name());
            document()->addResource(QTextDocument::ImageResource, name,
                                    loadResource(QTextDocument::ImageResource, name));
            isAny = true;
        }
    if (isAny)
        document()->markContentsDirty(0, document()->characterCount());
}

} // namespace knead
