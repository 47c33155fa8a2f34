#pragma once

#include "core/document/history.h"
#include "core/session/frame.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace knead {

/// Where things were at a moment: enough to be drawn, not to go on from. Immutable.
struct PlaybackFrame {
    std::uint32_t run = 0; ///< how many resets there were since the film began or went on from elsewhere
    std::uint64_t step = 0;
    double time = 0;                                        ///< simulated [s]
    std::vector<std::vector<float>> objects;                ///< per body: x y z per object [m]
    std::vector<std::shared_ptr<const Aggregate>> fillings; ///< per body: whose objects these are
    std::size_t ofFillings = 0; ///< what these take where they are other ones than before [bytes]
    std::vector<ToolState> tools;
    struct Held { ///< what a fixture bears
        FixtureId id = 0;
        std::string name;
        Vec3 force = Vec3::Zero(); ///< of the material on it [N]
    };
    std::vector<Held> fixtures;
    std::optional<double> floorHeight; ///< [m]
    /// Per body, shared with the snapshots: broken connections, and what stress is relative to as long as nothing has flowed; of
    /// material that has, that is not kept.
    std::vector<std::shared_ptr<const std::vector<BrokenConnection>>> broken;
    std::vector<std::shared_ptr<const RelaxedState>> relaxed;

    std::vector<Vec3> places(std::size_t body) const; ///< of its objects [m]
    std::size_t memory() const;                       ///< [bytes]
};
using PlaybackFramePointer = std::shared_ptr<const PlaybackFrame>;

/// What was seen while time ran, entry by entry of the history, for looking back. When it takes more memory than is allowed,
/// every second frame of the older half goes. Window thread only.
class PlaybackCache {
public:
    using Entry = History::Entry;
    static constexpr std::size_t defaultMemory = std::size_t{256} << 20U; // [bytes]
    static constexpr double interval = 1.0 / 30;                          // between frames, simulated [s]

    void forget();
    void setMemory(std::size_t most) { m_most = most; }
    std::size_t memory() const { return m_used; }

    /// Time has gone on in the gesture under way: of what is seen one frame per interval is kept, and that in which the gesture
    /// ends.
    void see(SnapshotPointer snapshot);
    /// The same, kept in any case.
    void add(const Snapshot& snapshot);
    /// The gesture under way was seen elsewhere: frames that another film kept of it, in which nothing was reset.
    void goOnWith(PlaybackCache other);
    /// The entry that comes next went as another did, up to a step after so many resets.
    void repeat(Entry other, std::uint64_t step, std::uint32_t resets = 0);
    /// The gesture has become an entry: what was kept up to its end belongs to it.
    /// @param endStep that was reached
    /// @param resets in the gesture
    void append(Entry entry, std::uint64_t endStep, std::uint32_t resets = 0);
    /// What is under way was given up: the simulation is elsewhere, and counts its resets anew.
    void dropUnderWay();

    /// In order of time; empty for entries without any.
    const std::vector<PlaybackFramePointer>& framesOf(Entry entry) const;
    /// PlaybackFrame::run as it was before any reset in an entry.
    std::uint32_t firstRunOf(Entry entry) const;
    const std::vector<PlaybackFramePointer>& underWay() const { return m_underWay; }
    std::uint32_t run() const { return m_run; } ///< PlaybackFrame::run at the end of the last entry

private:
    struct Reel {
        std::vector<PlaybackFramePointer> frames;
        std::uint32_t firstRun = 0;
    };

    void thin();
    static std::size_t halve(std::vector<PlaybackFramePointer>& frames);

    std::map<Entry, Reel> m_entries;
    std::vector<PlaybackFramePointer> m_underWay;
    SnapshotPointer m_passed;                                 ///< seen last and not kept; else null
    std::vector<std::shared_ptr<const Aggregate>> m_fillings; ///< of the frame that was added last
    std::uint64_t m_rest = 0;                                 ///< Snapshot::rest of what was seen last
    double m_keptTime = -1;                                   ///< of the last frame [s]
    std::optional<Reel> m_repeated;                           ///< of the entry that comes next
    std::uint32_t m_run = 0;                                  ///< in which the next entry begins
    std::size_t m_most = defaultMemory;
    std::size_t m_used = 0;
};

/// Between two frames of one run, 0 <= share <= 1, in straight lines; where a body was filled anew in between, the first one. What
/// breaks in between is broken, so that no skin spans a gap that opens.
PlaybackFrame between(const PlaybackFrame& before, const PlaybackFrame& after, double share);

/// A frame of the film as the view draws it. Its snapshot has places, tools, floor, what was broken, and what
/// stress is relative to where that is kept; nothing else. Any thread, for as long as a skin takes.
/// @pre the frame is one of these bodies
FramePointer drawable(const PlaybackFrame& frame, const FilledBodies& bodies);

} // namespace knead
