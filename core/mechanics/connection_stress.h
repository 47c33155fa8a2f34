#pragma once

#include "core/mechanics/connection_data.h"

namespace knead {

/// What is wanted of a law: the dilatation of objects goes with the energy.
enum class WantedOfLaw { forces, forcesAndEnergy };

/// Finds the stress of all objects, by which the forces beside the springs are.
void findStress(ConnectionData& data, const VectorArray& position, WantedOfLaw wanted);

/// The law of tensor_law.h, and of hyperelastic_law.h where that holds. @param flow null: none @pre data.tensors
void applyTensorLaw(ConnectionData& data, const VectorArray& position, const kernels::FlowResult* flow,
                    WantedOfLaw wanted);

/// Elastic energy at positions, of connections and of objects [J].
double storedEnergy(ConnectionData& data, const VectorArray& position);

/// Objects with all 18 connections whose surroundings are flat or inside out: det F <= 0.
std::size_t countInverted(ConnectionData& data, const ObjectState& state);

/// F of all objects.
class DeformationGradients {
public:
    /// @param theta written: ln det F less its rest value
    DeformationGradients(const ConnectionData& data, const VectorArray& position, LaneVector<double>& theta);

    Mat3 of(std::size_t object) const;

private:
    std::array<LaneVector<double>, 9> m_components; ///< by lattice column
};

} // namespace knead
