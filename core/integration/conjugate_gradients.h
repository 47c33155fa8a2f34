#pragma once

#include "core/integration/rigid_mode_preconditioner.h"

#include <functional>

namespace knead {

/// a . b over all rows, summed in an order that does not depend on the number of threads.
double dotProduct(const VectorArray& a, const VectorArray& b);

/// How a linear system was solved.
struct LinearReport {
    int iterations = 0;
    double start = 0; ///< r . P r at the start [J]
    double end = 0;   ///< and at the end
};

/// Preconditioned conjugate gradients for A dv = r, in single precision: what the solution lacks is found by whoever has the
/// forces, in double. Several threads; same bits for any number.
class ConjugateGradients {
public:
    using Report = LinearReport;

    /// Adds dv to `solution`, until r . P r is at most `goal` [J], or for `most` iterations.
    /// @param residual r, by rows [kg m/s]
    /// @param isStopped asked before each iteration, which is then the last; none: never
    Report solve(ImplicitSystem& system, RigidModePreconditioner& preconditioner, const VectorArray& residual,
                 VectorArray& solution, double goal, int most, const std::function<bool()>& isStopped = {});

private:
    FloatArray m_residual;
    FloatArray m_solution;
    FloatArray m_direction;
    FloatArray m_preconditioned;
    FloatArray m_product;
};

} // namespace knead
