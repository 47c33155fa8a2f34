#include "core/deformation/end_motion.h"

#include "core/deformation/number_map.h"

namespace knead {

namespace {

/// With a share of its amount.
NumberDeformation withShare(const NumberDeformation& whole, double share)
{
    NumberDeformation result = whole;
    result.angle *= share;
    result.factor = 1 + (whole.factor - 1) * share;
    result.shift *= share;
    return result;
}

} // namespace

bool hasRigidEnds(NumberKind kind)
{
    return kind != NumberKind::taper && kind != NumberKind::scale;
}

Vec3 turnAxis(const NumberDeformation& deformation)
{
    return deformation.kind == NumberKind::bend ? Vec3(deformation.axis.cross(deformation.side)) : deformation.axis;
}

EndPlace endPlace(const NumberDeformation& deformation, NumberEnd end, double share)
{
    const NumberDeformation now = withShare(deformation, share);
    const bool isFirst = end == NumberEnd::first;
    const bool turns = now.kind == NumberKind::bend || now.kind == NumberKind::twist;
    const double height = now.kind == NumberKind::bend ? now.neutral : 0;
    const Vec3 reference = now.origin + (isFirst ? now.from : now.to) * now.axis + height * now.side;
    const double turned = (isFirst ? 0.0 : 1.0) - profileOf(now, now.stays);
    return {turns ? now.angle * turned : 0,
            NumberMap(now).placeAs(isFirst ? NumberMap::Zone::before : NumberMap::Zone::behind, reference)};
}

} // namespace knead
