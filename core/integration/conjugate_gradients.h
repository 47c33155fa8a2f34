#pragma once

#include "core/integration/rigid_mode_preconditioner.h"

#include <functional>

namespace knead {

/// a . b over all rows, summed in an order that does not depend on the number of threads.
double dotProduct(const VectorArray& a, const VectorArray& b);

/// Preconditioned conjugate gradients for A dv = r.
class ConjugateGradients {
public:
    struct Report {
        int iterations = 0;
        double start = 0; ///< r . P r at the start [J]
        double end = 0;   ///< and at the end
    };

    /// Adds dv to `solution` and makes `residual` what is left of it, until r . P r is at most `goal` [J], or for `most`
    /// iterations.
    /// @param isStopped asked before each iteration, which is then the last; none: never
    Report solve(ImplicitSystem& system, RigidModePreconditioner& preconditioner, VectorArray& residual,
                 VectorArray& solution, double goal, int most, const std::function<bool()>& isStopped = {});

private:
    VectorArray m_direction;
    VectorArray m_preconditioned;
    VectorArray m_product;
};

} // namespace knead
