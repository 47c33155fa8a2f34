#include "core/mechanics/blade.h"

#include <cmath>
#include <numbers>

namespace knead {

namespace {

constexpr double bluntest = std::numbers::pi / 4;
constexpr double thinnest = 30; // length of a wire by its thickness

} // namespace

double wedgeAngle(const Vec3& size)
{
    return 2 * std::atan2(0.5 * size.y(), size.z());
}

std::optional<Flank> flankOf(const ToolShape& shape, int side, const Vec3& place)
{
    const Vec3 half = 0.5 * shape.size;
    if (std::abs(place.x()) > half.x() || place.z() > half.z())
        return {};
    const Vec3 normal = Vec3(0, side * shape.size.z(), -half.y()).normalized();
    return Flank{.plane = {normal.dot(place + half.z() * Vec3::UnitZ()), normal}, .isAhead = place.z() < -half.z()};
}

std::optional<Blade> bladeOf(const ToolShape& shape)
{
    const Vec3 half = 0.5 * shape.size;
    if (shape.kind == ToolKind::wedge && wedgeAngle(shape.size) < bluntest)
        return Blade{.from = Vec3(-half.x(), 0, -half.z()),
                     .to = Vec3(half.x(), 0, -half.z()),
                     .forward = -Vec3::UnitZ(),
                     .height = shape.size.z()};
    if (shape.kind == ToolKind::cylinder && shape.size.z() >= thinnest * shape.size.x())
        return Blade{.from = Vec3(0, 0, -half.z()), .to = Vec3(0, 0, half.z())};
    return {};
}

} // namespace knead
