#include "app/commands/force_report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace knead {

namespace {

nlohmann::ordered_json listOf(const Vec3& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

nlohmann::ordered_json jsonOf(const ForceSeries::Curve& curve)
{
    const ForceSeries::Row last = curve.last.value_or(ForceSeries::Row{});
    return {{"name", curve.name},
            {"force_n", listOf(last.force)},
            {"peak_force_n", curve.peakForce},
            {"moment_nm", listOf(last.moment)},
            {"peak_moment_nm", curve.peakMoment},
            {"moment_center_mm", listOf(1000 * curve.about)}};
}

const char* wordFor(Reaction::Kind kind)
{
    return kind == Reaction::Kind::load ? "load" : "fixture";
}

} // namespace

void addForces(nlohmann::ordered_json& json, const RunReport& report)
{
    json["fixtures"] = nlohmann::ordered_json::array();
    json["loads"] = nlohmann::ordered_json::array();
    for (const ForceSeries::Curve& curve : report.forces.curves()) {
        if (curve.kind == Reaction::Kind::tool) {
            for (std::size_t i = 0; i < report.tools.size(); ++i)
                if (report.tools[i].id == curve.id)
                    json["tools"][i]["peak_torque_nm"] = curve.peakMoment;
        } else {
            json[curve.kind == Reaction::Kind::load ? "loads" : "fixtures"].push_back(jsonOf(curve));
        }
    }
    if (!report.forcesFile.empty())
        json["forces_csv"] = report.forcesFile;
    if (report.balances.empty())
        return;
    json["static"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < report.balances.size(); ++i)
        json["static"].push_back({{"time_s", report.forces.times()[i]},
                                  {"residual", report.balances[i].residual},
                                  {"iterations", report.balances[i].iterations},
                                  {"parts", report.balances[i].parts}});
}

void printForces(const RunReport& report)
{
    for (const ForceSeries::Curve& curve : report.forces.curves()) {
        if (curve.kind == Reaction::Kind::tool || !curve.last)
            continue;
        const Vec3& force = curve.last->force;
        const Vec3& moment = curve.last->moment;
        std::printf("%s %s: force (%.3g, %.3g, %.3g) N, moment (%.3g, %.3g, %.3g) N m, peaks %.3g N, %.3g N m\n",
                    wordFor(curve.kind), curve.name.c_str(), force.x(), force.y(), force.z(), moment.x(), moment.y(),
                    moment.z(), curve.peakForce, curve.peakMoment);
    }
    if (!report.balances.empty()) {
        const auto worst = std::max_element(report.balances.begin(), report.balances.end(),
                                            [](const auto& a, const auto& b) { return a.residual < b.residual; });
        std::printf("%zu load steps in balance; forces left are %.1e of those that act, or less\n",
                    report.balances.size(), worst->residual);
    }
    if (!report.forcesFile.empty())
        std::printf("wrote %s\n", report.forcesFile.c_str());
    for (const ProbeCurve& probe : report.probes)
        if (!probe.samples.empty()) {
            const ProbeSample& last = probe.samples.back();
            std::printf("probe %s: moved %.4g mm", probe.name.c_str(), 1000 * last.displacement);
            if (std::isfinite(last.strain))
                std::printf(", strain %.3g", last.strain);
            if (std::isfinite(last.stress))
                std::printf(", stress %.4g Pa", last.stress);
            std::printf("\n");
        }
    if (!report.probesFile.empty())
        std::printf("wrote %s\n", report.probesFile.c_str());
}

} // namespace knead
