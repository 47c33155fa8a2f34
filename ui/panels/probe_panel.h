#pragma once

#include "ui/panels/plot_view.h"
#include "ui/probes/probe_set.h"

#include <QWidget>

class QAction;
class QComboBox;
class QTimer;
class QToolButton;
class QTreeWidget;

namespace knead {

/// What probes read, over time: a list with the present numbers, and a plot of one quantity.
class ProbePanel final : public QWidget {
    Q_OBJECT
public:
    /// @param place with which one places probes, for its button
    ProbePanel(ProbeSet& probes, QAction* place, QWidget* parent = nullptr);

    PlotView& plot() { return *m_plot; }
    ProbeQuantity quantity() const;

signals:
    void csvWanted();

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void makeRow(QAction* place);
    void makeRows();
    void showReadings();
    void sayWhatToDo();
    void chooseQuantity();
    void removeSelected();
    PlotLine lineOf(const Probe& probe) const;

    ProbeSet& m_probes;
    QComboBox* m_quantity = nullptr;
    QToolButton* m_csv = nullptr;
    QToolButton* m_delete = nullptr;
    QTreeWidget* m_list;
    PlotView* m_plot;
    QTimer* m_soon; ///< many samples are shown at once
};

} // namespace knead
