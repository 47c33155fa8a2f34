#include "io/export/job_file.h"

#include "core/message/message.h"
#include "core/skin/former_shape.h"
#include "io/export/deformation_bytes.h"
#include "io/files/byte_blocks.h"
#include "io/json/message_json.h"
#include "io/project/aggregate_bytes.h"
#include "io/worker/model_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace knead {

namespace {

using Json = nlohmann::json;

/// Which connections an object has, a bit for each direction.
std::vector<std::uint16_t> connectionsOf(const Aggregate& aggregate)
{
    std::vector<std::uint16_t> bits(aggregate.size(), 0);
    for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
        for (std::size_t i = 0; i < aggregate.weight[d].size(); ++i)
            if (aggregate.weight[d][i] > 0)
                bits[i] = static_cast<std::uint16_t>(bits[i] | 1U << d);
    return bits;
}

void addAggregate(const Aggregate& aggregate, BlockWriter& blocks)
{
    addLattice(aggregate.lattice, blocks);
    blocks.add(connectionsOf(aggregate));
}

std::shared_ptr<Aggregate> nextJobAggregate(BlockReader& blocks)
{
    auto aggregate = std::make_shared<Aggregate>();
    aggregate->lattice = nextLattice(blocks);
    const std::vector<std::uint16_t> bits = blocks.nextArray<std::uint16_t>();
    if (bits.size() != aggregate->size())
        blocks.fail("not every object has its connections");
    for (std::size_t d = 0; d < Lattice::isotropicCount; ++d) {
        aggregate->weight[d].resize(bits.size());
        for (std::size_t i = 0; i < bits.size(); ++i)
            aggregate->weight[d][i] = bits[i] >> d & 1U;
    }
    return aggregate;
}

/// How many former shapes an aggregate has.
int stagesOf(const Aggregate* aggregate)
{
    return aggregate != nullptr && aggregate->former ? aggregate->former->stages() : 0;
}

/// @return null: none
std::shared_ptr<const FormerShape> nextFormer(BlockReader& blocks, int stages)
{
    if (stages == 0)
        return nullptr;
    if (stages > FormerShape::mostStages)
        blocks.fail("a part has too many former shapes");
    const std::shared_ptr<Aggregate> carriers = nextJobAggregate(blocks);
    std::vector<Vec3> displacements = blocks.nextArray<Vec3>();
    carriers->former = nextFormer(blocks, stages - 1);
    return std::make_shared<const FormerShape>(carriers, std::move(displacements));
}

Json toJson(const ExportOptions& options)
{
    return {{"unit", options.unit},
            {"tolerance", options.tolerance},
            {"ap214", options.useAp214},
            {"text", options.isText}};
}

ExportOptions optionsFrom(const Json& json)
{
    return {.unit = json.at("unit").get<std::string>(),
            .tolerance = json.at("tolerance").get<double>(),
            .useAp214 = json.at("ap214").get<bool>(),
            .isText = json.at("text").get<bool>()};
}

const std::map<PartExportReport::Form, std::string>& formNames()
{
    static const std::map<PartExportReport::Form, std::string> names{{PartExportReport::Form::exact, "smooth faces"},
                                                                     {PartExportReport::Form::faceted, "flat faces"},
                                                                     {PartExportReport::Form::mesh, "mesh"}};
    return names;
}

Json toJson(const PartExportReport& part)
{
    Json json{
        {"name", part.name},
        {"form", formNames().at(part.form)},
        {"reason", toJson(part.reason)},
        {"remarks", toJson(part.remarks)},
        {"sound", part.isSound()},
        {"solids", {{"before", part.solidsBefore}, {"after", part.solidsAfter}}},
        {"faces", {{"before", part.facesBefore}, {"after", part.facesAfter}, {"kept", part.keptFaces}}},
        {"edges", {{"before", part.edgesBefore}, {"after", part.edgesAfter}}},
        {"volume_m3", {{"rest", part.restVolume}, {"skin", part.skinVolume}, {"file", part.volume}}},
        {"density_kg_per_m3", part.density},
        {"von_mises_stress", {{"largest_pa", part.largestStress}, {"error_share", part.stressErrorShare}}},
        {"valid", part.valid},
        {"was_closed", part.wasClosed},
        {"closed", part.closed},
        {"free_edges", part.freeEdges},
        {"largest_tolerance_m", part.maxTolerance},
        {"deviation_m",
         {{"allowed", part.tolerance},
          {"largest", part.largestDeviation},
          {"mean", part.meanDeviation},
          {"samples", part.samples}}},
        {"smooth_edges", {{"count", part.smoothEdges}, {"largest_kink_rad", part.largestKink}}},
        {"crosses_itself", part.crossesItself},
        {"flat_faces",
         {{"count", part.flatFaces}, {"allowed_m", part.flatTolerance}, {"largest_m", part.largestFlatDeviation}}},
        {"name_kept", part.nameKept},
        {"colors_kept", part.colorsKept}};
    if (part.fold)
        json["fold_near_m"] = {part.fold->x(), part.fold->y(), part.fold->z()};
    return json;
}

PartExportReport partFrom(const Json& json)
{
    PartExportReport part;
    part.name = json.at("name").get<std::string>();
    for (const auto& [form, name] : formNames())
        if (json.at("form") == name)
            part.form = form;
    part.reason = messageFrom(json.at("reason"));
    part.remarks = messagesFrom(json.at("remarks"));
    part.solidsBefore = json.at("solids").at("before").get<int>();
    part.solidsAfter = json.at("solids").at("after").get<int>();
    part.facesBefore = json.at("faces").at("before").get<int>();
    part.facesAfter = json.at("faces").at("after").get<int>();
    part.keptFaces = json.at("faces").at("kept").get<int>();
    part.edgesBefore = json.at("edges").at("before").get<int>();
    part.edgesAfter = json.at("edges").at("after").get<int>();
    part.restVolume = json.at("volume_m3").at("rest").get<double>();
    part.skinVolume = json.at("volume_m3").at("skin").get<double>();
    part.volume = json.at("volume_m3").at("file").get<double>();
    part.density = json.at("density_kg_per_m3").get<double>();
    part.largestStress = json.at("von_mises_stress").at("largest_pa").get<double>();
    part.stressErrorShare = json.at("von_mises_stress").at("error_share").get<double>();
    part.valid = json.at("valid").get<bool>();
    part.wasClosed = json.at("was_closed").get<bool>();
    part.closed = json.at("closed").get<bool>();
    part.freeEdges = json.at("free_edges").get<std::size_t>();
    part.maxTolerance = json.at("largest_tolerance_m").get<double>();
    part.tolerance = json.at("deviation_m").at("allowed").get<double>();
    part.largestDeviation = json.at("deviation_m").at("largest").get<double>();
    part.meanDeviation = json.at("deviation_m").at("mean").get<double>();
    part.samples = json.at("deviation_m").at("samples").get<std::size_t>();
    part.smoothEdges = json.at("smooth_edges").at("count").get<std::size_t>();
    part.largestKink = json.at("smooth_edges").at("largest_kink_rad").get<double>();
    part.crossesItself = json.at("crosses_itself").get<bool>();
    part.flatFaces = json.at("flat_faces").at("count").get<int>();
    part.flatTolerance = json.at("flat_faces").at("allowed_m").get<double>();
    part.largestFlatDeviation = json.at("flat_faces").at("largest_m").get<double>();
    part.nameKept = json.at("name_kept").get<bool>();
    part.colorsKept = json.at("colors_kept").get<bool>();
    if (const auto fold = json.find("fold_near_m"); fold != json.end())
        part.fold = Vec3(fold->at(0).get<double>(), fold->at(1).get<double>(), fold->at(2).get<double>());
    return part;
}

std::string documentOf(const ExportReport& report)
{
    Json json{{"file", report.file},
              {"format", report.format},
              {"unit", report.unit},
              {"bytes", report.bytes},
              {"seconds", report.seconds},
              {"sound", report.isSound()},
              {"warnings", toJson(report.warnings)},
              {"parts", Json::array()}};
    for (const PartExportReport& part : report.parts)
        json["parts"].push_back(toJson(part));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void sayInEnglish(Message& sentence)
{
    sentence = Message::verbatim(sentence.english());
}

void addSlit(const KnifeSlit& slit, BlockWriter& blocks)
{
    blocks.add(std::vector<Vec3>{slit.origin, slit.opening, slit.along});
    blocks.add(std::vector<double>{slit.length, slit.halfTip, slit.hasTip ? 1.0 : 0.0, slit.spacing});
    blocks.add(slit.lipOfObject);
}

KnifeSlit nextSlit(BlockReader& blocks)
{
    const auto frame = blocks.nextArray<Vec3>();
    const auto numbers = blocks.nextArray<double>();
    if (frame.size() != 3 || numbers.size() != 4)
        throw Problem(Message::verbatim("export job: a slit is not whole"));
    return {.origin = frame[0],
            .opening = frame[1],
            .along = frame[2],
            .length = numbers[0],
            .halfTip = numbers[1],
            .hasTip = numbers[2] > 0,
            .spacing = numbers[3],
            .lipOfObject = blocks.nextArray<std::uint8_t>()};
}

} // namespace

std::string jobToBytes(const ExportJob& job)
{
    BlockWriter blocks;
    Model model;
    model.tree = job.tree;
    Json parts = Json::array();
    DeformationLists lists;
    for (const PartToExport& part : job.parts) {
        model.parts.push_back(part.part);
        parts.push_back({{"density", part.density},
                         {"reason", toJson(part.reason)},
                         {"remarks", toJson(part.remarks)},
                         {"sheets", part.cut ? part.cut->sheets.size() : 0},
                         {"spacing", part.cut ? part.cut->spacing : 0},
                         {"hasSlit", part.slit != nullptr},
                         {"deformations", lists.add(part.deformations)},
                         {"before", part.before ? Json{{"volume", part.before->volume},
                                                       {"faces", part.before->faces},
                                                       {"edges", part.before->edges}}
                                                : Json{}},
                         {"hasObjects", part.aggregate != nullptr},
                         {"formers", stagesOf(part.aggregate.get())}});
    }
    blocks.add(std::string_view(
        Json{{"options", toJson(job.options)}, {"parts", parts}}.dump(-1, ' ', false, Json::error_handler_t::replace)));
    blocks.add(std::string_view(modelToBytes(model)));
    lists.write(blocks);
    for (const PartToExport& part : job.parts) {
        if (part.cut) {
            for (const std::vector<Vec3>& sheet : part.cut->sheets)
                blocks.add(sheet);
            blocks.add(part.cut->inside);
            blocks.add(part.cut->outside);
        }
        if (part.slit)
            addSlit(*part.slit, blocks);
        if (part.aggregate != nullptr) {
            addAggregate(*part.aggregate, blocks);
            blocks.add(part.displacements);
            for (const Aggregate* filling = part.aggregate.get(); filling->former;
                 filling = filling->former->carriers().get()) {
                addAggregate(*filling->former->carriers(), blocks);
                blocks.add(filling->former->displacements());
            }
        }
    }
    return std::move(blocks).bytes();
}

ExportJob jobFromBytes(std::string_view bytes)
{
    try {
        BlockReader blocks(bytes, "export job");
        const Json json = Json::parse(blocks.next());
        Model model = modelFromBytes(blocks.next());
        const DeformationLists lists(blocks);
        ExportJob job;
        job.options = optionsFrom(json.at("options"));
        job.tree = std::move(model.tree);
        for (std::size_t i = 0; i < model.parts.size(); ++i) {
            PartToExport& part = job.parts.emplace_back();
            part.part = std::move(model.parts[i]);
            part.density = json.at("parts").at(i).at("density").get<double>();
            part.reason = messageFrom(json.at("parts").at(i).at("reason"));
            part.remarks = messagesFrom(json.at("parts").at(i).at("remarks"));
            if (const auto sheets = json.at("parts").at(i).at("sheets").get<std::size_t>(); sheets > 0) {
                PieceCut cut{.sheets = {},
                             .inside = {},
                             .outside = {},
                             .spacing = json.at("parts").at(i).at("spacing").get<double>()};
                for (std::size_t sheet = 0; sheet < sheets; ++sheet)
                    cut.sheets.push_back(blocks.nextArray<Vec3>());
                cut.inside = blocks.nextArray<Vec3>();
                cut.outside = blocks.nextArray<Vec3>();
                part.cut = std::make_shared<const PieceCut>(std::move(cut));
            }
            part.deformations = lists.at(json.at("parts").at(i).at("deformations").get<std::size_t>());
            if (json.at("parts").at(i).at("hasSlit").get<bool>())
                part.slit = std::make_shared<const KnifeSlit>(nextSlit(blocks));
            if (const Json& before = json.at("parts").at(i).at("before"); !before.is_null())
                part.before = {.volume = before.at("volume").get<double>(),
                               .faces = before.at("faces").get<int>(),
                               .edges = before.at("edges").get<int>()};
            if (!json.at("parts").at(i).at("hasObjects").get<bool>())
                continue;
            const std::shared_ptr<Aggregate> aggregate = nextJobAggregate(blocks);
            part.displacements = blocks.nextArray<Vec3>();
            aggregate->former = nextFormer(blocks, json.at("parts").at(i).at("formers").get<int>());
            part.aggregate = aggregate;
        }
        return job;
    } catch (const Json::exception& error) {
        throw Problem(Message::verbatim(std::string("export job: ") + error.what()));
    }
}

std::string exportedToBytes(const ExportedFile& file)
{
    BlockWriter blocks;
    blocks.add(std::string_view(documentOf(file.report)));
    blocks.add(std::string_view(file.bytes));
    return std::move(blocks).bytes();
}

ExportedFile exportedFromBytes(std::string_view bytes)
{
    BlockReader blocks(bytes, "exported file");
    ExportedFile file;
    file.report = reportFromJson(blocks.next());
    file.bytes = blocks.next();
    return file;
}

std::string reportToJson(const ExportReport& report)
{
    ExportReport english = report;
    for (PartExportReport& part : english.parts) {
        sayInEnglish(part.reason);
        std::for_each(part.remarks.begin(), part.remarks.end(), sayInEnglish);
    }
    std::for_each(english.warnings.begin(), english.warnings.end(), sayInEnglish);
    return documentOf(english);
}

ExportReport reportFromJson(std::string_view text)
{
    try {
        const Json json = Json::parse(text);
        ExportReport report;
        report.file = json.at("file").get<std::string>();
        report.format = json.at("format").get<std::string>();
        report.unit = json.at("unit").get<std::string>();
        report.bytes = json.at("bytes").get<std::uint64_t>();
        report.seconds = json.at("seconds").get<double>();
        report.warnings = messagesFrom(json.at("warnings"));
        for (const Json& part : json.at("parts"))
            report.parts.push_back(partFrom(part));
        return report;
    } catch (const Json::exception& error) {
        throw Problem(Message::verbatim(std::string("export report: ") + error.what()));
    }
}

} // namespace knead
