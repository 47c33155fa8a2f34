#pragma once

#include "core/message/message.h"
#include "core/simulation/snapshot.h"

#include <QWidget>

#include <vector>

class QLabel;
class QProgressBar;

namespace knead {

/// The numbers at the right of the status bar: how fast the simulation runs and how large it is. Where there is no room for all
/// of them those that say least are left out; none is cut.
class StatusReadings final : public QWidget {
    Q_OBJECT
public:
    explicit StatusReadings(QWidget* parent = nullptr);

    void show(const Snapshot& snapshot);
    void showUnits(const QString& units); ///< of what is shown
    /// The wanted ratio of simulated to wall time: slow motion is not slowness.
    void setSpeed(double speed) { m_speed = speed; }

    QSize sizeHint() const override; ///< of all there is to say
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;

private:
    double m_speed = 1;
    int roomFor(const std::vector<QLabel*>& labels) const;
    std::vector<QLabel*> spoken() const;
    void fit();
    static QString stepsText(const Snapshot& snapshot);
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
    QLabel* m_units;
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

/// "1.00x real time", "0.40x real time": the number says whether that is slower.
Message ratioWords(double ratio);
QString ratioText(double ratio);

} // namespace knead
