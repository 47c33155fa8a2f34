#pragma once

#include "ui/frame/workbench.h"
#include "ui/recording/picture.h"
#include "ui/viewport/scene_view.h"

#include <QObject>

class QAction;

namespace knead {

/// Pictures of what the active view shows, in any size. Window thread only.
class PictureFeature final : public QObject {
    Q_OBJECT
public:
    explicit PictureFeature(const Workbench& bench);

    QAction* action() const { return m_action; }

    /// Draws what the view shows now, in the background, and writes it. An ending that names a format decides.
    void save(const QString& path, const Picture& picture) { save(path, picture, seen()); }

private:
    /// What the view showed at some time.
    struct Seen {
        SceneLook look;
        FramePointer frame;
        double height = 1; ///< of the view [logical pixels]
    };

    Seen seen() const;
    void ask();
    void askForPlace(const Picture& picture, const Seen& seen);
    void save(const QString& path, const Picture& picture, const Seen& seen);

    Workbench m_bench;
    QAction* m_action;
};

} // namespace knead
