#include "core/session/part_transfer.h"

#include "core/model/file_names.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

// Shares of the progress.
constexpr double beforeFilled = 0.4;
constexpr double afterRead = 0.6;
constexpr double afterFilled = 0.8;
constexpr double afterMatched = 0.95;

Box boxOfParts(std::span<const Part> parts)
{
    Box box;
    for (const Part& part : parts)
        if (part.canBeFilled())
            box.extend(boxOfPlaces(part.mesh.vertices));
    return box;
}

/// What is the same for every part, without anything that has a place on one.
Recipe bareRecipe(const Recipe& recipe, const std::string& file, const TransferOptions& options)
{
    Recipe bare = recipe;
    bare.part = file;
    bare.partsBeside.clear();
    bare.import = {};
    bare.import.unit = options.unit;
    bare.regions.clear();
    bare.fixtures.clear();
    bare.loads.clear();
    bare.manipulators.clear();
    bare.bodies.clear();
    bare.bodyMaterials.clear();
    bare.events.clear();
    bare.probes.clear();
    bare.exports.clear();
    return bare;
}

/// x -> s M (x - c) + c' with the middles c, c' of the boxes of both parts; where nothing is mirrored or scaled, places stay.
AffineMap baseMap(const Box& before, const Box& after, const TransferOptions& options)
{
    if (before.isEmpty() || after.isEmpty())
        throw UnusableInput(Message("Transfer", "One of the parts is not closed: there is nothing to carry over."));
    AffineMap base;
    const double scale = options.scale.value_or(after.diagonal().norm() / before.diagonal().norm());
    if (options.mirror) {
        const Vec3 normal = options.mirror->normalized();
        base.linear -= 2 * normal * normal.transpose();
    }
    base.linear *= scale;
    const bool staysInPlace = !options.mirror && scale == 1;
    base.from = before.center();
    base.to = staysInPlace ? base.from : after.center();
    return base;
}

/// The time of a step, between those that are known.
double timeOf(std::uint64_t step, std::span<const std::pair<std::uint64_t, double>> known)
{
    const auto next = std::ranges::lower_bound(known, step, {}, &std::pair<std::uint64_t, double>::first);
    if (next == known.end())
        return known.back().second;
    if (next->first == step || next == known.begin())
        return next->second;
    const auto& before = *std::prev(next);
    const double share = static_cast<double>(step - before.first) / static_cast<double>(next->first - before.first);
    return before.second + share * (next->second - before.second);
}

/// Times count anew after a reset, of which the times of steps say nothing.
void goByTime(Recipe& recipe, const TransferOptions& options)
{
    const auto isReset = [](const RecipeEvent& event) { return std::holds_alternative<StartAgain>(event.action); };
    if (options.timesOfSteps.empty() || std::ranges::any_of(recipe.events, isReset))
        return;
    for (RecipeEvent& event : recipe.events)
        if (event.step) {
            event.time = timeOf(*event.step, options.timesOfSteps);
            event.step.reset();
        }
    if (recipe.durationSteps && timeOf(*recipe.durationSteps, options.timesOfSteps) > 0) {
        recipe.duration = timeOf(*recipe.durationSteps, options.timesOfSteps);
        recipe.durationSteps.reset();
    }
}

/// The recipe on the other part: what belongs to the part is that of the bare one.
Recipe withPartOf(Recipe recipe, const Recipe& bare, double spacing, double scale)
{
    recipe.part = bare.part;
    recipe.partsBeside = bare.partsBeside;
    recipe.import = bare.import;
    recipe.spacing = {SpacingChoice::Kind::Length, spacing};
    recipe.exports.clear();
    if (recipe.timeStep)
        *recipe.timeStep *= scale;
    if (recipe.massScalingTimeStep)
        *recipe.massScalingTimeStep *= scale;
    return recipe;
}

void reportFaces(const RecipeScene& before, const RecipeScene& after, std::span<const BodyMap> bodies,
                 TransferReport& report)
{
    for (BodyId b = 0; b < before.parts().size(); ++b) {
        const auto body = std::ranges::find(bodies, b, &BodyMap::before);
        for (std::uint32_t f = 0; f < before.parts()[b].faces.size(); ++f) {
            TransferReport::Face& face = report.faces.emplace_back();
            face.body = before.parts()[b].name;
            face.before = f;
            if (body == bodies.end())
                continue;
            face.bodyAfter = after.parts()[body->after].name;
            const auto match = std::ranges::lower_bound(body->matches, f, {}, &FaceMatch::before);
            if (match == body->matches.end() || match->before != f)
                continue;
            face.after = match->after;
            face.by = match->by;
            face.score = match->score;
        }
    }
}

