#pragma once

#include "core/simulation/pace.h"

#include <optional>

namespace knead {

/// Chooses the pace of a simulation by how much of the time of its frames it takes. It gives way soon and takes back late, so that it
/// does not go to and fro. Plain data; one thread at a time.
class Governor {
public:
    /// A frame was played.
    /// @param cost time that its steps and its snapshot took, by the time that they were to take; above 1 it falls behind
    /// @param seconds that the frame lasted
    /// @return another pace than `present`, where that would do better
    std::optional<Pace> see(double cost, double seconds, Pace present);

    /// Time stood still, or something else than before is simulated.
    void forget();

private:
    double m_watched = 0; ///< since the last change [s]
    double m_cost = 0;    ///< mean, recent frames more
    double m_easy = 0;    ///< for how long a finer pace would have done [s]
};

} // namespace knead
