#include "io/material_library.h"

#include "core/aggregate/material_history.h"
#include "core/message/message.h"
#include "io/files/own_folders.h"
#include "io/files/safe_file.h"
#include "io/json/json_reader.h"
#include "io/json/json_text.h"

#include <algorithm>
#include <filesystem>

namespace knead {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> presetKeys()
{
    std::vector<std::string> keys{"id", "name", "source"};
    for (const MaterialField& field : materialFields())
        keys.emplace_back(field.key);
    return keys;
}

/// A preset states every number: a default in code would be a number without a source. Those of older files state all but what
/// came after them.
MaterialPreset readPreset(const JsonNode& node)
{
    node.allowOnly(presetKeys());
    MaterialPreset preset;
    preset.id = node.at("id").text();
    preset.name = node.at("name").text();
    preset.source = node.at("source").text();
    for (const MaterialField& field : materialFields())
        if (!isMissingInOlderFiles(field) || node.find(field.key))
            preset.material.*field.value = node.at(field.key).number(field.minimum, field.maximum);
    return preset;
}

} // namespace

std::vector<MaterialPreset> readMaterials(const std::string& path)
{
    const JsonNode root = JsonNode::readFile(path);
    root.allowOnly({"version", "materials"});
    root.at("version").integer(1, 1);

    std::vector<MaterialPreset> presets;
    for (const JsonNode& node : root.at("materials").items()) {
        MaterialPreset preset = readPreset(node);
        const auto same = [&](const MaterialPreset& other) { return other.id == preset.id; };
        if (std::any_of(presets.begin(), presets.end(), same))
            node.at("id").fail(Message("Recipe", "is used twice: \"%1\".").with(preset.id));
        presets.push_back(std::move(preset));
    }
    return presets;
}

std::string ownMaterialsFile()
{
    return ownFolder("XDG_CONFIG_HOME", ".config") + "/knead/materials.json";
}

std::vector<MaterialPreset> readOwnMaterials(const std::string& path)
{
    std::error_code error;
    return fs::exists(path, error) ? readMaterials(path) : std::vector<MaterialPreset>{};
}

void writeMaterials(const std::string& path, const std::vector<MaterialPreset>& presets)
{
    std::error_code error; // told by the writing
    fs::create_directories(fs::path(path).parent_path(), error);
    std::vector<std::string> materials;
    for (const MaterialPreset& preset : presets) {
        ObjectText object;
        object.text("id", preset.id).text("name", preset.name).text("source", preset.source);
        for (const MaterialField& field : materialFields())
            object.number(field.key, preset.material.*field.value);
        materials.push_back(object.take());
    }
    writeFileSafely(path, PageText().put("version", "1").list("materials", materials).take());
}

} // namespace knead
