#pragma once

#include "ui/frame/workbench.h"

#include <QObject>
#include <QPointer>

class QAction;
class QWidget;

namespace knead {

class HandbookWindow;
class Tour;

/// The handbook, the tour, the keys, and what the program is made with. Window thread only.
class HelpFeature final : public QObject {
    Q_OBJECT
public:
    struct Actions {
        explicit Actions(QWidget& window);

        QAction* handbook;
        QAction* tour;
        QAction* controls;
        QAction* about;
    };

    explicit HelpFeature(const Workbench& bench);
    ~HelpFeature() override;

    const Actions& actions() const { return m_actions; }

    /// The tool bar that the tour shows; before its first. It stays as long as this.
    void setToolBar(QWidget& bar) { m_toolBar = &bar; }

    /// Shows the tour of the window to who has not seen it.
    void offerTour();

private:
    void showHandbook();
    void showTour();
    void showControls();
    void showAbout();

    Workbench m_bench;
    Actions m_actions;
    QWidget* m_toolBar = nullptr;
    QPointer<HandbookWindow> m_handbook;
    QPointer<Tour> m_tour;
};

} // namespace knead
