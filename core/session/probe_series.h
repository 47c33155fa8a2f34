#pragma once

#include "core/session/probe_readings.h"
#include "core/session/recipe_scene.h"

#include <string>
#include <vector>

namespace knead {

/// What the probes of a recipe read over the time of a run. One thread.
class ProbeSeries {
public:
    struct Curve {
        std::string name;
        std::vector<ProbeSample> samples; ///< of all at the same times
    };

    ProbeSeries() = default;
    /// Prepares the skins of the bodies, which takes the longer the more objects there are.
    /// @throws UnusableInput when a probe names a body that is not there; Cancelled
    ProbeSeries(const Recipe& recipe, const RecipeScene& ready, TaskControl& control);

    void add(const Snapshot& snapshot);

    bool isEmpty() const { return m_curves.empty(); }
    const std::vector<Curve>& curves() const { return m_curves; }

    /// The first column is `time [s]`; then four of each probe: `NAME displacement [mm]`, `NAME equivalent strain [-]`,
    /// `NAME von Mises stress [MPa]`, `NAME tool force [N]`. Fields are empty where nothing is known.
    std::string csv() const;

private:
    std::vector<ProbePlace> m_places;
    std::vector<Curve> m_curves;
};

} // namespace knead
