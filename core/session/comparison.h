#pragma once

#include "core/session/body_mass.h"
#include "core/task/task_control.h"

#include <string>
#include <vector>

namespace knead {

/// How far a body is from its original shape.
struct BodyComparison {
    std::string name;
    double largestDistance = 0;     ///< of its skin from the original surface [m]
    double meanDistance = 0;        ///< the same, by area [m]
    double largestDisplacement = 0; ///< of a vertex of its skin, from rest; not a number where it was not followed [m]
    Vec3 farthest = Vec3::Zero();   ///< where its skin is farthest from the original surface [m]
    BodyMass rest;
    BodyMass now;
};

/// Of all bodies at a moment.
struct Comparison {
    double time = 0; ///< simulated [s]
    std::vector<BodyComparison> bodies;
    std::vector<std::string> onlyBefore; ///< parts of the original that nothing belongs to
    std::vector<std::string> onlyNow;    ///< parts that belong to none of the original
};

/// Searches for the nearest point of the original surface from every vertex of the skin; each counts for the area around it.
/// Any thread; a tenth of a second for 100,000 triangles.
/// @throws Cancelled
Comparison compareWithOriginal(const FilledModel& content, const Frame& shown, const Snapshot& present,
                               TaskControl& control);

/// The closed parts of a model beside those of another: with the same path, else the same name, else in their order. Distances are
/// the larger ones of both directions; of masses only volumes and centers are known.
/// @throws Problem when nothing can be compared; Cancelled
Comparison compareModels(const Model& original, const Model& changed, TaskControl& control);

} // namespace knead
