#pragma once

#include "core/task/task_control.h"
#include "io/mesh/mesh_body.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// What goes into one mesh file. The bodies are those with triangles; there is at least one, and all numbers are finite.
struct MeshFile {
    const std::string& path;
    std::string unit; ///< as LengthUnit::name
    double perMetre;  ///< how many of the unit
    bool isText;      ///< where the format has a choice
    TaskControl& control;
    std::vector<const MeshBody*> bodies{};
    std::vector<std::string> names{}; ///< of the bodies: UTF-8 on one line, not empty
    std::size_t vertexCount = 0;      ///< of all bodies; fits 31 bits, as triangleCount does
    std::size_t triangleCount = 0;
};

// Each writes one format as writeMeshes() says, and throws as it does.
void writeStl(const MeshFile& file);
void writeObj(const MeshFile& file);
void writePly(const MeshFile& file);
void writeGltf(const MeshFile& file);
void writeGlb(const MeshFile& file);
void writeThreeMf(const MeshFile& file);
void writeVtp(const MeshFile& file);

/// What writes files of an ending; one for each ending of FileFormat that holds triangles.
struct MeshWriter {
    std::string_view ending;
    void (*write)(const MeshFile&);
};
inline constexpr std::array meshWriters{MeshWriter{"stl", writeStl},   MeshWriter{"obj", writeObj},
                                        MeshWriter{"ply", writePly},   MeshWriter{"glb", writeGlb},
                                        MeshWriter{"gltf", writeGltf}, MeshWriter{"3mf", writeThreeMf},
                                        MeshWriter{"vtp", writeVtp}};

} // namespace knead
