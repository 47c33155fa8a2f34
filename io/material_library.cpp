#include "io/material_library.h"

#include "io/json_reader.h"

#include <algorithm>

namespace knead {

namespace {

std::vector<std::string> presetKeys()
{
    std::vector<std::string> keys{"id", "name", "source"};
    for (const MaterialField& field : materialFields())
        keys.emplace_back(field.key);
    return keys;
}

/// A preset states every number: a default in code would be a number without a source.
MaterialPreset readPreset(const JsonNode& node)
{
    node.allowOnly(presetKeys());
    MaterialPreset preset;
    preset.id = node.at("id").text();
    preset.name = node.at("name").text();
    preset.source = node.at("source").text();
    for (const MaterialField& field : materialFields())
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
            node.at("id").fail("is used twice: \"" + preset.id + "\".");
        presets.push_back(std::move(preset));
    }
    return presets;
}

} // namespace knead
