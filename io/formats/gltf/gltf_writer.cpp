#include "core/message/message.h"
#include "io/files/safe_file.h"
#include "io/formats/cad_format.h"
#include "io/formats/mesh_formats.h"
#include "io/formats/number_stream.h"
#include "io/formats/split_vertices.h"
#include "io/formats/vtp/base64_sink.h"
#include "io/picture/srgb.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace knead {

namespace {

using nlohmann::json;
using Upright = Eigen::Vector3f;

constexpr std::size_t bytesPerVertex = 24;

/// In glTF y is up (glTF 2.0, section 3.4), in CAD z is.
Upright upright(const Vec3& v)
{
    return {static_cast<float>(v.x()), static_cast<float>(v.z()), static_cast<float>(-v.y())};
}

/// The colors of a glTF are linear (glTF 2.0, section 3.9.2), ours are sRGB.
json materialOf(const Color& color)
{
    return {{"name", materialName(color)},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {toLinear(color.r), toLinear(color.g), toLinear(color.b), 1}},
              {"metallicFactor", 0},
              {"roughnessFactor", 0.6}}}};
}

/// What a glTF says about its numbers; their bytes follow in the same order.
class GltfDescription {
public:
    explicit GltfDescription(const MeshFile& file)
        : m_palette(file.bodies)
    {
        for (const Color& color : m_palette.colors)
            m_root["materials"].push_back(materialOf(color));
        m_root["asset"] = {{"version", "2.0"}, {"generator", "Knead"}};
        m_root["scene"] = 0;
        json nodes = json::array();
        for (std::size_t i = 0; i < file.bodies.size(); ++i) {
            file.control.throwIfCancelled();
            addMesh(*file.bodies[i], file.names[i]);
            m_root["nodes"].push_back({{"name", file.names[i]}, {"mesh", i}});
            nodes.push_back(i);
        }
        m_root["scenes"] = json::array({{{"nodes", nodes}}});
    }

    std::size_t bytes() const { return m_bytes; }

    /// The text, with a buffer whose bytes lie at `uri`, or beside the text when it is empty. It ends within that.
    std::string textUntil(const std::string& uri) const
    {
        std::string text = m_root.dump();
        text.pop_back();
        text += ",\"buffers\":[{\"byteLength\":" + std::to_string(m_bytes);
        return uri.empty() ? text : text + ",\"uri\":\"" + uri;
    }

private:
    void addMesh(const MeshBody& body, const std::string& name)
    {
        json primitives = json::array();
        SplitVertices vertices(body);
        for (const ColorGroups::Group& group : vertices.groups()) {
            vertices.choose(group);
            const auto [positions, normals] = addVertices(vertices);
            const std::size_t indices = addAccessor({{"bufferView", addView(12 * (group.end - group.begin), 34963)},
                                                     {"componentType", 5125},
                                                     {"count", 3 * (group.end - group.begin)},
                                                     {"type", "SCALAR"}});
            primitives.push_back({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                                  {"indices", indices},
                                  {"material", m_palette.placeOf(group.color)}});
        }
        m_root["meshes"].push_back({{"name", name}, {"primitives", primitives}});
    }

    /// Places and normals lie side by side. @return their accessors
    std::pair<std::size_t, std::size_t> addVertices(const SplitVertices& vertices)
    {
        Eigen::AlignedBox3f box;
        vertices.forEachPlace([&](const Vec3& place) { box.extend(upright(place)); });
        const auto numbers = [](const Upright& v) { return json{v.x(), v.y(), v.z()}; };
        const std::size_t view = addView(bytesPerVertex * vertices.size(), 34962);
        m_root["bufferViews"][view]["byteStride"] = bytesPerVertex;
        const json each{{"bufferView", view}, {"componentType", 5126}, {"count", vertices.size()}, {"type", "VEC3"}};
        json places = each;
        places.update({{"min", numbers(box.min())}, {"max", numbers(box.max())}});
        json normals = each;
        normals["byteOffset"] = bytesPerVertex / 2;
        return {addAccessor(places), addAccessor(normals)};
    }

    std::size_t addAccessor(const json& accessor)
    {
        m_root["accessors"].push_back(accessor);
        return m_root["accessors"].size() - 1;
    }

    /// A run of bytes. @param target of the graphics card: vertices or indices
    std::size_t addView(std::size_t bytes, int target)
    {
        m_root["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", m_bytes}, {"byteLength", bytes}, {"target", target}});
        m_bytes += bytes;
        return m_root["bufferViews"].size() - 1;
    }

    Palette m_palette;
    json m_root;
    std::size_t m_bytes = 0;
};

void writeNumbers(const MeshFile& file, NumberStream& stream)
{
    for (const MeshBody* body : file.bodies) {
        SplitVertices vertices(*body);
        for (const ColorGroups::Group& group : vertices.groups()) {
            vertices.choose(group);
            vertices.forEachVertex([&](const Vec3& place, const Eigen::Vector3f& normal) {
                for (const float coordinate : upright(place))
                    stream.addBinary(coordinate);
                for (const float coordinate : upright(normal.cast<double>()))
                    stream.addBinary(coordinate);
            });
            vertices.forEachIndex([&](std::uint32_t index) { stream.addBinary(index); });
        }
    }
}

} // namespace

void writeGltf(const MeshFile& file)
{
    const GltfDescription description(file);
    SafeFile target(file.path);
    target.write(description.textUntil("data:application/octet-stream;base64,"));
    Base64Sink base64(target);
    NumberStream stream(base64, file.control, static_cast<double>(description.bytes()));
    writeNumbers(file, stream);
    stream.flush();
    base64.finish();
    target.write("\"}]}");
    target.keep();
}

void writeGlb(const MeshFile& file)
{
    const GltfDescription description(file);
    std::string text = description.textUntil("") + "}]}";
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t size = 12 + 8 + text.size() + 8 + description.bytes(); // glTF 2.0, section 4.4
    if (size > std::numeric_limits<std::uint32_t>::max())
        throw Problem(aboutFile(
            file.path,
            Message("Export",
                    "the surface needs more than the 4 GB that a GLB can hold; export fewer bodies, or .gltf.")));
    SafeFile target(file.path);
    NumberStream stream(target, file.control, static_cast<double>(size));
    for (const std::size_t number :
         {std::size_t{0x46546C67}, std::size_t{2}, size, text.size(), std::size_t{0x4E4F534A}})
        stream.addBinary(static_cast<std::uint32_t>(number));
    stream.add(text);
    for (const std::size_t number : {description.bytes(), std::size_t{0x004E4942}})
        stream.addBinary(static_cast<std::uint32_t>(number));
    writeNumbers(file, stream);
    stream.flush();
    target.keep();
}

} // namespace knead
