#include "io/files/safe_file.h"
#include "io/formats/mesh_formats.h"
#include "io/formats/number_stream.h"

#include <algorithm>

namespace knead {

namespace {

Vec3 normalOf(const TriangleMesh& mesh, const TriangleMesh::Triangle& t)
{
    const Vec3 normal = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    const double length = normal.norm();
    return length > 0 ? Vec3(normal / length) : Vec3(Vec3::Zero());
}

void writeBinary(const MeshFile& file, NumberStream& stream)
{
    std::string header = "Knead, lengths in " + file.unit; // must not start with "solid", which says text
    header.resize(80, ' ');
    stream.add(header);
    stream.addBinary(static_cast<std::uint32_t>(file.triangleCount));
    for (const MeshBody* body : file.bodies)
        for (const TriangleMesh::Triangle& triangle : body->mesh.triangles) {
            stream.addBinary(normalOf(body->mesh, triangle));
            for (const std::uint32_t vertex : triangle)
                stream.addBinary(Vec3(file.perMetre * body->mesh.vertices[vertex]));
            stream.addBinary(std::uint16_t{0});
        }
}

/// Readers end names at spaces, and take a file with letters beyond ASCII for binary.
std::string wordForStl(const std::string& name)
{
    std::string word = name;
    std::replace_if(
        word.begin(), word.end(), [](unsigned char c) { return c <= ' ' || c > '~'; }, '_');
    return word;
}

void writeText(const MeshFile& file, NumberStream& stream)
{
    for (std::size_t i = 0; i < file.bodies.size(); ++i) {
        const TriangleMesh& mesh = file.bodies[i]->mesh;
        const std::string name = wordForStl(file.names[i]);
        stream.add("solid " + name + " Knead, lengths in " + file.unit + "\n");
        for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
            stream.add(" facet normal");
            stream.addText(normalOf(mesh, triangle), " ");
            stream.add("\n  outer loop\n");
            for (const std::uint32_t vertex : triangle) {
                stream.add("   vertex");
                stream.addText(Vec3(file.perMetre * mesh.vertices[vertex]), " ");
                stream.add("\n");
            }
            stream.add("  endloop\n endfacet\n");
        }
        stream.add("endsolid " + name + "\n");
    }
}

} // namespace

void writeStl(const MeshFile& file)
{
    SafeFile target(file.path);
    const double bytesPerTriangle = file.isText ? 230 : 50;
    NumberStream stream(target, file.control, bytesPerTriangle * static_cast<double>(file.triangleCount));
    file.isText ? writeText(file, stream) : writeBinary(file, stream);
    stream.flush();
    target.keep();
}

} // namespace knead
