#include "io/fields/field_bytes.h"

#include "io/files/byte_blocks.h"
#include "io/json/message_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace knead {

namespace {

using Json = nlohmann::json;

std::string textOf(const Json& json)
{
    return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

/// Calls read(json) and says of what is no such document that it is damaged.
template <typename Read>
void readJson(BlockReader& blocks, Read&& read)
{
    try {
        read(Json::parse(blocks.next()));
    } catch (const Json::exception&) {
        blocks.fail("its head is damaged");
    }
}

bool areFinite(const std::vector<Vec3>& vectors)
{
    return std::ranges::all_of(vectors, [](const Vec3& v) { return v.allFinite(); });
}

} // namespace

std::string fieldToBytes(const FieldFile& file)
{
    BlockWriter blocks;
    blocks.add(textOf({{"path", file.path},
                       {"format", file.format},
                       {"steps", file.steps},
                       {"names", file.names},
                       {"step", file.step},
                       {"name", file.name},
                       {"unit", file.unit},
                       {"warnings", toJson(file.warnings)}}));
    blocks.add(file.field.nodes);
    blocks.add(file.field.displacements);
    return std::move(blocks).bytes();
}

FieldFile fieldFromBytes(std::string_view bytes)
{
    BlockReader blocks(bytes, "field");
    FieldFile file;
    readJson(blocks, [&](const Json& json) {
        file.path = json.at("path").get<std::string>();
        file.format = json.at("format").get<std::string>();
        file.steps = json.at("steps").get<std::vector<std::string>>();
        file.names = json.at("names").get<std::vector<std::string>>();
        file.step = json.at("step").get<std::size_t>();
        file.name = json.at("name").get<std::string>();
        file.unit = json.at("unit").get<std::string>();
        file.warnings = messagesFrom(json.at("warnings"));
    });
    file.field.nodes = blocks.nextArray<Vec3>();
    file.field.displacements = blocks.nextArray<Vec3>();
    if (file.step >= file.steps.size() || file.field.nodes.size() != file.field.displacements.size() ||
        !areFinite(file.field.nodes) || !areFinite(file.field.displacements))
        blocks.fail("its arrays do not go together");
    return file;
}

std::string meshToBytes(const NodalMesh& mesh)
{
    BlockWriter blocks;
    blocks.add(textOf(
        {{"path", mesh.path}, {"format", mesh.format}, {"unit", mesh.unit}, {"warnings", toJson(mesh.warnings)}}));
    blocks.add(mesh.nodes);
    blocks.add(mesh.labels);
    blocks.add(mesh.cells.connectivity);
    blocks.add(mesh.cells.offsets);
    blocks.add(mesh.cells.types);
    blocks.add(mesh.cells.labels);
    blocks.add(mesh.cells.points);
    return std::move(blocks).bytes();
}

NodalMesh meshFromBytes(std::string_view bytes)
{
    BlockReader blocks(bytes, "mesh");
    NodalMesh mesh;
    readJson(blocks, [&](const Json& json) {
        mesh.path = json.at("path").get<std::string>();
        mesh.format = json.at("format").get<std::string>();
        mesh.unit = json.at("unit").get<std::string>();
        mesh.warnings = messagesFrom(json.at("warnings"));
    });
    mesh.nodes = blocks.nextArray<Vec3>();
    mesh.labels = blocks.nextArray<std::int64_t>();
    mesh.cells.connectivity = blocks.nextArray<std::int64_t>();
    mesh.cells.offsets = blocks.nextArray<std::int64_t>();
    mesh.cells.types = blocks.nextArray<std::uint8_t>();
    mesh.cells.labels = blocks.nextArray<std::int64_t>();
    mesh.cells.points = blocks.nextArray<std::uint8_t>();
    const auto& offsets = mesh.cells.offsets;
    const auto nodes = static_cast<std::int64_t>(mesh.nodes.size());
    const bool hasCells = !mesh.cells.isEmpty();
    const auto isPerCell = [&](const auto& values) {
        return values.empty() || values.size() == mesh.cells.types.size();
    };
    const bool isSound =
        areFinite(mesh.nodes) && (mesh.labels.empty() || mesh.labels.size() == mesh.nodes.size()) &&
        isPerCell(mesh.cells.labels) && isPerCell(mesh.cells.points) &&
        (!hasCells || (offsets.size() == mesh.cells.types.size() + 1 && offsets.front() == 0 &&
                       offsets.back() == static_cast<std::int64_t>(mesh.cells.connectivity.size()) &&
                       std::ranges::is_sorted(offsets))) &&
        std::ranges::all_of(mesh.cells.connectivity, [&](std::int64_t node) { return node >= 0 && node < nodes; });
    if (!isSound)
        blocks.fail("its arrays do not go together");
    return mesh;
}

} // namespace knead
