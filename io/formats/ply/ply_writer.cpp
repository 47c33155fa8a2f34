#include "io/files/safe_file.h"
#include "io/formats/mesh_formats.h"
#include "io/formats/number_stream.h"
#include "io/formats/threemf/color_groups.h"

#include <algorithm>

namespace knead {

namespace {

/// Vertices have the color of their body, which many readers know; triangles have colors too when faces have.
class PlyWriter {
public:
    PlyWriter(const MeshFile& file, NumberStream& stream)
        : m_file(file)
        , m_stream(stream)
        , m_hasFaceColors(std::any_of(file.bodies.begin(), file.bodies.end(),
                                      [](const MeshBody* body) { return hasFaceColors(*body); }))
    {
    }

    void run()
    {
        writeHeader();
        for (const MeshBody* body : m_file.bodies)
            for (const Vec3& vertex : body->mesh.vertices)
                addVertex(m_file.perMetre * vertex, toBytes(body->color));
        std::size_t first = 0;
        for (const MeshBody* body : m_file.bodies) {
            for (std::size_t t = 0; t < body->mesh.triangles.size(); ++t)
                addTriangle(*body, t, first);
            first += body->mesh.vertices.size();
        }
    }

private:
    void writeHeader()
    {
        const std::string colors = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
        m_stream.add(m_file.isText ? "ply\nformat ascii 1.0\n" : "ply\nformat binary_little_endian 1.0\n");
        m_stream.add("comment Knead, lengths in " + m_file.unit + "\n");
        m_stream.add("element vertex " + std::to_string(m_file.vertexCount) +
                     "\nproperty float x\nproperty float y\nproperty float z\n" + colors);
        m_stream.add("element face " + std::to_string(m_file.triangleCount) +
                     "\nproperty list uchar int vertex_indices\n" + (m_hasFaceColors ? colors : "") + "end_header\n");
    }

    void addVertex(const Vec3& place, const ColorBytes& color)
    {
        if (m_file.isText) {
            m_stream.addText(place.x());
            m_stream.add(" ");
            m_stream.addText(place.y());
            m_stream.add(" ");
            m_stream.addText(place.z());
        } else {
            m_stream.addBinary(place);
        }
        addColor(color);
        endLine();
    }

    void addTriangle(const MeshBody& body, std::size_t triangle, std::size_t first)
    {
        if (m_file.isText)
            m_stream.add("3");
        else
            m_stream.addBinary(std::uint8_t{3});
        for (const std::uint32_t vertex : body.mesh.triangles[triangle]) {
            if (m_file.isText) {
                m_stream.add(" ");
                m_stream.addText(first + vertex);
            } else {
                m_stream.addBinary(static_cast<std::int32_t>(first + vertex));
            }
        }
        if (m_hasFaceColors)
            addColor(toBytes(colorOf(body, triangle)));
        endLine();
    }

    void addColor(const ColorBytes& color)
    {
        for (const unsigned char channel : color) {
            if (m_file.isText) {
                m_stream.add(" ");
                m_stream.addText(std::size_t{channel});
            } else {
                m_stream.addBinary(channel);
            }
        }
    }

    void endLine()
    {
        if (m_file.isText)
            m_stream.add("\n");
    }

    const MeshFile& m_file;
    NumberStream& m_stream;
    bool m_hasFaceColors;
};

} // namespace

void writePly(const MeshFile& file)
{
    SafeFile target(file.path);
    const double perVertex = file.isText ? 44 : 15;
    const double perTriangle = file.isText ? 24 : 13;
    NumberStream stream(target, file.control,
                        perVertex * static_cast<double>(file.vertexCount) +
                            perTriangle * static_cast<double>(file.triangleCount));
    PlyWriter(file, stream).run();
    stream.flush();
    target.keep();
}

} // namespace knead
