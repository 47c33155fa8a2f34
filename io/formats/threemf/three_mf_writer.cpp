#include "core/message/message.h"
#include "core/model/length_units.h"
#include "io/files/safe_file.h"
#include "io/formats/cad_format.h"
#include "io/formats/mesh_formats.h"
#include "io/formats/number_stream.h"
#include "io/formats/threemf/color_groups.h"
#include "io/formats/threemf/zip_writer.h"
#include "io/formats/xml_text.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

constexpr std::string_view contentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
)";
constexpr std::string_view relations =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
)";

/// As the 3MF Core Specification 1.3 calls it, section 3.4.
std::string_view unitName(const MeshFile& file)
{
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> names{{{"um", "micron"},
                                                                                         {"mm", "millimeter"},
                                                                                         {"cm", "centimeter"},
                                                                                         {"inch", "inch"},
                                                                                         {"ft", "foot"},
                                                                                         {"m", "meter"}}};
    const auto* const found =
        std::find_if(names.begin(), names.end(), [&](const auto& name) { return name.first == file.unit; });
    if (found == names.end())
        throw Problem(aboutFile(
            file.path,
            Message("Export", "3MF does not know the length unit %1; choose one of um, mm, cm, inch, ft and m.")
                .with(file.unit)));
    return found->second;
}

class ThreeMfModel {
public:
    ThreeMfModel(const MeshFile& file, NumberStream& stream)
        : m_file(file)
        , m_stream(stream)
        , m_palette(file.bodies)
    {
    }

    void write()
    {
        m_stream.add("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"");
        m_stream.add(unitName(m_file));
        m_stream.add("\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
                     "<metadata name=\"Application\">Knead</metadata>\n<resources>\n");
        writeMaterials();
        for (std::size_t i = 0; i < m_file.bodies.size(); ++i)
            writeObject(i);
        m_stream.add("</resources>\n<build>\n");
        for (std::size_t i = 0; i < m_file.bodies.size(); ++i)
            m_stream.add("<item objectid=\"" + std::to_string(objectId(i)) + "\"/>\n");
        m_stream.add("</build>\n</model>\n");
    }

private:
    static std::size_t objectId(std::size_t body) { return body + 2; } // 1 are the materials

    void writeMaterials()
    {
        m_stream.add("<basematerials id=\"1\">\n");
        for (const Color& color : m_palette.colors)
            m_stream.add("<base name=\"" + materialName(color) + "\" displaycolor=\"#" + hexDigits(color) + "\"/>\n");
        m_stream.add("</basematerials>\n");
    }

    void writeObject(std::size_t i)
    {
        const MeshBody& body = *m_file.bodies[i];
        m_stream.add("<object id=\"" + std::to_string(objectId(i)) + "\" type=\"model\" name=\"" +
                     xmlText(m_file.names[i]) + "\" pid=\"1\" pindex=\"" +
                     std::to_string(m_palette.placeOf(body.color)) + "\"><mesh><vertices>\n");
        for (const Vec3& vertex : body.mesh.vertices)
            writeVertex(m_file.perMetre * vertex);
        m_stream.add("</vertices><triangles>\n");
        const ColorGroups colors = groupByColor(body);
        for (const ColorGroups::Group& group : colors.groups) {
            const bool isUsual = toBytes(group.color) == toBytes(body.color);
            const std::string color =
                isUsual ? "" : " pid=\"1\" p1=\"" + std::to_string(m_palette.placeOf(group.color)) + "\"";
            for (std::size_t t = group.begin; t < group.end; ++t)
                writeTriangle(body.mesh.triangles[colors.triangle(t)], color);
        }
        m_stream.add("</triangles></mesh></object>\n");
    }

    void writeVertex(const Vec3& v)
    {
        m_stream.add("<vertex x=\"");
        m_stream.addText(v.x());
        m_stream.add("\" y=\"");
        m_stream.addText(v.y());
        m_stream.add("\" z=\"");
        m_stream.addText(v.z());
        m_stream.add("\"/>\n");
    }

    void writeTriangle(const TriangleMesh::Triangle& triangle, std::string_view color)
    {
        m_stream.add("<triangle v1=\"");
        m_stream.addText(std::size_t{triangle[0]});
        m_stream.add("\" v2=\"");
        m_stream.addText(std::size_t{triangle[1]});
        m_stream.add("\" v3=\"");
        m_stream.addText(std::size_t{triangle[2]});
        m_stream.add("\"");
        m_stream.add(color);
        m_stream.add("/>\n");
    }

    const MeshFile& m_file;
    NumberStream& m_stream;
    Palette m_palette;
};

void writeArchive(const MeshFile& file, SafeFile& target)
{
    ZipWriter zip(target);
    zip.beginFile("[Content_Types].xml");
    zip.write(contentTypes);
    zip.beginFile("_rels/.rels");
    zip.write(relations);
    zip.beginFile("3D/3dmodel.model");
    NumberStream stream(zip, file.control,
                        57 * static_cast<double>(file.vertexCount) + 42 * static_cast<double>(file.triangleCount));
    ThreeMfModel(file, stream).write();
    stream.flush();
    zip.finish();
}

} // namespace

void writeThreeMf(const MeshFile& file)
{
    SafeFile target(file.path);
    try {
        writeArchive(file, target);
    } catch (const std::length_error&) {
        throw Problem(aboutFile(
            file.path,
            Message("Export", "the surface needs more than the 4 GB that a 3MF can hold; export fewer bodies.")));
    }
    target.keep();
}

} // namespace knead
