#include "app/commands/morph_report.h"

#include "app/commands/command_output.h"
#include "core/model/file_names.h"
#include "core/model/number_words.h"
#include "io/export/job_file.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <numbers>

namespace knead {

namespace {

using Json = nlohmann::ordered_json;

constexpr double mmPerMetre = 1e3;
constexpr std::array numberKindNames{"bend", "twist", "taper", "stretch", "shear", "scale"};

const char* numberKindName(NumberKind kind)
{
    return numberKindNames.at(static_cast<std::size_t>(kind));
}

/// "90 degrees", "factor 1.2", "3 mm"
std::string amountOf(const NumberDeformation& d)
{
    std::array<char, 48> text{};
    switch (d.kind) {
    case NumberKind::bend:
    case NumberKind::twist:
        std::snprintf(text.data(), text.size(), "by %.6g degrees", d.angle * 180 / std::numbers::pi);
        break;
    case NumberKind::taper:
    case NumberKind::stretch:
    case NumberKind::scale:
        std::snprintf(text.data(), text.size(), "by a factor of %.6g", d.factor);
        break;
    case NumberKind::shear:
        std::snprintf(text.data(), text.size(), "by %.6g mm", mmPerMetre * d.shift);
        break;
    }
    return text.data();
}

void print(const NumberDeformation& d)
{
    std::printf("%s %s from %.6g to %.6g mm along %.4g,%.4g,%.4g\n", numberKindName(d.kind), amountOf(d).c_str(),
                mmPerMetre * d.from, mmPerMetre * d.to, d.axis.x(), d.axis.y(), d.axis.z());
}

void print(const DeformationPlan::Source& source, const FieldDeformation& field)
{
    const FieldFile& file = source.file;
    std::printf("%s: %s", shortName(file.path).c_str(), file.format.c_str());
    if (!file.name.empty())
        std::printf(", %s", file.name.c_str());
    if (file.steps.size() > 1)
        std::printf(", step %zu of %zu (%s)", file.step + 1, file.steps.size(), file.steps.at(file.step).c_str());
    std::printf(", %zu nodes%s, at most %s; factor %.6g\n", source.nodes,
                file.unit.empty() ? "" : (" in " + file.unit).c_str(), lengthWords(source.largest).c_str(),
                field.factor);
}

Json toJson(const Vec3& place, double scale = mmPerMetre)
{
    return {scale * place.x(), scale * place.y(), scale * place.z()};
}

Json toJson(const NumberDeformation& d)
{
    Json json{{"kind", numberKindName(d.kind)},
              {"axis", toJson(d.axis, 1)},
              {"side", toJson(d.side, 1)},
              {"origin_mm", toJson(d.origin)},
              {"from_mm", mmPerMetre * d.from},
              {"to_mm", mmPerMetre * d.to},
              {"stays", d.stays},
              {"ease", d.eases}};
    switch (d.kind) {
    case NumberKind::bend:
        json["neutral_mm"] = mmPerMetre * d.neutral;
        [[fallthrough]];
    case NumberKind::twist:
        json["angle_deg"] = d.angle * 180 / std::numbers::pi;
        break;
    case NumberKind::taper:
    case NumberKind::stretch:
    case NumberKind::scale:
        json["factor"] = d.factor;
        break;
    case NumberKind::shear:
        json["shift_mm"] = mmPerMetre * d.shift;
        break;
    }
    return json;
}

Json toJson(const DeformationPlan::Source& source, const FieldDeformation& field, const FieldWish& wish)
{
    Json locked = Json::array();
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (field.locked.at(axis))
            locked.push_back(std::string(1, "xyz"[axis]));
    return {{"kind", "field"},
            {"file", source.file.path},
            {"format", source.file.format},
            {"component", source.file.name},
            {"step", source.file.step + 1},
            {"steps", source.file.steps},
            {"unit", source.file.unit},
            {"nodes", source.nodes},
            {"largest_mm", mmPerMetre * source.largest},
            {"factor", field.factor},
            {"keep_faces", wish.kept},
            {"fade_mm", mmPerMetre * field.fade},
            {"lock", locked},
            {"node_spacing_mm", mmPerMetre * source.fit.spacing},
            {"uncovered_share", source.fit.uncovered},
            {"farthest_from_nodes_mm", mmPerMetre * source.fit.farthest.value},
            {"smallest_determinant", source.fit.determinant.value},
            {"rough_share", source.fit.roughness}};
}

} // namespace

void printMorph(const MorphReport& report)
{
    const std::vector<Deformation>& deformations = *report.plan.deformations;
    for (std::size_t i = 0; i < deformations.size(); ++i)
        if (const auto* number = std::get_if<NumberDeformation>(&deformations[i]))
            print(*number);
        else
            print(*report.plan.sources[i], std::get<FieldDeformation>(deformations[i]));
    for (std::size_t p = 0; p < report.model.parts.size(); ++p)
        if (const std::optional<SurfaceMove>& move = report.plan.moves[p]) {
            const Vec3 where = mmPerMetre * move->where;
            std::printf("%s: moved by %s at most, near %.4g, %.4g, %.4g mm, and by %s in the mean\n",
                        report.model.parts[p].name.c_str(), lengthWords(move->largest).c_str(), where.x(), where.y(),
                        where.z(), lengthWords(move->mean).c_str());
        }
    printWritten({}, {report.written});
}

nlohmann::ordered_json jsonOf(const MorphReport& report)
{
    const std::vector<Deformation>& deformations = *report.plan.deformations;
    Json json{{"file", report.model.file},
              {"output", report.written.file},
              {"deformations", Json::array()},
              {"parts", Json::array()},
              {"remarks", Json::array()},
              {"sound", report.written.isSound()},
              {"export", Json::parse(reportToJson(report.written))}};
    for (std::size_t i = 0; i < deformations.size(); ++i)
        if (const auto* number = std::get_if<NumberDeformation>(&deformations[i]))
            json["deformations"].push_back(toJson(*number));
        else
            json["deformations"].push_back(toJson(*report.plan.sources[i], std::get<FieldDeformation>(deformations[i]),
                                                  std::get<FieldWish>(report.wishes[i])));
    for (std::size_t p = 0; p < report.model.parts.size(); ++p) {
        const std::optional<SurfaceMove>& move = report.plan.moves[p];
        json["parts"].push_back({{"name", report.model.parts[p].name},
                                 {"path", report.model.parts[p].path},
                                 {"is_deformed", move.has_value()},
                                 {"largest_displacement_mm", move ? mmPerMetre * move->largest : 0},
                                 {"largest_displacement_near_mm", move ? toJson(move->where) : Json(nullptr)},
                                 {"mean_displacement_mm", move ? mmPerMetre * move->mean : 0}});
    }
    for (const Message& remark : report.plan.remarks)
        json["remarks"].push_back(remark.english());
    return json;
}

} // namespace knead
