#pragma once

#include "ui/document/background_look.h"

#include <QObject>
#include <QString>

#include <cstdint>
#include <map>
#include <vector>

namespace knead {

/// Where the surface of a body passes through itself: material was pushed over material there.
struct Fold {
    BodyId body = 0;
    Vec3 place = Vec3::Zero();            ///< the middle of it [m]
    std::vector<std::uint32_t> triangles; ///< of FilledBody::mesh, some of those that cross others, ascending
};

/// Of bodies that deform and have not come apart; those whose surface crosses itself at rest are left out. Any thread, and on that
/// alone; O(n lg n), twice for a body that is folded.
std::vector<Fold> foldsOf(const Frame& frame);

/// Looks for folds while a person works, see BackgroundLook. Says each one when it comes.
class FoldWatch final : public QObject {
    Q_OBJECT
public:
    explicit FoldWatch(Document& document, QObject* parent = nullptr);

    const std::vector<Fold>& folds() const { return m_folds; }
    /// Where the fold's triangles are now [m]; none when the body is shown with another surface.
    std::vector<Vec3> placesOf(const Fold& fold) const;

signals:
    void changed();
    void said(const QString& sentence);
    void passed(const QString& sentence); ///< said of a fold that is there no more

private:
    void say(const Fold& fold);
    void dropPassed();
    void take(const FramePointer& frame, std::vector<Fold> folds);

    Document& m_document;
    FramePointer m_found; ///< that `m_folds` are of
    std::vector<Fold> m_folds;
    std::map<BodyId, QString> m_sentences; ///< said of them
    BackgroundLook m_look;                 // last: ends first
};

} // namespace knead
