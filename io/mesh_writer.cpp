#include "io/mesh_writer.h"

#include "io/cad_format.h"
#include "io/safe_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr double toMm = 1e3;

// STL and binary PLY are little-endian, and so is every machine this runs on.
static_assert(std::endian::native == std::endian::little);

class Bytes {
public:
    explicit Bytes(std::size_t size) { m_text.reserve(size); }

    void add(std::string_view text) { m_text += text; }
    template <typename Number>
    void addBinary(Number number)
    {
        const auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
        m_text.append(bytes.data(), bytes.size());
    }
    void addBinary(const Vec3& v)
    {
        for (const double coordinate : v)
            addBinary(static_cast<float>(coordinate));
    }
    /// The shortest digits that give the same number again, with a point whatever the locale.
    void addText(double number)
    {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<float>(number));
        m_text.append(digits.data(), end.ptr);
    }
    void addText(std::size_t number) { m_text += std::to_string(number); }
    const std::string& text() const { return m_text; }

private:
    std::string m_text;
};

std::size_t countTriangles(const std::vector<MeshBody>& bodies)
{
    std::size_t count = 0;
    for (const MeshBody& body : bodies)
        count += body.mesh.triangles.size();
    return count;
}

std::size_t countVertices(const std::vector<MeshBody>& bodies)
{
    std::size_t count = 0;
    for (const MeshBody& body : bodies)
        count += body.mesh.vertices.size();
    return count;
}

Vec3 normalOf(const TriangleMesh& mesh, const TriangleMesh::Triangle& t)
{
    const Vec3 normal = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    const double length = normal.norm();
    return length > 0 ? Vec3(normal / length) : Vec3(Vec3::Zero());
}

void writeStl(const std::string& path, const std::vector<MeshBody>& bodies)
{
    Bytes bytes(84 + 50 * countTriangles(bodies));
    std::string header = "Knead, lengths in mm"; // must not start with "solid", which says ASCII
    header.resize(80, ' ');
    bytes.add(header);
    bytes.addBinary(static_cast<std::uint32_t>(countTriangles(bodies)));
    for (const MeshBody& body : bodies)
        for (const TriangleMesh::Triangle& triangle : body.mesh.triangles) {
            bytes.addBinary(normalOf(body.mesh, triangle));
            for (const std::uint32_t vertex : triangle)
                bytes.addBinary(Vec3(toMm * body.mesh.vertices[vertex]));
            bytes.addBinary(std::uint16_t{0});
        }
    writeFileSafely(path, bytes.text());
}

std::array<unsigned char, 3> toBytes(const Color& color)
{
    const auto byte = [](float channel) {
        return static_cast<unsigned char>(std::lround(255 * std::clamp(channel, 0.0F, 1.0F)));
    };
    return {byte(color.r), byte(color.g), byte(color.b)};
}

void writePly(const std::string& path, const std::vector<MeshBody>& bodies)
{
    Bytes bytes(400 + 15 * countVertices(bodies) + 13 * countTriangles(bodies));
    bytes.add("ply\nformat binary_little_endian 1.0\ncomment Knead, lengths in mm\nelement vertex ");
    bytes.addText(countVertices(bodies));
    bytes.add("\nproperty float x\nproperty float y\nproperty float z\n"
              "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face ");
    bytes.addText(countTriangles(bodies));
    bytes.add("\nproperty list uchar int vertex_indices\nend_header\n");
    for (const MeshBody& body : bodies)
        for (const Vec3& vertex : body.mesh.vertices) {
            bytes.addBinary(Vec3(toMm * vertex));
            for (const unsigned char channel : toBytes(body.color))
                bytes.addBinary(channel);
        }
    std::uint32_t first = 0;
    for (const MeshBody& body : bodies) {
        for (const TriangleMesh::Triangle& triangle : body.mesh.triangles) {
            bytes.addBinary(std::uint8_t{3});
            for (const std::uint32_t vertex : triangle)
                bytes.addBinary(first + vertex);
        }
        first += static_cast<std::uint32_t>(body.mesh.vertices.size());
    }
    writeFileSafely(path, bytes.text());
}

