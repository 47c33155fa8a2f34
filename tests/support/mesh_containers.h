#pragma once

#include "support/zip_file.h"

#include <cstdint>
#include <string>

namespace knead {

/// A 3MF archive around its model, an XML text.
inline std::string threeMfOf(const std::string& model)
{
    return zipOf(
        {{"[Content_Types].xml",
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?><Types "
          "xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default Extension=\"rels\" "
          "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default "
          "Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
          "</Types>"},
         {"_rels/.rels", "<?xml version=\"1.0\" encoding=\"UTF-8\"?><Relationships "
                         "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
                         "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
                         "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
         {"3D/3dmodel.model", model}});
}

/// A GLB file: a chunk of JSON and a chunk of numbers.
inline std::string glbOf(std::string json, const std::string& numbers)
{
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto chunk = [](const std::string& content, std::uint32_t kind) {
        const std::uint32_t head[] = {static_cast<std::uint32_t>(content.size()), kind};
        return std::string(reinterpret_cast<const char*>(head), sizeof head) + content;
    };
    const std::string chunks = chunk(json, 0x4E4F534A) + chunk(numbers, 0x004E4942);
    const std::uint32_t head[] = {0x46546C67, 2, static_cast<std::uint32_t>(12 + chunks.size())};
    return std::string(reinterpret_cast<const char*>(head), sizeof head) + chunks;
}

} // namespace knead
