#pragma once

#include "app/opened_shape.h"
#include "core/model/part.h"
#include "io/formats/mesh_writer.h"

#include <vector>

namespace knead {

/// What a picture shows: the parts of a file as they are in it.
std::vector<MeshBody> drawnBodies(const Model& model);

/// The bodies of an opened file or project where they are there.
std::vector<MeshBody> drawnBodies(const OpenedShape& shape);

} // namespace knead
