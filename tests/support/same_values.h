#pragma once

#include "core/document/project.h"
#include "core/skin/former_shape.h"

#include <algorithm>
#include <bit>
#include <tuple>
#include <type_traits>

/// Whether values of the model and of scenes are the same to the last bit. A member that is new does not compile here until it
/// is compared.
namespace knead::same {

// Members of each type, all of them.
template <class Value>
requires std::is_empty_v<Value>
auto members(const Value&)
{
    return std::tie();
}
inline auto members(const Material& m)
{
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, n, o, p, q, r] = m;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, n, o, p, q, r);
}
inline auto members(const Pose& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const KeyFrame& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const DriveAt& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const GoTo& v)
{
    const auto& [a] = v;
    return std::tie(a);
}
inline auto members(const FollowKeyFrames& v)
{
    const auto& [a] = v;
    return std::tie(a);
}
inline auto members(const Manipulator& v)
{
    const auto& [a, b, c, d, e, f, g, h, i, j, k] = v;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k);
}
inline auto members(const Fixture& v)
{
    const auto& [a, b, c, d, e, f] = v;
    return std::tie(a, b, c, d, e, f);
}
inline auto members(const GripTurn& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const LoadAmount& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const LoadPatch& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const Load& v)
{
    const auto& [a, b, c, d, e, f, g] = v;
    return std::tie(a, b, c, d, e, f, g);
}
inline auto members(const MaterialRegion& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const Body& v)
{
    const auto& [a, b, c, d, e, f, g, h, i] = v;
    return std::tie(a, b, c, d, e, f, g, h, i);
}
inline auto members(const Scene& v)
{
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = v;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
}
inline auto members(const Lattice& v)
{
    const auto& [a, b, c, d, e] = v;
    return std::tie(a, b, c, d, e);
}
inline auto members(const Lattice::Segment& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const SkinPoint& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const FormerShape& v)
{
    return std::tie(*v.carriers(), v.displacements());
}
inline auto members(const Aggregate& v)
{
    const auto& [a, b, c, d, e, f, g, h, i, j, k] = v;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k);
}
inline auto members(const SetMaterial& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const SetBodyKind& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const Renormalize& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const SetGravity& v)
{
    const auto& [a] = v;
    return std::tie(a);
}
inline auto members(const SetFloor& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const AddManipulator& v)
{
    const auto& [a] = v;
    return std::tie(a);
}
inline auto members(const RemoveManipulator& v)
{
    const auto& [a] = v;
    return std::tie(a);
}
inline auto members(const SetManipulatorMotion& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const ReshapeManipulator& v)
{
    const auto& [a, b, c, d, e, f, g, h, i] = v;
    return std::tie(a, b, c, d, e, f, g, h, i);
}
inline auto members(const PlaceManipulator& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const AddFixture& v)
{
    const auto& [a] = v;
    return std::tie(a);
}
inline auto members(const RemoveFixture& v)
{
    const auto& [a] = v;
    return std::tie(a);
}
inline auto members(const MoveFixture& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const AddLoad& v)
{
    const auto& [a] = v;
    return std::tie(a);
}
inline auto members(const RemoveLoad& v)
{
    const auto& [a] = v;
    return std::tie(a);
}
inline auto members(const SetLoad& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const RenameManipulator& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const RenameFixture& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const SetPartLook& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const SetIntegrator& v)
{
    const auto& [a] = v;
    return std::tie(a);
}
inline auto members(const SetPace& v)
{
    const auto& [a] = v;
    return std::tie(a);
}
inline auto members(const Refill& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const Cut& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const FindBalance& v)
{
    const auto& [a] = v;
    return std::tie(a);
}
inline auto members(const RecordedCommand& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const HistoryRecord& v)
{
    const auto& [a, b, c, d, e, f, g, h, i, j, k] = v;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k);
}
inline auto members(const Color& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const PartFace& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const ExactShape& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const TriangleMesh& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const Part& v)
{
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, w] = v;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, w);
}
inline auto members(const PartNode& v)
{
    const auto& [a, b, c, d, e, f] = v;
    return std::tie(a, b, c, d, e, f);
}
inline auto members(const UnitRemark& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const Model& v)
{
    const auto& [a, b, c, d, e, f, g, h] = v;
    return std::tie(a, b, c, d, e, f, g, h);
}
inline auto members(const ImportOptions& v)
{
    const auto& [a, b, c, d, e, f, g, h, i, j, k] = v;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k);
}
inline auto members(const SpacingChoice& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const ImportChoices& v)
{
    const auto& [a, b, c, d, e] = v;
    return std::tie(a, b, c, d, e);
}
inline auto members(const NumberDeformation& v)
{
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l] = v;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l);
}
inline auto members(const FieldChoice& v)
{
    const auto& [a, b, c, d] = v;
    return std::tie(a, b, c, d);
}
inline auto members(const KeptFaces& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const RecipeField& v)
{
    const auto& [a, b, c, d, e, f] = v;
    return std::tie(a, b, c, d, e, f);
}
inline auto members(const RecipeDeformation& v)
{
    const auto& [a, b, c, d] = v;
    return std::tie(a, b, c, d);
}
inline auto members(const ProjectStart& v)
{
    const auto& [a, b, c, d] = v;
    return std::tie(a, b, c, d);
}
inline auto members(const ProjectMark& v)
{
    const auto& [a, b] = v;
    return std::tie(a, b);
}
inline auto members(const ProjectCamera& v)
{
    const auto& [a, b, c, d, e] = v;
    return std::tie(a, b, c, d, e);
}
inline auto members(const ProjectView& v)
{
    const auto& [a, b, c] = v;
    return std::tie(a, b, c);
}
inline auto members(const Project& v)
{
    const auto& [a, b, c, d, e, f, g, h] = v;
    return std::tie(a, b, c, d, e, f, g, h);
}
inline auto members(const ToolPart& v)
{
    return std::tie(v.mesh(), v.size(), v.center());
}

