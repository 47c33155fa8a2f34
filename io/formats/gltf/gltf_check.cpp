#include "io/formats/gltf/gltf_check.h"

#include "core/message/message.h"
#include "core/model/readable_name.h"
#include "io/files/neighbor_file.h"
#include "io/formats/cad_format.h"

#include <nlohmann/json.hpp>

#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace knead {

namespace {

using Json = nlohmann::json;

constexpr std::size_t deepestNodes = 500; // of nodes; the mesh reader recurses once a level
Message damaged()
{
    return Message("Import", "the %1 file is damaged and cannot be read; export it again.").with("glTF");
}

/// The JSON is all of a .gltf, and the first chunk of a .glb (glTF 2.0, section 4.4).
std::string jsonText(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (file.peek() != 'g')
        return {std::istreambuf_iterator<char>(file), {}};
    std::uint32_t header[5] = {};
    file.read(reinterpret_cast<char*>(header), sizeof header);
    const std::uintmax_t size = std::filesystem::file_size(path);
    const std::uint32_t total = header[2];
    const std::uint32_t length = header[3];
    if (!file || header[1] != 2)
        failReading(
            path, Message("Import", "the GLB is damaged, or of another version than 2; export it again as glTF 2.0."));
    if (total > size || length > size - sizeof header || std::memcmp(&header[4], "JSON", 4) != 0)
        failReading(path, Message("Import", "the GLB is cut off or damaged; get it again."));
    std::string text(length, '\0');
    file.read(text.data(), static_cast<std::streamsize>(length));
    return text;
}

std::string textAt(const Json& json, const char* key)
{
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

const Json& listAt(const Json& json, const char* key)
{
    static const Json none = Json::array();
    const auto found = json.find(key);
    return found != json.end() && found->is_array() ? *found : none;
}

void checkVersionAndExtensions(const std::string& path, const Json& json)
{
    const auto asset = json.find("asset");
    const std::string version = asset != json.end() && asset->is_object() ? textAt(*asset, "version") : "";
    if (!version.starts_with("2."))
        failReading(
            path,
            version.empty()
                ? Message("Import",
                          "this is a glTF of version unknown, but only 2 can be read; export it again as glTF 2.0.")
                : Message("Import",
                          "this is a glTF of version %1, but only 2 can be read; export it again as glTF 2.0.")
                      .with(readableName(std::string_view(version))));
    for (const Json& extension : listAt(json, "extensionsRequired")) {
        const std::string name = extension.is_string() ? extension.get<std::string>() : "";
        if (name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression")
            failReading(
                path,
                Message("Import", "the glTF is compressed (%1), which is not read here; export it without compression.")
                    .with(name));
    }
}

/// Files beside it are named by URIs in which %20 stands for a space.
std::string fromUri(const std::string& uri)
{
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[i + 1])) != 0 &&
            std::isxdigit(static_cast<unsigned char>(uri[i + 2])) != 0) {
            text += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

void checkBuffers(const std::string& path, const Json& json)
{
    for (const Json& buffer : listAt(json, "buffers")) {
        const std::string uri = buffer.is_object() ? textAt(buffer, "uri") : "";
        if (uri.empty() || uri.starts_with("data:"))
            continue;
        if (!isNeighborFile(std::filesystem::path(path).parent_path() / fromUri(uri), path))
            failReading(path,
                        Message("Import", "the glTF keeps its numbers in \"%1\", which is not beside it; put it there.")
                            .with(readableName(std::string_view(fromUri(uri)))));
    }
}

/// Each node has one parent at most, and none is above itself (glTF 2.0, section 3.5.2).
void checkNodes(const std::string& path, const Json& json)
{
    const Json& nodes = listAt(json, "nodes");
    std::vector<std::size_t> parents(nodes.size(), nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].is_object())
            failReading(path, damaged());
        for (const Json& child : listAt(nodes[i], "children")) {
            if (!child.is_number_unsigned() || child.get<std::size_t>() >= nodes.size())
                failReading(path, damaged());
            std::size_t& parent = parents[child.get<std::size_t>()];
            if (parent != nodes.size())
                failReading(
                    path,
                    Message("Import", "a node of the glTF is in two others; the file is damaged, export it again."));
            parent = i;
        }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        std::size_t depth = 0;
        for (std::size_t above = i; above != nodes.size(); above = parents[above])
            if (++depth > deepestNodes)
                failReading(
                    path, Message("Import",
                                  "nodes of the glTF hold themselves or are nested more than %1 deep; export it again.")
                              .with(deepestNodes));
    }
}

} // namespace

void checkGltf(const std::string& path)
{
    const Json json = Json::parse(jsonText(path), nullptr, false);
    if (!json.is_object())
        failReading(path, Message("Import", "the glTF file is cut off or damaged; get it again."));
    checkVersionAndExtensions(path, json);
    checkBuffers(path, json);
    checkNodes(path, json);
}

} // namespace knead
