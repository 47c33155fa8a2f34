#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/session/face_fixture.h"
#include "core/session/filled_model.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace knead {

/// Which face of a surface each face of another one lies on, which may have been split since: that which most of its area is nearest to.
/// @param before with faces, and where it is now
/// @param faces of `now`
std::vector<std::uint32_t> facesBefore(const TriangleMesh& now, std::size_t faces, const TriangleMesh& before);

/// Fixtures of a content on the faces that theirs have become in another one. One whose body has come apart becomes several.
/// @param origin as PartsInstead::origin
/// @param surfaceOf a body of `before`, where its surface is taken to
std::vector<FaceFixture> fixturesAfter(const std::vector<FaceFixture>& fixtures, const FilledModel& before,
                                       const FilledModel& after, const std::vector<std::size_t>& origin,
                                       const std::function<TriangleMesh(BodyId body)>& surfaceOf);

} // namespace knead