template <class Value>
bool values(const Value& a, const Value& b);

template <class Value>
struct Comparison {
    static bool of(const Value& a, const Value& b)
    {
        if constexpr (requires { members(a); })
            return std::apply(
                [&](const auto&... x) {
                    return std::apply([&](const auto&... y) { return (values(x, y) && ...); }, members(b));
                },
                members(a));
        else
            return a == b;
    }
};

template <>
struct Comparison<double> {
    static bool of(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }
};
template <>
struct Comparison<Vec3> {
    static bool of(const Vec3& a, const Vec3& b)
    {
        return values(a.x(), b.x()) && values(a.y(), b.y()) && values(a.z(), b.z());
    }
};
template <>
struct Comparison<Quaternion> {
    static bool of(const Quaternion& a, const Quaternion& b)
    {
        return values(a.w(), b.w()) && values(a.x(), b.x()) && values(a.y(), b.y()) && values(a.z(), b.z());
    }
};
template <>
struct Comparison<Box> {
    static bool of(const Box& a, const Box& b)
    {
        return (a.isEmpty() && b.isEmpty()) || (values(a.min(), b.min()) && values(a.max(), b.max()));
    }
};
template <class Item>
struct Comparison<std::vector<Item>> {
    static bool of(const std::vector<Item>& a, const std::vector<Item>& b)
    {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), values<Item>);
    }
};
template <class Item, std::size_t count>
struct Comparison<std::array<Item, count>> {
    static bool of(const std::array<Item, count>& a, const std::array<Item, count>& b)
    {
        return std::equal(a.begin(), a.end(), b.begin(), values<Item>);
    }
};
template <class Value>
struct Comparison<std::optional<Value>> {
    static bool of(const std::optional<Value>& a, const std::optional<Value>& b)
    {
        return a.has_value() == b.has_value() && (!a || values(*a, *b));
    }
};
template <class Value>
struct Comparison<std::shared_ptr<Value>> {
    static bool of(const std::shared_ptr<Value>& a, const std::shared_ptr<Value>& b)
    {
        return a == b || (a && b && values<std::remove_const_t<Value>>(*a, *b));
    }
};
template <class... Alternatives>
struct Comparison<std::variant<Alternatives...>> {
    using Variant = std::variant<Alternatives...>;
    static bool of(const Variant& a, const Variant& b)
    {
        return a.index() == b.index() &&
               std::visit([&]<class Value>(const Value& value) { return values(value, std::get<Value>(b)); }, a);
    }
};

/// The same to the last bit.
template <class Value>
bool values(const Value& a, const Value& b)
{
    return Comparison<Value>::of(a, b);
}

} // namespace knead::same
