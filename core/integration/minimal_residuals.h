#pragma once

#include "core/integration/conjugate_gradients.h"

#include <vector>

namespace knead {

/// Generalized minimal residuals (Saad and Schultz 1986) for A dv = r where A is not symmetric: as little is left as can be of what
/// the iterations have seen, by r . P r, which conjugate gradients are measured by, too.
///
/// With v_1 = P r / |r| and y = A v_k:  h_ik = v_i . y,  v_k+1 = (P y - sum_i h_ik v_i) / h_k+1,k,
/// so that v_i . P^-1 v_j is 1 for i = j and else 0; h_k+1,k^2 = y . P y - sum_i h_ik^2.
///
/// In single precision; several threads, same bits for any number.
class MinimalResiduals {
public:
    /// As ConjugateGradients::solve().
    LinearReport solve(ImplicitSystem& system, RigidModePreconditioner& preconditioner, const VectorArray& residual,
                       VectorArray& solution, double goal, int most);

private:
    void extend(ImplicitSystem& system, RigidModePreconditioner& preconditioner);
    void addCombination(FloatArray& to) const;

    std::vector<FloatArray> m_basis;                ///< v, those in use first
    std::vector<std::vector<double>> m_column;      ///< of h, turned so that it is triangular
    std::vector<std::pair<double, double>> m_turns; ///< cosine and sine that did it
    std::vector<double> m_left;                     ///< r in that basis, turned; the last one is what is left of it
    FloatArray m_residual;
    FloatArray m_solution;
    FloatArray m_preconditioned;
    FloatArray m_product;
    FloatArray m_way;
};

} // namespace knead
