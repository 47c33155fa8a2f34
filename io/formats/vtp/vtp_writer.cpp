#include "io/files/safe_file.h"
#include "io/formats/mesh_formats.h"
#include "io/formats/number_stream.h"
#include "io/formats/threemf/color_groups.h"
#include "io/formats/xml_text.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <limits>

namespace knead {

namespace {

/// A run of numbers behind the XML.
struct Numbers {
    std::string type; ///< "Float32", ...
    std::string name;
    std::size_t components;
    std::size_t bytes;
    std::function<void(NumberStream&)> write;
};

/// The fields of all bodies, each name once, with its components.
std::vector<std::pair<std::string, std::size_t>> fieldsOf(const MeshFile& file)
{
    std::vector<std::pair<std::string, std::size_t>> fields;
    for (const MeshBody* body : file.bodies)
        for (const MeshField& field : body->fields)
            if (std::none_of(fields.begin(), fields.end(),
                             [&](const auto& known) { return known.first == field.name; }))
                fields.emplace_back(field.name, field.components);
    return fields;
}

/// VTK's XML format for surfaces: XML that says which numbers there are, and behind it the numbers.
class VtpWriter {
public:
    VtpWriter(const MeshFile& file, NumberStream& stream)
        : m_file(file)
        , m_stream(stream)
    {
    }

