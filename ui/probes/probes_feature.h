#pragma once

#include "ui/frame/workbench.h"

#include <QObject>

#include <vector>

class QAction;

namespace knead {

class Measuring;
class ProbeSet;
class ProjectKeeper;
struct OverlayMark;

/// Places of the part at which something is plotted over time: their panel, their marks, and the table as a file. Window thread only.
class ProbesFeature final : public QObject {
    Q_OBJECT
public:
    /// @param measuring whose way of picking places is taken
    /// @param keeper whose projects keep them
    ProbesFeature(const Workbench& bench, Measuring& measuring, ProjectKeeper& keeper);

    ProbeSet& probes() { return *m_probes; }

    /// Writes what probes read over time as a table in the background.
    void write(const QString& path);

private:
    QAction* newPlaceAction(Measuring& measuring);
    std::vector<OverlayMark> probeMarks() const;

    Workbench m_bench;
    ProbeSet* m_probes;
};

} // namespace knead
