#include "io/document/size_limits.h"

#include "core/geometry/mass_properties.h"
#include "core/message/message.h"
#include "core/model/number_words.h"
#include "io/formats/cad_format.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr double farthest = 1e5;        // [m]
constexpr double smallestSize = 1e-6;   // [m]; ten times the tolerance of the modeler
constexpr double endless = 1e50;        // [m]; planes without edges reach to 1e97
constexpr double widestGapShare = 0.05; // of the size; one hundredth is warned of

/// A curve that leads away from its face takes triangles along, and the b-rep knows nothing of it.
bool hasTrianglesFarOutside(const Part& part)
{
    Box wide = part.box;
    const double size = part.box.diagonal().norm();
    wide.min().array() -= size;
    wide.max().array() += size;
    return !std::all_of(part.mesh.vertices.begin(), part.mesh.vertices.end(),
                        [&](const Vec3& vertex) { return wide.contains(vertex); });
}

/// Gives the parts in a tree new numbers; those without one go.
void renumber(PartNode& node, const std::vector<std::optional<std::size_t>>& numbers)
{
    if (node.part)
        node.part = numbers[*node.part];
    for (PartNode& child : node.children)
        renumber(child, numbers);
}

} // namespace

bool isWithinReach(const Box& box)
{
    return !box.isEmpty() && box.min().allFinite() && box.max().allFinite() &&
           box.min().cwiseAbs().maxCoeff() <= farthest && box.max().cwiseAbs().maxCoeff() <= farthest;
}

std::optional<Message> sicknessOf(const Part& part)
{
    const double size = part.box.isEmpty() ? 0 : part.box.diagonal().norm();
    if (part.box.isEmpty() || !(size < endless) || !std::isfinite(part.volume) || !std::isfinite(part.area))
        return Message("Import", "it has no finite size: numbers in it are damaged, or its edges are smaller than 0.1 "
                                 "um and lost; check the length unit");
    if (!isWithinReach(part.box))
        return Message("Import",
                       "it reaches farther than 100 km from the origin; check the length unit and the position");
    if (hasTrianglesFarOutside(part))
        return Message("Import", "its faces lead far away from their edges: numbers in it are damaged");
    if (size < smallestSize)
        return Message("Import", "it is smaller than a micrometre; check the length unit");
    if (part.maxTolerance > widestGapShare * size)
        return Message("Import", "its faces and edges are up to %1 apart, at a size of %2")
            .with(lengthWords(part.maxTolerance), lengthWords(size));
    const double leastVolume = leastVolumeShare * std::pow(size, 3);
    const bool isFlat = part.watertight && !(massProperties(part.mesh).volume > leastVolume);
    if (part.solids > 0 && part.openEdges.empty() && (part.volume <= leastVolume || isFlat))
        return Message("Import", "the solid has no volume");
    return std::nullopt;
}

Message leftOut(const std::string& partName, const Message& reason)
{
    return Message("Import", "\"%1\" was left out: %2.").with(partName, reason);
}

void leaveOutSickParts(Model& model)
{
    std::vector<std::optional<std::size_t>> numbers;
    std::vector<Part> sound;
    for (Part& part : model.parts)
        if (const std::optional<Message> sickness = sicknessOf(part)) {
            model.missing.push_back(leftOut(part.name, *sickness));
            numbers.emplace_back();
        } else {
            numbers.emplace_back(sound.size());
            sound.push_back(std::move(part));
        }
    if (sound.size() == model.parts.size()) {
        model.parts = std::move(sound);
        return;
    }
    model.parts = std::move(sound);
    renumber(model.tree, numbers);
    removeEmptyNodes(model.tree);
}

void removeEmptyNodes(PartNode& node)
{
    for (PartNode& child : node.children)
        removeEmptyNodes(child);
    std::erase_if(node.children, [](const PartNode& child) { return !child.part && child.children.empty(); });
}

void checkAnyPart(const std::string& path, const Model& model)
{
    if (!model.parts.empty())
        return;
    if (model.missing.empty())
        failReading(path, Message("Import", "the file holds no solid and no surface; export the part as a solid."));
    if (model.missing.size() == 1)
        failReading(path, model.missing.front());
    failReading(
        path,
        Message("Import", "%1 Of %2 parts like that none is left.").with(model.missing.front(), model.missing.size()));
}

} // namespace knead
