#pragma once

#include "peers/peer_bar.h"

#include <filesystem>

namespace knead {

/// What LAMMPS computes.
enum class LammpsWork {
    bondsAndContacts, ///< bonds, and damping and Coulomb friction between all spheres that touch, bonded ones too: as the paper
    bondsAlone, ///< bonds without damping, and repulsion between spheres that are not bonded: the least it can do
};

/// Steps a bar with the installed `lmp`, in MPI processes if there are several, and returns the seconds per step that it
/// reports. The input is written into a folder.
/// @throws std::runtime_error when it did not run to its end
double lammpsStepTime(const PeerBar& bar, LammpsWork work, int processes, int steps,
                      const std::filesystem::path& folder);

} // namespace knead
