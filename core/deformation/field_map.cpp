#include "core/deformation/field_map.h"

#include "core/deformation/kept_weight.h"
#include "core/deformation/patch_tree.h"
#include "core/message/message.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace knead {

namespace {

constexpr double onePlace = 1e-9;      // of the size of the nodes: nearer ones are the same, as in files of six digits
constexpr double mostCoordinate = 1e9; // [m] of a coordinate: squares and products of more say nothing
constexpr double featureOfLeaf = 1;    // sides of a leaf, over which weights and patches are about quadratic
constexpr double featureOfFade = 0.25;
constexpr double longestFeature = 0.25; // of the size of the nodes, and
constexpr double shortestFeature = 1.0 / 400;
constexpr std::size_t pointsPerBlock = 64;

[[noreturn]] void refuse(const Message& sentence)
{
    throw Problem(sentence);
}

bool isUsable(const Vec3& v)
{
    return v.allFinite() && v.cwiseAbs().maxCoeff() <= mostCoordinate;
}

void check(const FieldDeformation& deformation)
{
    const DisplacementField& field = *deformation.field;
    if (field.isEmpty())
        refuse(Message("Deformation", "The field has no nodes."));
    if (field.displacements.size() != field.nodes.size())
        throw Problem(Message("Deformation", "The field has %1 nodes, but %2 displacements.")
                          .with(field.nodes.size(), field.displacements.size()));
    for (std::size_t i = 0; i < field.nodes.size(); ++i)
        if (!isUsable(field.nodes[i]) || !isUsable(field.displacements[i]))
            throw Problem(Message("Deformation",
                                  "Node %1 of the field has a number that is not finite, or far too large; "
                                  "leave that node out, or write the file again.")
                              .with(i + 1));
    if (!std::isfinite(deformation.factor))
        refuse(Message("Deformation", "The factor of a deformation is no number."));
    if (!deformation.kept.empty() && !(deformation.fade > 0 && std::isfinite(deformation.fade)))
        refuse(
            Message("Deformation", "Faces that stay where they are need a distance over which the deformation fades."));
    for (const Vec3& vertex : deformation.kept.vertices)
        if (!isUsable(vertex))
            refuse(Message("Deformation", "A face that stays where it is has a corner that is no place."));
}

/// What took long in a map that is made anew of the same field.
struct FittedField {
    std::shared_ptr<const DisplacementField> field;
    std::shared_ptr<const PatchTree> tree;
    Box box; ///< of the nodes [m]
};

/// Nodes in one place as one, which moves as they do on average: of a mesh that is not joined, or of bodies that touch.
DisplacementField merged(const DisplacementField& field)
{
    const Box box = boxOfPlaces(field.nodes);
    const double step = std::max(onePlace * box.diagonal().norm(), 1e-300);
    using Key = std::array<std::int64_t, 3>;
    std::vector<std::pair<Key, std::uint32_t>> order(field.nodes.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        const Vec3 at = (field.nodes[i] - box.min()) / step;
        order[i] = {{std::llround(at.x()), std::llround(at.y()), std::llround(at.z())}, i};
    }
    std::sort(order.begin(), order.end());
    DisplacementField result;
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin;
        Vec3 sum = Vec3::Zero();
        for (; end < order.size() && order[end].first == order[begin].first; ++end)
            sum += field.displacements[order[end].second];
        result.nodes.push_back(field.nodes[order[begin].second]);
        result.displacements.push_back(sum / static_cast<double>(end - begin));
        begin = end;
    }
    return result;
}

class FieldMap final : public SmoothMap {
public:
    FieldMap(const FieldDeformation& deformation, FittedField fitted)
        : m_fitted(std::move(fitted))
    {
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            m_factors[axis] = deformation.locked[static_cast<std::size_t>(axis)] ? 0 : deformation.factor;
        const double size = m_fitted.box.diagonal().norm();
        const double leaf = m_fitted.tree->leafSide();
        m_featureSize =
            size > 0 ? std::clamp(featureOfLeaf * leaf, shortestFeature * size, longestFeature * size) : leaf;
        if (!deformation.kept.empty()) {
            m_kept.emplace(deformation.kept, deformation.fade);
            m_featureSize = std::min(m_featureSize, featureOfFade * deformation.fade);
        }
    }

    void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const override
    {
        forEachBlock(points.size(), pointsPerBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                places[i] = points[i] + m_factors.cwiseProduct(weightedAt(points[i]));
        });
    }
    double featureSize() const override { return m_featureSize; }
    const FittedField& fitted() const { return m_fitted; }

private:
    Vec3 weightedAt(const Vec3& point) const
    {
        const double weight = m_kept ? m_kept->at(point) : 1;
        return weight > 0 ? Vec3(weight * m_fitted.tree->displacementAt(point)) : Vec3(Vec3::Zero());
    }

    FittedField m_fitted;
    std::optional<KeptWeight> m_kept;
    Vec3 m_factors; ///< along x, y, z
    double m_featureSize = 0;
};

/// @param earlier null: none
FittedField fittedField(const std::shared_ptr<const DisplacementField>& field, TaskControl& control,
                        const SmoothMap* earlier)
{
    if (const auto* before = dynamic_cast<const FieldMap*>(earlier); before && before->fitted().field == field)
        return before->fitted();
    return {field, std::make_shared<const PatchTree>(merged(*field), control), boxOfPlaces(field->nodes)};
}

} // namespace

std::shared_ptr<const SmoothMap> fieldMap(const FieldDeformation& deformation, TaskControl& control,
                                          const SmoothMap* earlier)
{
    check(deformation);
    return std::make_shared<const FieldMap>(deformation, fittedField(deformation.field, control, earlier));
}

} // namespace knead