    void run()
    {
        m_stream.add("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Knead, lengths in " + m_file.unit +
                     " -->\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                     "header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n");
        addTexts("part names", m_file.names);
        addTexts("length unit", {m_file.unit});
        m_stream.add("</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(m_file.vertexCount) +
                     "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
                     std::to_string(m_file.triangleCount) + "\">\n");
        addSection("PointData", pointNumbers());
        addSection("CellData", cellNumbers());
        addSection("Points", {points()});
        addSection("Polys", {corners(), ends()});
        m_stream.add("</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_");
        for (const Numbers& numbers : m_numbers) {
            m_stream.addBinary(static_cast<std::uint64_t>(numbers.bytes));
            numbers.write(m_stream);
        }
        m_stream.add("\n</AppendedData>\n</VTKFile>\n");
    }

private:
    /// Texts are the numbers of their bytes, each with a 0 at its end.
    void addTexts(const std::string& name, const std::vector<std::string>& texts)
    {
        m_stream.add("<Array type=\"String\" Name=\"" + name + "\" NumberOfTuples=\"" + std::to_string(texts.size()) +
                     "\" format=\"ascii\">\n");
        for (const std::string& text : texts) {
            for (const char c : text) {
                m_stream.addText(std::size_t{static_cast<unsigned char>(c)});
                m_stream.add(" ");
            }
            m_stream.add("0\n");
        }
        m_stream.add("</Array>\n");
    }

    void addSection(const std::string& section, const std::vector<Numbers>& arrays)
    {
        m_stream.add("<" + section + ">\n");
        for (const Numbers& numbers : arrays) {
            m_stream.add("<DataArray type=\"" + numbers.type + "\" Name=\"" + xmlText(numbers.name) +
                         "\" NumberOfComponents=\"" + std::to_string(numbers.components) +
                         "\" format=\"appended\" offset=\"" + std::to_string(m_offset) + "\"/>\n");
            m_offset += sizeof(std::uint64_t) + numbers.bytes;
            m_numbers.push_back(numbers);
        }
        m_stream.add("</" + section + ">\n");
    }

    std::vector<Numbers> pointNumbers() const
    {
        std::vector<Numbers> arrays;
        for (const auto& [name, components] : fieldsOf(m_file))
            arrays.push_back({"Float32", name, components, 4 * components * m_file.vertexCount,
                              [this, name = name, components = components](NumberStream& stream) {
                                  for (const MeshBody* body : m_file.bodies)
                                      writeField(*body, name, components, stream);
                              }});
        arrays.push_back(
            partNumbers(m_file.vertexCount, [](const TriangleMesh& mesh) { return mesh.vertices.size(); }));
        return arrays;
    }

    /// What is not known of a body is no number, which viewers leave uncolored.
    static void writeField(const MeshBody& body, const std::string& name, std::size_t components, NumberStream& stream)
    {
        const std::size_t count = components * body.mesh.vertices.size();
        const auto field = std::find_if(body.fields.begin(), body.fields.end(),
                                        [&](const MeshField& one) { return one.name == name; });
        if (field == body.fields.end()) {
            for (std::size_t i = 0; i < count; ++i)
                stream.addBinary(std::numeric_limits<float>::quiet_NaN());
            return;
        }
        assert(field->components == components && field->values.size() == count);
        for (const float value : field->values)
            stream.addBinary(value);
    }

    template <typename CountOf>
    Numbers partNumbers(std::size_t count, CountOf countOf) const
    {
        return {"Int32", "part", 1, 4 * count, [this, countOf](NumberStream& stream) {
                    for (std::size_t i = 0; i < m_file.bodies.size(); ++i)
                        for (std::size_t j = 0; j < countOf(m_file.bodies[i]->mesh); ++j)
                            stream.addBinary(static_cast<std::int32_t>(i));
                }};
    }

    std::vector<Numbers> cellNumbers() const
    {
        return {partNumbers(m_file.triangleCount, [](const TriangleMesh& mesh) { return mesh.triangles.size(); }),
                {"Int32", "face", 1, 4 * m_file.triangleCount,
                 [this](NumberStream& stream) {
                     forEachTriangle([&](const MeshBody& body, std::size_t t, std::size_t) {
                         const auto& faces = body.mesh.faceOfTriangle;
                         stream.addBinary(faces.empty() ? -1 : static_cast<std::int32_t>(faces[t]));
                     });
                 }},
                {"UInt8", "color", 3, 3 * m_file.triangleCount, [this](NumberStream& stream) {
                     forEachTriangle([&](const MeshBody& body, std::size_t t, std::size_t) {
                         for (const unsigned char channel : toBytes(colorOf(body, t)))
                             stream.addBinary(channel);
                     });
                 }}};
    }

    Numbers points() const
    {
        return {"Float32", "Points", 3, 12 * m_file.vertexCount, [this](NumberStream& stream) {
                    for (const MeshBody* body : m_file.bodies)
                        for (const Vec3& vertex : body->mesh.vertices)
                            stream.addBinary(Vec3(m_file.perMetre * vertex));
                }};
    }

    Numbers corners() const
    {
        return {"Int64", "connectivity", 1, 24 * m_file.triangleCount, [this](NumberStream& stream) {
                    forEachTriangle([&](const MeshBody& body, std::size_t t, std::size_t firstVertex) {
                        for (const std::uint32_t vertex : body.mesh.triangles[t])
                            stream.addBinary(static_cast<std::int64_t>(firstVertex + vertex));
                    });
                }};
    }

    Numbers ends() const
    {
        return {"Int64", "offsets", 1, 8 * m_file.triangleCount, [this](NumberStream& stream) {
                    for (std::size_t t = 1; t <= m_file.triangleCount; ++t)
                        stream.addBinary(static_cast<std::int64_t>(3 * t));
                }};
    }

    template <typename Visit>
    void forEachTriangle(Visit&& visit) const
    {
        std::size_t firstVertex = 0;
        for (const MeshBody* body : m_file.bodies) {
            for (std::size_t t = 0; t < body->mesh.triangles.size(); ++t)
                visit(*body, t, firstVertex);
            firstVertex += body->mesh.vertices.size();
        }
    }

    const MeshFile& m_file;
    NumberStream& m_stream;
    std::vector<Numbers> m_numbers;
    std::size_t m_offset = 0;
};

} // namespace

void writeVtp(const MeshFile& file)
{
    SafeFile target(file.path);
    NumberStream stream(target, file.control,
                        16 * static_cast<double>(file.vertexCount) + 43 * static_cast<double>(file.triangleCount));
    VtpWriter(file, stream).run();
    stream.flush();
    target.keep();
}

} // namespace knead
