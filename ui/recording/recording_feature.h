#pragma once

#include "ui/frame/workbench.h"
#include "ui/recording/recording.h"

#include <QObject>

class QAction;
class QWidget;

namespace knead {

/// Videos and pictures of what was simulated. Window thread only.
class RecordingFeature final : public QObject {
    Q_OBJECT
public:
    struct Actions {
        explicit Actions(QWidget& window);

        QAction* video;
        QAction* pictures;
    };

    explicit RecordingFeature(const Workbench& bench);

    const Actions& actions() const { return m_actions; }

    /// Makes a video or pictures in the background.
    /// @param path of the file, or of the folder of the pictures
    void record(const QString& path, const Recording& recording);

private:
    void askForRecording(Recording::Kind kind);
    void askForPlace(const Recording& recording);

    Workbench m_bench;
    Actions m_actions;
};

} // namespace knead
