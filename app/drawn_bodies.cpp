#include "app/drawn_bodies.h"

namespace knead {

std::vector<MeshBody> drawnBodies(const Model& model)
{
    std::vector<MeshBody> bodies;
    for (const Part& part : model.parts)
        bodies.push_back({part.name, part.color.value_or(Color{}), part.mesh});
    return bodies;
}

std::vector<MeshBody> drawnBodies(const OpenedShape& shape)
{
    std::vector<MeshBody> bodies;
    for (std::size_t b = 0; b < shape.content.bodies.size(); ++b) {
        const FilledBody& body = *shape.content.bodies[b];
        bodies.push_back({body.name, body.color, body.mesh});
        bodies.back().mesh.vertices = shape.frame->bodies[b]->places;
    }
    return bodies;
}

} // namespace knead
