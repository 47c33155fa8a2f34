#pragma once

#include <QTextBrowser>

namespace knead {

/// Shows a page of the handbook: markdown, with pictures as wide as the text or as they are, whichever is less.
/// Pictures are resources below ":/handbook".
class PageBrowser final : public QTextBrowser {
    Q_OBJECT
public:
    explicit PageBrowser(QWidget* parent = nullptr);

    void showPage(const QString& markdown);

protected:
    QVariant loadResource(int type, const QUrl& name) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    int textWidth() const; ///< [logical pixels]
    void fitPictures();
};

} // namespace knead
