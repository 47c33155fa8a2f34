#pragma once

#include "core/mechanics/vector_array.h"

#include <deque>

namespace knead {

/// Speeds up v <- v + f(v), where f is what a linear system that is only near the true one gives: the elastic tangent of
/// material that flows, for one, with which the error goes down by the same factor in each iteration.
///
/// With dv, df the differences between the last iterations, the next is
///     v + f - sum g_j (dv_j + df_j),   g the least squares solution of f = sum g_j df_j
/// (Anderson 1965; type II of Fang and Saad 2009). Euclidean norm. Same bits for any number of threads.
class AndersonMixing {
public:
    /// Forgets earlier iterations.
    void restart();

    /// @param start v
    /// @param next v + f as the linear system gave it; afterwards where to go on
    void accelerate(const VectorArray& start, VectorArray& next);

private:
    struct Difference {
        VectorArray start; ///< dv
        VectorArray way;   ///< df
    };
    std::deque<Difference> m_differences; ///< the oldest first
    VectorArray m_start;                  ///< of the iteration before
    VectorArray m_way;                    ///< f of it
    bool m_hasLast = false;
};

} // namespace knead
