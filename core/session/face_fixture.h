#pragma once

#include "core/simulation/scene.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// CAD faces of a body that are held in place.
struct FaceFixture {
    std::uint32_t key = 0; ///< names the fixture as long as the document lives
    std::string name;      ///< unique; the name of the Fixture in the scene
    BodyId body = 0;
    std::vector<std::uint32_t> faces; ///< none: objects are held that no faces are known of
    std::optional<FixtureId> id;      ///< in the simulation; none where the faces hold no object
};

} // namespace knead
