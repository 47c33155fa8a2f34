#pragma once

#include "core/session/probe_readings.h"
#include "core/session/recipe_scene.h"

#include <string>
#include <vector>

namespace knead {

/// What a probe read over the time of a run; those of a recipe at the same times.
struct ProbeCurve {
    std::string name;
    std::vector<ProbeSample> samples;
};

/// The first column is `time [s]`; then four of each probe: `NAME displacement [mm]`, `NAME equivalent strain [-]`,
/// `NAME von Mises stress [MPa]`, `NAME tool force [N]`. Fields are empty where nothing is known.
std::string csvOf(const std::vector<ProbeCurve>& curves);

/// The probes of a recipe, read while it runs. One thread.
class ProbeSeries {
public:
    ProbeSeries() = default;
    /// Prepares the skins of the bodies that have probes, which takes the longer the more objects they have.
    /// @throws UnusableInput when a probe names a body that is not there, or lies far away from all; Cancelled
    ProbeSeries(const Recipe& recipe, const RecipeScene& ready, TaskControl& control);

    /// A row. What was read at this time or later is forgotten: the recipe began again.
    void add(const Snapshot& snapshot);

    bool isEmpty() const { return m_curves.empty(); }
    const std::vector<ProbeCurve>& curves() const { return m_curves; }

private:
    std::vector<ProbePlace> m_places;
    std::vector<ProbeCurve> m_curves;
};

} // namespace knead
