#pragma once

#include "ui/frame/workbench.h"

#include <QObject>
#include <QPointer>

namespace knead {

struct Actions;
class HandbookWindow;
class Tour;

/// The handbook, the tour, the keys, and what the program is made with. Window thread only.
class HelpFeature final : public QObject {
    Q_OBJECT
public:
    HelpFeature(const Workbench& bench, const Actions& actions);
    ~HelpFeature() override;

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
    QWidget* m_toolBar = nullptr;
    QPointer<HandbookWindow> m_handbook;
    QPointer<Tour> m_tour;
};

} // namespace knead
