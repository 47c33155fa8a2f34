#pragma once

#include <QObject>

class QLabel;
class QStatusBar;

namespace knead {

class StatusReadings;
class TaskReading;
class TaskRunner;

/// The status bar of the window: a hint on what the mouse does, the task that runs with a button that cancels it, and readings of
/// the simulation. A message and the hint share a place: one at a time. Window thread only.
class StatusLine final : public QObject {
    Q_OBJECT
public:
    StatusLine(QStatusBar& bar, TaskRunner& tasks);

    StatusReadings& readings() const { return *m_readings; } ///< hidden at first
    /// @param hint empty: none
    void showHint(const QString& hint);

private:
    void connectTasks(TaskReading& reading);
    void showHintWhenFree();

    QStatusBar& m_bar;
    TaskRunner& m_tasks;
    QLabel* m_hint;
    StatusReadings* m_readings;
};

} // namespace knead
