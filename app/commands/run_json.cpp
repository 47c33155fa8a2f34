#include "app/commands/run_json.h"

#include "io/export/job_file.h"

#include "app/commands/force_report.h"
#include "app/hexadecimal.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace knead {

namespace {

nlohmann::ordered_json list(const Vec3& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

nlohmann::ordered_json qualityOf(const RunReport& report)
{
    const RunQuality& quality = report.quality;
    const double cells = report.fineness.cellsAcrossWall;
    nlohmann::ordered_json json{
        {"penetration_spacings", quality.penetration}, {"imbalance_share", quality.imbalance},
        {"added_mass_share", quality.addedMass},       {"steps_not_converged", quality.unsolvedSteps},
        {"cells_across_thinnest_wall", nullptr},       {"wall_bending_too_stiff_share", nullptr}};
    if (cells > 0)
        json["cells_across_thinnest_wall"] = cells;
    if (const double error = bendingErrorOf(cells); std::isfinite(error))
        json["wall_bending_too_stiff_share"] = error;
    return json;
}

const char* wordFor(Trouble trouble)
{
    switch (trouble) {
    case Trouble::notANumber:
        return "not-a-number";
    case Trouble::runaway:
        return "runaway";
    case Trouble::energy:
        return "energy";
    case Trouble::unsolved:
        return "unsolved";
    case Trouble::squashed:
        return "squashed";
    case Trouble::longStep:
        return "long-step";
    case Trouble::failed:
    case Trouble::none:
        break;
    }
    return "failed";
}

} // namespace

namespace {

/// What is not known is null.
nlohmann::ordered_json jsonOf(const ProbeCurve& probe)
{
    nlohmann::ordered_json json{{"name", probe.name}};
    if (probe.samples.empty())
        return json;
    const ProbeSample& last = probe.samples.back();
    json["displacement_mm"] = 1000 * last.displacement;
    json["equivalent_strain"] = last.strain;
    json["von_mises_pa"] = last.stress;
    json["tool_force_n"] = last.force;
    const auto peak = [&](double ProbeSample::*value) {
        double most = ProbeSample::unknown;
        for (const ProbeSample& sample : probe.samples)
            most = std::fmax(most, sample.*value);
        return most;
    };
    json["peak_displacement_mm"] = 1000 * peak(&ProbeSample::displacement);
    json["peak_von_mises_pa"] = peak(&ProbeSample::stress);
    return json;
}

} // namespace

nlohmann::ordered_json jsonOf(const RunReport& report)
{
    const EnergyLedger& energy = report.energy;
    nlohmann::ordered_json json{
        {"objects", report.objects},
        {"connections", report.connections},
        {"broken", report.broken},
        {"refills", report.refills},
        {"joints", report.joints},
        {"components", report.components},
        {"added_mass", report.addedMass},
        {"steps", report.steps},
        {"time_step_s", report.timeStep},
        {"simulated_s", report.simulated},
        {"wall_s", report.wall},
        {"ratio", report.ratio()},
        {"state_hash", hexadecimal(report.stateHash)},
        {"integrator", report.integrator},
        {"energy_j",
         {{"kinetic", energy.kinetic},
          {"elastic", energy.elastic},
          {"gravity", energy.gravity},
          {"contact", energy.contact},
          {"tool_work", energy.toolWork},
          {"viscous", energy.viscous},
          {"friction", energy.friction},
          {"plastic", energy.plastic},
          {"fracture", energy.fracture},
          {"numerical", energy.numerical},
          {"imbalance", energy.imbalance}}},
        {"bodies", nlohmann::ordered_json::array()},
        {"tools", nlohmann::ordered_json::array()},
        {"files", report.files},
        {"quality", qualityOf(report)},
        {"warnings", report.warnings},
    };
    for (const BodyMotion& motion : report.motions)
        json["bodies"].push_back({{"name", motion.name},
                                  {"mean_displacement_mm", list(1000 * motion.meanDisplacement)},
                                  {"largest_displacement_mm", 1000 * motion.largestDisplacement},
                                  {"von_mises_stress",
                                   {{"largest_pa", motion.stress.largest},
                                    {"error_share", motion.stress.error},
                                    {"at_rest_mm", list(1000 * motion.stress.place)}}}});
    for (const ToolState& tool : report.tools)
        json["tools"].push_back({{"name", tool.name},
                                 {"force_n", list(tool.force)},
                                 {"peak_force_n", tool.peakForce},
                                 {"torque_nm", list(tool.torque)}});
    addForces(json, report);
    for (const ProbeCurve& probe : report.probes)
        json["probes"].push_back(jsonOf(probe));
    if (!report.probesFile.empty())
        json["probes_csv"] = report.probesFile;
    json["exports"] = nlohmann::ordered_json::array();
    for (const ExportReport& exported : report.exports)
        json["exports"].push_back(nlohmann::ordered_json::parse(reportToJson(exported)));
    if (!report.failure.empty())
        json["failure"] = {{"kind", wordFor(report.trouble)}, {"sentence", report.failure}};
    return json;
}

} // namespace knead
