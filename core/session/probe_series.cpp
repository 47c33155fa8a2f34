#include "core/session/probe_series.h"

#include "core/document/project.h"
#include "core/model/file_names.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace knead {

ProbeSeries::ProbeSeries(const Recipe& recipe, const RecipeScene& ready, TaskControl& control)
{
    if (recipe.probes.empty())
        return;
    std::vector<std::size_t> partOfBody(ready.parts().size());
    std::iota(partOfBody.begin(), partOfBody.end(), std::size_t{0});
    const FilledBodies all =
        contentOf(ready.model, {}, {.scene = ready.scene, .partOfBody = std::move(partOfBody)}, control).bodies;
    for (const RecipeProbe& probe : recipe.probes) {
        const std::vector<BodyId> ids = bodiesNamed(
            probe.body, ready.parts(), aboutFile(recipe.file, Message("Recipe", "the probe \"%1\"").with(probe.name)));
        FilledBodies bodies;
        for (const BodyId id : ids)
            bodies.push_back(all[id]);
        SkinPlace place = nearestPlace(probe.place, bodies);
        place.body = ids[place.body];
        m_places.push_back(probePlace(place, all));
        m_curves.push_back({probe.name, {}});
    }
}

void ProbeSeries::add(const Snapshot& snapshot)
{
    const std::vector<ProbeSample> samples = readProbes(m_places, snapshot, true);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        std::vector<ProbeSample>& known = m_curves[i].samples;
        while (!known.empty() && known.back().time >= samples[i].time) // the recipe began again
            known.pop_back();
        known.push_back(samples[i]);
    }
}

std::string ProbeSeries::csv() const
{
    std::ostringstream text;
    text.precision(8);
    text << "time [s]";
    for (const Curve& curve : m_curves)
        text << ',' << curve.name << " displacement [mm]," << curve.name << " equivalent strain [-]," << curve.name
             << " von Mises stress [MPa]," << curve.name << " tool force [N]";
    text << '\n';
    const std::size_t rows = m_curves.empty() ? 0 : m_curves.front().samples.size();
    for (std::size_t row = 0; row < rows; ++row) {
        text << m_curves.front().samples[row].time;
        for (const Curve& curve : m_curves) {
            const ProbeSample& sample = curve.samples[row];
            for (const double value : {1e3 * sample.displacement, sample.strain, 1e-6 * sample.stress, sample.force}) {
                text << ',';
                if (std::isfinite(value))
                    text << value;
            }
        }
        text << '\n';
    }
    return text.str();
}

} // namespace knead