/// Objects of what an event is about; null: of none.
std::pair<const std::string*, std::optional<RecipeObjects>*> objectsOf(RecipeAction& action)
{
    if (auto* change = std::get_if<ChangeMaterial>(&action))
        return {&change->body, &change->objects};
    if (auto* wanted = std::get_if<RenormalizeBodies>(&action))
        return {&wanted->body, &wanted->objects};
    if (auto* add = std::get_if<AddRecipeFixture>(&action))
        return {&add->fixture.body, &add->fixture.objects};
    return {nullptr, nullptr};
}

/// Names what is named in later fillings by the objects of the first ones, where these are known.
Recipe byFirstFillings(Recipe recipe, const RecipeScene& before, const TransferOptions& options, TaskControl& control)
{
    std::optional<LaterFillings> later;
    for (RecipeEvent& event : recipe.events) {
        const auto [body, objects] = objectsOf(event.action);
        if (objects == nullptr || !*objects || !(*objects)->isFilledAnew || !options.laterFillings)
            continue;
        if (!later)
            later = options.laterFillings(control);
        const BodyId id = bodiesNamed(*body, before.parts(), Message("Transfer", "The recipe")).front();
        const auto filling = later->find({id, (*objects)->of});
        if (filling == later->end())
            continue;
        std::vector<ObjectIndex> first = objectsInFirst(*filling->second, (*objects)->numbers);
        if (!first.empty())
            *objects = RecipeObjects{std::move(first), before.scene.bodies[id].aggregate->size(), false};
    }
    return recipe;
}

/// The other part is read once.
RecipeFiles filesWith(const RecipeFiles& files, const std::string& path, std::shared_ptr<const Model> model)
{
    RecipeFiles known = files;
    known.import = [&files, path, model = std::move(model)](const std::vector<std::string>& paths,
                                                            const ImportOptions& how, TaskControl& control) {
        return paths == std::vector{path} ? *model : files.import(paths, how, control);
    };
    return known;
}

} // namespace

PartTransfer transferToPart(const Recipe& recipe, const std::string& file, const RecipeFiles& files,
                            const TransferOptions& options, TaskControl& control)
{
    TaskPortion fillingBefore(control, 0, beforeFilled);
    const RecipeScene before = buildScene(recipe, files, fillingBefore);
    const double spacing = before.scene.bodies.front().aggregate->lattice.spacing;

    TaskPortion reading(control, beforeFilled, afterRead);
    Recipe bare = bareRecipe(recipe, file, options);
    const auto model = std::make_shared<const Model>(files.import({file}, bare.import, reading));
    PartTransfer transfer;
    transfer.base = baseMap(boxOfParts(before.parts()), boxOfParts(model->parts), options);
    const double scale = std::cbrt(std::abs(transfer.base.linear.determinant()));
    transfer.report.scale = std::abs(scale - 1) < 1e-12 ? 1 : scale;
    bare.spacing = {SpacingChoice::Kind::Length, transfer.report.scale * spacing};

    TaskPortion fillingAfter(control, afterRead, afterFilled);
    const RecipeScene after = buildScene(bare, filesWith(files, file, model), fillingAfter);
    transfer.partsBefore = before.model;
    TaskPortion matching(control, afterFilled, afterMatched);
    transfer.bodies = mapBodies(transfer.partsBefore->parts, after.parts(), transfer.base, matching);
    reportFaces(before, after, transfer.bodies, transfer.report);
    if (transfer.report.found() == 0 && !transfer.report.faces.empty())
        throw UnusableInput(aboutFile(file, Message("Transfer", "none of the faces was found again on it. Is it "
                                                                "another part, or a mirrored one?")));
    const Recipe known = byFirstFillings(recipe, before, options, control);
    TaskPortion moving(control, afterMatched, 1);
    const TransferGround ground{before, after, transfer.bodies, transfer.base, moving};
    transfer.recipe =
        withPartOf(transferredRecipe(known, ground, transfer.report), bare, bare.spacing.value, transfer.report.scale);
    goByTime(transfer.recipe, options);
    return transfer;
}

DisplacementField fieldOnPart(const DisplacementField& field, const PartTransfer& transfer, TaskControl& control)
{
    DisplacementField moved{.nodes = placesOnPart(transfer.bodies, field.nodes, control), .displacements = {}};
    for (const Vec3& displacement : field.displacements)
        moved.displacements.push_back(transfer.base.linear * displacement);
    return moved;
}

} // namespace knead
