#include "core/session/probe_series.h"

#include "core/message/message.h"
#include "core/model/file_names.h"
#include "core/session/csv.h"

namespace knead {

ProbeSeries::ProbeSeries(const Recipe& recipe, const RecipeScene& ready, TaskControl& control)
{
    FilledBodies filled(ready.parts().size());
    for (std::size_t i = 0; i < recipe.probes.size(); ++i) {
        const RecipeProbe& probe = recipe.probes[i];
        TaskPortion portion = TaskPortion::ofItem(control, i, recipe.probes.size());
        const Message who = aboutFile(recipe.file, Message("Recipe", "the probe \"%1\"").with(probe.name));
        FilledBodies named(filled.size());
        for (const BodyId id : bodiesNamed(probe.body, ready.parts(), who)) {
            if (!filled[id])
                filled[id] =
                    filledBody(*ready.model, id, ready.parts()[id].name, ready.scene.bodies[id].aggregate, portion);
            named[id] = filled[id];
        }
        const std::optional<SkinPlace> place = nearestPlace(probe.place, named);
        if (!place)
            throw UnusableInput(Message("Recipe", "%1 lies far away from all bodies; its place is in mm.").with(who));
        m_places.push_back(probePlace(*place, filled));
        m_curves.push_back({probe.name, {}});
    }
}

void ProbeSeries::add(const Snapshot& snapshot)
{
    const std::vector<ProbeSample> samples = readProbes(m_places, snapshot, true);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        std::vector<ProbeSample>& known = m_curves[i].samples;
        while (!known.empty() && known.back().time >= samples[i].time)
            known.pop_back();
        known.push_back(samples[i]);
    }
}

std::string csvOf(const std::vector<ProbeCurve>& curves)
{
    std::string text = "time [s]";
    for (const ProbeCurve& curve : curves)
        for (const char* quantity :
             {" displacement [mm]", " equivalent strain [-]", " von Mises stress [MPa]", " tool force [N]"})
            text += ',' + csvField(curve.name + quantity);
    text += '\n';
    for (std::size_t row = 0; !curves.empty() && row < curves.front().samples.size(); ++row) {
        text += csvNumber(curves.front().samples[row].time);
        for (const ProbeCurve& curve : curves) {
            const ProbeSample& sample = curve.samples[row];
            for (const double value : {1e3 * sample.displacement, sample.strain, 1e-6 * sample.stress, sample.force})
                text += ',' + csvNumber(value);
        }
        text += '\n';
    }
    return text;
}

} // namespace knead
