#pragma once

#include <QWidget>

#include <vector>

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

    enum class Side { left, right };
    /// A bar beside the views comes and goes with them, unless a person does not want it.
    void addBar(QToolBar& bar, Side side);
    void showHome(); ///< the first page
    void showViews();
    bool hasViews() const; ///< they are shown, not the first page

signals:
    void turned(); ///< to the other of both

private:
    void showBars();

    Banner* m_banner;
    QBoxLayout* m_row; ///< the pages between the bars
    QStackedWidget* m_pages;
    HomePage* m_home;
    ViewGrid* m_views;
    std::vector<QToolBar*> m_bars;
};

} // namespace knead
