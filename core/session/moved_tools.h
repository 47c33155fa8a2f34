#pragma once

#include "core/session/moved_regions.h"

#include <map>
#include <set>
#include <string>

namespace knead {

/// Moves tools of a recipe to another part. A tool goes where the place of the surface went that is nearest to it; while it is inside of
/// the material, where it went in.
class MovedTools {
public:
    /// Both outlive it.
    MovedTools(const TransferGround& ground, TransferReport& report);

    bool isThere(const std::string& name) const { return !m_gone.contains(name); }

    /// False where a tool cannot be on the other part, which is reported.
    bool move(RecipeManipulator& tool);
    bool move(const std::string& name, Motion& motion); ///< true
    bool reshape(RecipeManipulator& form);
    Pose moved(const std::string& name, const Pose& pose);

private:
    Quaternion turned(const Quaternion& rotation) const;
    void resize(RecipeManipulator& tool) const;
    bool canBe(const RecipeManipulator& tool);

    const TransferGround& m_ground;
    CarriedVectors m_vectors;
    TransferReport& m_report;
    std::set<std::string> m_gone;
    std::map<std::string, Vec3> m_beyond; ///< where each went in [m], see PlaceMap
};

} // namespace knead
