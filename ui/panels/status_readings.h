#pragma once

#include "core/simulation/snapshot.h"

#include <QWidget>

#include <vector>

class QLabel;
class QProgressBar;
class QToolButton;

namespace knead {

/// The numbers at the right of the status bar: how fast the simulation runs and how large it is.
class StatusReadings final : public QWidget {
    Q_OBJECT
public:
    explicit StatusReadings(QWidget* parent = nullptr);

    void show(const Snapshot& snapshot);
    /// The wanted ratio of simulated to wall time: slow motion is not slowness.
    void setSpeed(double speed) { m_speed = speed; }

private:
    double m_speed = 1;
    QLabel* add(const QString& name, const QString& tip);

    QLabel* m_ratio;
    QLabel* m_updates;
    QLabel* m_objects;
    QLabel* m_connections;
    QLabel* m_contacts;
    QLabel* m_broken;
    QLabel* m_pieces;
    QLabel* m_steps;
    QLabel* m_integrator;
};

/// What is being done in the background, how far it is, and a button that stops it.
class TaskReading final : public QWidget {
    Q_OBJECT
public:
    explicit TaskReading(QWidget* parent = nullptr);

    void begin(const QString& title);
    void progress(double fraction, const QString& stage);
    void end();

signals:
    void cancelClicked();

private:
    QString m_title;
    QLabel* m_stage;
    QProgressBar* m_bar;
};

/// "1.00x", "0.40x, slower than real time".
QString ratioText(double ratio);

} // namespace knead
