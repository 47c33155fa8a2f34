#pragma once

#include "ui/document/document.h"
#include "ui/services.h"
#include "ui/tasks/task_runner.h"

class QMainWindow;

namespace knead {

class Availability;
class Docks;
class Notices;
class ViewGrid;
class ViewportWidget;

/// What the features of the window are handed: each owns its panel and what happens, and takes of this what it needs.
struct Workbench {
    QMainWindow& window;
    const Services& services;
    Document& document;
    TaskRunner& tasks;
    Notices& notices;
    Docks& docks;
    ViewGrid& views;
    ViewportWidget& viewport;   ///< the active one of them
    Availability& availability; ///< of the actions

    /// Whether something is done in the background; then says with what.
    bool isBusy() const;

    /// A name for a file that is written of the open part. @param rest "-forces.csv"
    QString nameForFile(const QString& rest) const;
};

} // namespace knead
