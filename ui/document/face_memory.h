#pragma once

#include "core/session/face_fixture.h"

#include <string>
#include <vector>

namespace knead {

/// What faces are remembered of fixtures, for a project file; and back. Of a text that is none, nothing.
std::string faceMemory(const std::vector<FaceFixture>& known);
std::vector<FaceFixture> facesRemembered(const std::string& memory);

} // namespace knead
