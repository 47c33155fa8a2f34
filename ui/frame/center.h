#pragma once

#include <QWidget>

class QBoxLayout;
class QStackedWidget;
class QToolBar;

namespace knead {

class Banner;
class Document;
class HomePage;
class ViewGrid;

/// The middle of the window: the first page, or the views with a bar for selecting beside them; a banner lies over both. Window
/// thread only.
class Center final : public QWidget {
    Q_OBJECT
public:
    Center(Document& document, const QString& examplesFolder, QWidget* parent);

    Banner& banner() const { return *m_banner; }
    HomePage& home() const { return *m_home; }
    ViewGrid& views() const { return *m_views; }

    /// It comes and goes with the views, unless a person does not want it.
    void setBar(QToolBar& bar);
    void showViews();
    bool hasViews() const; ///< they are shown, not the first page

signals:
    void turned(); ///< to the other of both

private:
    void showBar();

    Banner* m_banner;
    QBoxLayout* m_row; ///< the bar comes before the pages
    QStackedWidget* m_pages;
    HomePage* m_home;
    ViewGrid* m_views;
    QToolBar* m_bar = nullptr;
};

} // namespace knead
