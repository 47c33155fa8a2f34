#pragma once

#include "core/document/history.h"
#include "core/session/playback_cache.h"

#include <vector>

namespace knead {

/// The way through the history that is shown: from where its steps begin to be counted to where redo ends, along simulated time.
/// After a reset time goes on, so that nothing overlaps, and so it does where a simulation in trouble went back.
struct Timeline {
    struct Tick {
        History::Entry entry = 0;
        double at = 0; ///< [s]
        bool isKey = false;
    };
    /// A frame of the film in its place.
    struct Picture {
        double at = 0;            ///< [s]
        History::Entry entry = 0; ///< to which it leads
        bool isUnderWay = false;  ///< there is no entry yet
        PlaybackFramePointer frame;
        std::uint32_t run = 0; ///< after so many resets within the entry
    };
    std::vector<Tick> ticks;       ///< the first one at 0
    std::vector<Picture> pictures; ///< in order
    std::vector<double> fillings;  ///< where bodies have been filled anew since the picture before, ascending [s]
    double present = 0;            ///< of the simulation [s]
    double end = 0;                ///< [s]

    /// The last picture at or before a place, or the first one; null without any.
    const Picture* pictureAt(double at) const;
    /// What is seen at a place: between pictures that lie close together, something between them; null without any.
    PlaybackFramePointer frameAt(double at) const;
    const Tick* tickNear(double at, double reach) const; ///< the nearest within reach; null: none
    /// Whether a body was filled anew within reach of a place.
    bool isFilledAnewAt(double at, double reach) const;
};

/// @param isUnderWay something is being done, or is no entry yet: what was done from here before is no longer ahead
Timeline timelineOf(const History& history, const PlaybackCache& film, bool isUnderWay);

} // namespace knead