/// Readers of OBJ cut names at spaces.
std::string objName(const std::string& name)
{
    std::string word;
    for (const char c : name)
        word += static_cast<unsigned char>(c) <= ' ' || c == '#' ? '_' : c;
    return word.empty() ? "part" : word;
}

/// Objects with equal names would become one in other programs.
std::vector<std::string> uniqueObjNames(const std::vector<MeshBody>& bodies)
{
    std::vector<std::string> names;
    std::set<std::string> used;
    for (const MeshBody& body : bodies) {
        const std::string wanted = objName(body.name);
        std::string name = wanted;
        for (int i = 2; !used.insert(name).second; ++i)
            name = wanted + "_" + std::to_string(i);
        names.push_back(name);
    }
    return names;
}

/// One material per color, by the color's hexadecimal digits.
std::string materialName(const Color& color)
{
    static constexpr std::string_view digits = "0123456789abcdef";
    std::string name = "color_";
    for (const unsigned char channel : toBytes(color)) {
        name += digits[channel >> 4U];
        name += digits[channel & 15U];
    }
    return name;
}

std::string materialLibrary(const std::vector<MeshBody>& bodies)
{
    std::map<std::string, Color> materials;
    for (const MeshBody& body : bodies)
        materials.emplace(materialName(body.color), body.color);
    Bytes bytes(100 * materials.size());
    bytes.add("# Knead\n");
    for (const auto& [name, color] : materials) {
        bytes.add("newmtl " + name + "\nKd");
        for (const float channel : {color.r, color.g, color.b}) {
            bytes.add(" ");
            bytes.addText(static_cast<double>(channel));
        }
        bytes.add("\nKs 0.1 0.1 0.1\nNs 20\nd 1\nillum 2\n");
    }
    return bytes.text();
}

void writeObj(const std::string& path, const std::vector<MeshBody>& bodies)
{
    const fs::path library = fs::path(path).replace_extension(".mtl");
    Bytes bytes(40 * countVertices(bodies) + 30 * countTriangles(bodies));
    bytes.add("# Knead, lengths in mm\nmtllib " + library.filename().string() + "\n");
    const std::vector<std::string> names = uniqueObjNames(bodies);
    std::size_t first = 1;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const TriangleMesh& mesh = bodies[i].mesh;
        bytes.add("o " + names[i] + "\nusemtl " + materialName(bodies[i].color) + "\n");
        for (const Vec3& vertex : mesh.vertices) {
            bytes.add("v");
            for (const double coordinate : vertex) {
                bytes.add(" ");
                bytes.addText(toMm * coordinate);
            }
            bytes.add("\n");
        }
        for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
            bytes.add("f");
            for (const std::uint32_t vertex : triangle) {
                bytes.add(" ");
                bytes.addText(first + vertex);
            }
            bytes.add("\n");
        }
        first += mesh.vertices.size();
    }
    writeFileSafely(library.string(), materialLibrary(bodies));
    writeFileSafely(path, bytes.text());
}

std::string endingOf(const std::string& path)
{
    std::string ending = fs::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return ending;
}

} // namespace

void writeMeshes(const std::string& path, const std::vector<MeshBody>& bodies)
{
    const std::string ending = endingOf(path);
    const auto writer = ending == ".stl"   ? writeStl
                        : ending == ".obj" ? writeObj
                        : ending == ".ply" ? writePly
                                           : nullptr;
    if (writer == nullptr)
        throw std::runtime_error(shortName(path) +
                                 ": the ending is none of .stl, .obj and .ply; name the file after its format.");
    if (countTriangles(bodies) == 0)
        throw std::runtime_error(shortName(path) + ": there is no surface to write.");
    if (std::max(countVertices(bodies), countTriangles(bodies)) > UINT32_MAX)
        throw std::runtime_error(shortName(path) +
                                 ": the surface has more triangles than the format can count; export fewer bodies.");
    writer(path, bodies);
}

const std::vector<FileFormat>& exportFormats()
{
    static const std::vector<FileFormat> formats{{"STL", {"stl"}}, {"OBJ", {"obj"}}, {"PLY", {"ply"}}};
    return formats;
}

} // namespace knead
