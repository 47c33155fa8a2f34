#pragma once

#include <deque>

namespace knead {

/// Notices that time hardly goes on though it is played: less than a hundredth of what was asked for, over four seconds. Says
/// so once, and again only after it went on well.
class StallWatch {
public:
    struct Pace {
        double wall = 0;      ///< clock on the wall [s]
        double simulated = 0; ///< [s]
    };
    struct Stall {
        double wall = 0;      ///< that passed [s]
        double simulated = 0; ///< meanwhile [s]
    };

    /// To be asked about once a second while time is played.
    /// @param speed wanted ratio of simulated to wall time
    /// @return whether the stall that begins now is to be said
    bool look(const Pace& now, double speed);
    Stall stall() const; ///< between the first and the last look that count

    void stop(); ///< time is not played any more

private:
    std::deque<Pace> m_looks;
    bool m_isSaid = false;
};

} // namespace knead
