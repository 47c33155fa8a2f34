#include "core/session/target_points.h"

#include "core/geometry/refine.h"
#include "core/geometry/winding_number.h"
#include "core/message/message.h"
#include "core/model/number_words.h"
#include "core/session/place_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace knead {

namespace {

constexpr double placesOnSurface = 2000; // where nobody chose a spacing
constexpr double mostPlaces = 200'000;

/// Takes a place unless it is too close to one that was taken before.
bool takes(PlaceGrid& taken, const Vec3& place)
{
    if (!taken.around(place).empty())
        return false;
    taken.add(place);
    return true;
}

/// Per face of a part: whether it counts. One for all triangles of a mesh.
std::vector<bool> countedFaces(const Part& part, const FacesOfParts& faces)
{
    const std::size_t count = std::max<std::size_t>(1, part.faces.size());
    std::vector<bool> counted(count, faces.empty());
    for (const auto& [name, numbers] : faces) {
        if (name != part.name && name != part.path)
            continue;
        for (const std::uint32_t face : numbers) {
            if (face >= count)
                throw Problem(
                    Message("Compensation", "\"faces\" names face %1 of %2, which has %3; they are numbered from 0.")
                        .with(face, name, count));
            counted[face] = true;
        }
    }
    return counted;
}

void checkNames(const Model& model, const FacesOfParts& faces)
{
    for (const auto& [name, numbers] : faces)
        if (std::ranges::none_of(model.parts, [&](const Part& part) { return part.name == name || part.path == name; }))
            throw Problem(Message("Compensation",
                                  "\"faces\" names %1, which is no part of the target; knead info shows their names.")
                              .with(name));
}

double areaOf(const Model& model)
{
    double area = 0;
    for (const Part& part : model.parts)
        for (const TriangleMesh::Triangle& triangle : part.mesh.triangles)
            area += crossOf(part.mesh.vertices, triangle).norm() / 2;
    return area;
}

/// Vertices of a fine surface: first those of faces that count, so that these keep theirs.
void addSurface(const Part& part, const std::vector<bool>& counted, PlaceGrid& taken, TargetPoints& points)
{
    const TriangleMesh mesh = refine(part.mesh, points.spacing);
    std::vector<bool> counts(mesh.vertices.size(), false);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (counted[mesh.faceOfTriangle.empty() || part.faces.empty() ? 0 : mesh.faceOfTriangle[t]])
            for (const std::uint32_t corner : mesh.triangles[t])
                counts[corner] = true;
    for (const bool wanted : {true, false})
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
            if (counts[v] == wanted && takes(taken, mesh.vertices[v])) {
                points.places.push_back(mesh.vertices[v]);
                points.counts.push_back(wanted);
            }
}

/// Nodes of a lattice that are in the part.
void addInside(const Part& part, PlaceGrid& taken, TargetPoints& points, TaskControl& control)
{
    const WindingNumber winding(part.mesh);
    const Vec3 low = part.box.min();
    const Vec3 size = part.box.diagonal();
    const auto count = [&](Eigen::Index axis) {
        return std::max(1, static_cast<int>(std::ceil(size[axis] / points.spacing)));
    };
    const std::array<int, 3> cells{count(0), count(1), count(2)};
    for (int i = 0; i < cells[0]; ++i) {
        control.throwIfCancelled();
        for (int j = 0; j < cells[1]; ++j)
            for (int k = 0; k < cells[2]; ++k) {
                const Vec3 place = low + Vec3((i + 0.5) * size.x() / cells[0], (j + 0.5) * size.y() / cells[1],
                                              (k + 0.5) * size.z() / cells[2]);
                if (winding.at(place) > 0.5 && takes(taken, place)) {
                    points.places.push_back(place);
                    points.counts.push_back(false);
                }
            }
    }
}

void checkNumber(double area, const Model& model, double spacing)
{
    double volume = 0;
    for (const Part& part : model.parts)
        volume += part.watertight ? std::abs(part.volume) : 0;
    const double places = 2 * area / (spacing * spacing) + volume / (spacing * spacing * spacing);
    if (places > mostPlaces)
        throw Problem(Message("Compensation", "Points every %1 would be more than %2; choose a larger \"spacing_mm\".")
                          .with(lengthWords(spacing), static_cast<long>(mostPlaces)));
}

} // namespace

TargetPoints targetPoints(const Model& model, const FacesOfParts& faces, double spacing, TaskControl& control)
{
    checkNames(model, faces);
    const double area = areaOf(model);
    if (!(area > 0))
        throw Problem(Message("Compensation", "The target has no surface; name another part."));
    TargetPoints points;
    points.spacing = spacing > 0 ? spacing : std::sqrt(area / placesOnSurface);
    checkNumber(area, model, points.spacing);
    PlaceGrid taken(points.spacing / 2);
    for (const Part& part : model.parts)
        addSurface(part, countedFaces(part, faces), taken, points);
    for (const Part& part : model.parts)
        if (part.watertight)
            addInside(part, taken, points, control);
    return points;
}

} // namespace knead
