#pragma once

#include "core/geometry/wall_change.h"
#include "core/session/stretch_warning.h"
#include "ui/document/background_look.h"

#include <QObject>
#include <QString>

#include <vector>

namespace knead {

class FoldWatch;

/// A place of a body that a person should look at before going on.
struct PlaceWarning {
    enum class Kind { fold, thinWall, stretch };
    Kind kind = Kind::fold;
    BodyId body = 0;
    Vec3 place = Vec3::Zero(); ///< where it is now [m]
    QString text;              ///< short, for beside the place
};

/// Knows where bodies are folded over themselves, which of their walls became thinnest, and where they are about to break; see
/// foldsOf(), WallChange and mostOverstretched(). One of each kind per body, none for what is fine. Walls are not looked at in
/// bodies that came apart, since cracks are no walls, and not told of folded ones, where a surface that crosses itself has no
/// thickness. Window thread.
class WarningWatch final : public QObject {
    Q_OBJECT
public:
    /// @param folds outlives it
    WarningWatch(Document& document, const FoldWatch& folds, QObject* parent = nullptr);

    /// With places that go along with the material until the next look.
    std::vector<PlaceWarning> warnings() const;

    /// That was looked at last; null: none of this content yet.
    const FramePointer& seen() const { return m_frame; }

signals:
    void changed();

private:
    struct OfBody {
        BodyId body = 0;
        std::optional<ThinnedWall> wall;
        std::optional<Overstretch> stretch;
    };
    class Finder;

    void take(const FramePointer& frame, std::vector<OfBody> found);
    void addFolds(std::vector<PlaceWarning>& all) const;
    void addFound(const OfBody& one, const Frame& now, std::vector<PlaceWarning>& all) const;

    Document& m_document;
    const FoldWatch& m_folds;
    FramePointer m_frame; ///< that `m_found` are of
    std::vector<OfBody> m_found;
    BackgroundLook m_look; // last: ends first
};

} // namespace knead
