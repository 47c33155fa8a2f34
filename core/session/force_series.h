#pragma once

#include "core/simulation/reaction.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace knead {

/// Forces and moments of fixtures, tools and loads over the time of a run: a row per frame, each the mean over the steps since
/// the row before, weighted with their durations.
class ForceSeries {
public:
    struct Row {
        Vec3 force = Vec3::Zero();  ///< [N]
        Vec3 moment = Vec3::Zero(); ///< [N m]
    };
    struct Curve {
        Reaction::Kind kind = Reaction::Kind::fixture;
        std::uint32_t id = 0;
        std::string name;
        Vec3 about = Vec3::Zero();            ///< the point of its moments, as last seen [m]
        std::vector<std::optional<Row>> rows; ///< none: it was not there
        std::optional<Row> last;              ///< the last there was
        double peakForce = 0;                 ///< of the rows [N]
        double peakMoment = 0;                ///< [N m]
    };

    ForceSeries() = default;
    /// @param centers points that the moments of fixtures are about instead of their middles, by name [m]
    explicit ForceSeries(std::map<std::string, Vec3> centers);

    /// What a step did. @param time at its end [s]; before the time of the last step: all begins anew
    void add(const std::vector<Reaction>& reactions, double time);

    /// Ends the row of the steps since the last one, if there were any.
    void endRow();

    /// A row by itself.
    void addRow(const std::vector<Reaction>& reactions, double time);

    const std::vector<double>& times() const { return m_times; } ///< ends of the rows [s]
    const std::vector<Curve>& curves() const { return m_curves; }

    /// The first column is `time [s]`; then six of each curve, `NAME Fx [N]` to `NAME Mz [N m]`. Fields are empty where there is
    /// nothing.
    std::string csv() const;

private:
    struct Sum {
        Row row;
        double duration = 0;
    };
    std::size_t curveOf(const Reaction& reaction);

    std::map<std::string, Vec3> m_centers;
    std::vector<double> m_times;
    std::vector<Curve> m_curves; ///< in the order of coming up
    std::map<std::pair<Reaction::Kind, std::uint32_t>, std::size_t> m_indexOf;
    std::vector<Sum> m_sums; ///< per curve, of the row under way
    double m_time = 0;
    double m_rowBegin = 0;
};

} // namespace knead
