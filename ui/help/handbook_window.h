#pragma once

#include "ui/dialogs/modeless_dialog.h"

class QLineEdit;
class QListWidget;
class QUrl;

namespace knead {

class PageBrowser;

/// The handbook beside the window: pages on the left, found by words; the page on the right.
class HandbookWindow final : public ModelessDialog {
    Q_OBJECT
public:
    explicit HandbookWindow(QWidget* parent = nullptr);

    /// @param page its name; another than there are: the first one
    void open(const QString& page);
    QString page() const; ///< that is shown

private:
    void list(const QString& wanted);
    void showPage();
    void follow(const QUrl& link);
    void findNext();

    QLineEdit* m_search;
    QListWidget* m_pages;
    PageBrowser* m_text;
};

} // namespace knead
