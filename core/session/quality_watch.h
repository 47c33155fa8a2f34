#pragma once

#include "core/simulation/run_quality.h"

#include <cstdint>
#include <map>
#include <vector>

namespace knead {

/// Picks what a person should know of how far numbers may be trusted, each thing once: when it stays for half a second of frames,
/// or when time stands still; and once more where it is no longer minor. After a reset, or at another moment of the history, what
/// is well again may be said again.
/// Steps that were not solved are left out: the simulation has a notice of its own for them.
class QualityWatch {
public:
    /// What is new at a frame.
    struct News {
        std::vector<Remark> said;
        std::vector<Message> passed; ///< said before, and no longer so at this moment of the history
    };

    News see(const Snapshot& now);
    void begin(); ///< another document or filling

private:
    std::vector<Message> forgetWhatIsWell(const Snapshot& now, const std::vector<Remark>& remarks);

    std::map<Concern, int> m_frames;  ///< in a row that showed a concern
    std::map<Concern, Remark> m_said; ///< the last one of each
    std::uint64_t m_arrivals = 0;
    std::uint32_t m_resets = 0;
};

} // namespace knead
