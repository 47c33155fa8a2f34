#include "io/size_limits.h"

#include "io/cad_format.h"

namespace knead {

namespace {

constexpr double farthest = 1e5;  // [m]
constexpr double smallest = 1e-6; // [m]; ten times the tolerance of the modeler

} // namespace

bool isWithinReach(const Box& box)
{
    return !box.isEmpty() && box.min().allFinite() && box.max().allFinite() &&
           box.min().cwiseAbs().maxCoeff() <= farthest && box.max().cwiseAbs().maxCoeff() <= farthest;
}

void checkPlaceAndSize(const std::string& path, const Model& model)
{
    if (model.parts.empty())
        failReading(path, "the file holds no solid and no surface; export the part as a solid.");
    Box all;
    for (const Part& part : model.parts) {
        if (part.box.isEmpty())
            failReading(path, "\"" + part.name + "\" has no finite size; the file is damaged, export it again.");
        all.extend(part.box);
    }
    if (!isWithinReach(all))
        failReading(path,
                    "its shapes reach farther than 100 km from the origin; check the length unit and the position.");
    if (all.diagonal().norm() < smallest)
        failReading(path, "its shapes are smaller than a micrometre; check the length unit.");
}

} // namespace knead
