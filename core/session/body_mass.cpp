#include "core/session/body_mass.h"

namespace knead {

namespace {

/// Without copying triangles: volume and centroid about the middle of the box, by the divergence theorem.
struct Solid {
    double volume = 0;
    Vec3 centroid = Vec3::Zero();
};

Solid solidOf(const TriangleMesh& mesh, std::span<const Vec3> places)
{
    const Vec3 middle = places.front(); // keeps numbers small
    Solid solid;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 u = places[a] - middle;
        const Vec3 v = places[b] - middle;
        const Vec3 w = places[c] - middle;
        const double sixfold = u.dot(v.cross(w));
        solid.volume += sixfold / 6;
        solid.centroid += sixfold / 24 * (u + v + w);
    }
    solid.centroid = solid.volume != 0 ? Vec3(middle + solid.centroid / solid.volume) : middle;
    return solid;
}

double exactVolume(const FilledModel& content, const FilledBody& body, const Solid& rest)
{
    const double exact = content.model->parts[body.part].volume;
    return exact > 0 ? exact : rest.volume;
}

/// How regions of other materials change the mean density and shift the center from that of the volume.
struct Balance {
    double density = 0;        ///< mean [kg/m^3]
    Vec3 shift = Vec3::Zero(); ///< [m]
};

/// @param positions of its objects as they are filled in the present
Balance balanceOf(const Material& own, const Snapshot::BodyState& present, std::span<const Vec3> positions)
{
    if (!present.relaxed || present.relaxed->materials.isUniform())
        return {own.density};
    double volume = 0;
    double mass = 0;
    Vec3 byVolume = Vec3::Zero();
    Vec3 byMass = Vec3::Zero();
    for (ObjectIndex i = 0; i < positions.size(); ++i) {
        const double v = present.aggregate->volume[i];
        const double m = v * present.relaxed->materials.of(i).density;
        volume += v;
        mass += m;
        byVolume += v * positions[i];
        byMass += m * positions[i];
    }
    return {mass / volume, byMass / mass - byVolume / volume};
}

std::vector<Vec3> restPositions(const Snapshot::BodyState& present)
{
    return present.aggregate ? present.aggregate->lattice.positions()
                             : std::vector<Vec3>(); // none of a file not filled
}

} // namespace

BodyMass massAtRest(const FilledModel& content, BodyId id, const Snapshot& present)
{
    const FilledBody& body = *content.bodies[id];
    const Solid rest = solidOf(body.mesh, body.mesh.vertices);
    const Balance balance = balanceOf(present.materials[id], present.bodies[id], restPositions(present.bodies[id]));
    const double volume = exactVolume(content, body, rest);
    return {volume, balance.density * volume, rest.centroid + balance.shift};
}

BodyMass massNow(const FilledModel& content, BodyId id, const Frame& shown, const Snapshot& present)
{
    const FilledBody& body = *shown.filled[id]; // perhaps whole still, or in pieces already
    const Solid rest = solidOf(body.mesh, body.mesh.vertices);
    const Solid now = solidOf(body.mesh, shown.bodies[id]->places);
    const double volume = exactVolume(content, body, rest);
    const Snapshot::BodyState& state = present.bodies[id];
    const Snapshot::BodyState& then = shown.snapshot->bodies[id];
    const bool isFilledSame = then.aggregate == state.aggregate; // else materials are of other objects
    const Balance balance = balanceOf(present.materials[id], state, isFilledSame ? then.positions : state.positions);
    return {rest.volume != 0 ? volume * now.volume / rest.volume : now.volume, balance.density * volume,
            now.centroid + balance.shift};
}

} // namespace knead
