#pragma once

#include "core/simulation/snapshot.h"

#include <QWidget>

#include <vector>

class QLabel;

namespace knead {

/// Where the time of a frame goes: a bar of the frame's sixtieth of a second cut into stages, and each stage in numbers.
class PerformancePanel final : public QWidget {
    Q_OBJECT
public:
    explicit PerformancePanel(QWidget* parent = nullptr);

    void show(const Snapshot& snapshot);
    void clear(); ///< what was read of another part says nothing any more

private:
    class BudgetBar;
    struct Row {
        QLabel* frame;
        QLabel* step;
    };

    void showStages(const Snapshot& snapshot);

    QLabel* m_summary;
    QLabel* m_rates;
    BudgetBar* m_bar;
    std::vector<Row> m_rows; ///< per stage, then the snapshot
    std::vector<double> m_smooth;
};

} // namespace knead
