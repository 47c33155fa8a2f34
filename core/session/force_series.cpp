#include "core/session/force_series.h"

#include "core/session/csv.h"

#include <algorithm>
#include <set>

namespace knead {

ForceSeries::ForceSeries(std::map<std::string, Vec3> centers)
    : m_centers(std::move(centers))
{
}

std::size_t ForceSeries::curveOf(const Reaction& reaction)
{
    const auto [place, isNew] = m_indexOf.try_emplace({reaction.kind, reaction.id}, m_curves.size());
    if (isNew) {
        m_curves.push_back({.kind = reaction.kind, .id = reaction.id, .name = {}, .rows = {}, .last = {}});
        m_sums.emplace_back();
    }
    return place->second;
}

void ForceSeries::add(const std::vector<Reaction>& reactions, double time)
{
    if (time <= m_time) // after a reset
        *this = ForceSeries(std::move(m_centers));
    const double duration = std::max(0.0, time - m_time);
    m_time = time;
    for (const Reaction& reaction : reactions) {
        const std::size_t index = curveOf(reaction);
        Curve& curve = m_curves[index];
        Sum& sum = m_sums[index];
        curve.name = reaction.name;
        const auto center = m_centers.find(reaction.name);
        const bool isShifted = reaction.kind == Reaction::Kind::fixture && center != m_centers.end();
        curve.about = isShifted ? center->second : reaction.about;
        sum.row.force += duration * reaction.force;
        sum.row.moment += duration * reaction.momentAbout(curve.about);
        sum.duration += duration;
    }
}

void ForceSeries::endRow()
{
    if (m_time <= m_rowBegin)
        return;
    m_rowBegin = m_time;
    m_times.push_back(m_time);
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        Curve& curve = m_curves[i];
        curve.rows.resize(m_times.size());
        const Sum& sum = m_sums[i];
        if (sum.duration <= 0)
            continue;
        const Row row{sum.row.force / sum.duration, sum.row.moment / sum.duration};
        curve.rows.back() = curve.last = row;
        curve.peakForce = std::max(curve.peakForce, row.force.norm());
        curve.peakMoment = std::max(curve.peakMoment, row.moment.norm());
        m_sums[i] = {};
    }
}

void ForceSeries::addRow(const std::vector<Reaction>& reactions, double time)
{
    add(reactions, time);
    endRow();
}

std::string ForceSeries::csv() const
{
    std::string text = "time [s]";
    std::set<std::string> taken;
    for (const Curve& curve : m_curves) {
        std::string name = curve.name;
        for (int i = 2; !taken.insert(name).second; ++i)
            name = curve.name + ' ' + std::to_string(i);
        for (const char* part : {"Fx [N]", "Fy [N]", "Fz [N]", "Mx [N m]", "My [N m]", "Mz [N m]"})
            text += ',' + csvField(name + ' ' + part);
    }
    text += '\n';
    for (std::size_t r = 0; r < m_times.size(); ++r) {
        text += csvNumber(m_times[r]);
        for (const Curve& curve : m_curves) {
            const std::optional<Row> row = r < curve.rows.size() ? curve.rows[r] : std::nullopt;
            for (Eigen::Index axis = 0; axis < 6; ++axis)
                text += ',' + (row ? csvNumber(axis < 3 ? row->force[axis] : row->moment[axis - 3]) : std::string());
        }
        text += '\n';
    }
    return text;
}

} // namespace knead
