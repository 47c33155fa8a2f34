#pragma once

#include "ui/frame/workbench.h"

#include <QObject>
#include <QPointer>
#include <QString>

#include <optional>

class QAction;
class QEvent;
class QToolBar;
class QWidget;

namespace knead {

class ExportFeature;
class HandbookWindow;
class Hands;
class ImportFeature;
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

    /// What the tour uses of the window. It stays as long as this.
    struct Places {
        ImportFeature& imports;
        const ExportFeature& exports;
        Hands& hands;
        const QToolBar& toolBar;
        const QToolBar& brushes;
        const QWidget& banner;
    };

    explicit HelpFeature(const Workbench& bench);
    ~HelpFeature() override;

    const Actions& actions() const { return m_actions; }

    /// Before the first tour.
    void setPlaces(const Places& places);
    /// Opens a block of clay in place of what is open, once what is not saved may go, with the thumb at hand, and begins the tour
    /// on it.
    void beginTour();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showTour();
    void openHandbookAt(const QWidget* place);
    QString pageAt(const QWidget* place) const;
    void followDocument(Document::Change what);
    void endTour();
    void showControls();
    void showAbout();

    Workbench m_bench;
    Actions m_actions;
    std::optional<Places> m_places;
    QPointer<HandbookWindow> m_handbook;
    QPointer<Tour> m_tour;
    double m_strengthBefore = 1; ///< of brushes, before the tour
};

} // namespace knead
