#include "io/fields/field_writer.h"

#include "core/model/file_formats.h"
#include "core/model/length_units.h"
#include "io/files/safe_file.h"
#include "io/formats/cad_format.h"
#include "io/formats/number_stream.h"
#include "io/formats/xml_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>

namespace knead {

namespace {

constexpr std::array<const char*, 3> axes{"x", "y", "z"};
constexpr std::array<const char*, 6> tensorAxes{"xx", "yy", "zz", "xy", "yz", "xz"};
constexpr std::uint8_t vertexCell = 1;

/// The shortest digits that are the same number again.
void addDigits(NumberStream& stream, double number)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    stream.add({text.data(), static_cast<std::size_t>(end - text.data())});
}

double perMetre(const NodalFields& fields)
{
    return 1 / findLengthUnit(fields.unit)->metres;
}

void check(const std::string& path, const NodalFields& fields)
{
    const auto fail = [&](const std::string& name) {
        failReading(
            path,
            Message("Field", "%1 has another number of values than there are nodes; nothing was written.").with(name));
    };
    if (findLengthUnit(fields.unit) == nullptr)
        failReading(path, Message("Unit", "the length unit \"%1\" that was asked for is not known; known are %2.")
                              .with(fields.unit, lengthUnitNames()));
    if (!fields.labels.empty() && fields.labels.size() != fields.nodes.size())
        fail("node");
    for (const NodalFields::Array& array : fields.arrays)
        if (array.components < 1 ||
            array.values.size() != fields.nodes.size() * static_cast<std::size_t>(array.components))
            fail(array.name);
}

/// VTK's XML for unstructured grids: XML that says which numbers there are, and behind it the numbers.
class VtuWriter {
public:
    VtuWriter(const NodalFields& fields, NumberStream& stream)
        : m_fields(fields)
        , m_stream(stream)
    {
    }

    void run()
    {
        const std::size_t nodes = m_fields.nodes.size();
        const std::size_t cells = m_fields.cells.isEmpty() ? nodes : m_fields.cells.types.size();
        m_stream.add("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                     "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n");
        addUnit();
        m_stream.add("</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(nodes) + "\" NumberOfCells=\"" +
                     std::to_string(cells) + "\">\n<PointData>\n");
        for (const NodalFields::Array& array : m_fields.arrays)
            announce("Float64", array.name, static_cast<std::size_t>(array.components), 8 * array.values.size(),
                     [&array, this] { addAll(array.values); });
        if (!m_fields.labels.empty())
            announce("Int64", "node", 1, 8 * nodes, [this] { addAll(m_fields.labels); });
        m_stream.add("</PointData>\n<Points>\n");
        announce("Float64", "Points", 3, 24 * nodes, [this] { addNodes(); });
        m_stream.add("</Points>\n<Cells>\n");
        m_fields.cells.isEmpty() ? announceVertices() : announceCells();
        m_stream.add("</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
        for (const auto& write : m_arrays)
            write();
        m_stream.add("\n</AppendedData>\n</VTKFile>\n");
    }

private:
    void addUnit()
    {
        m_stream.add("<Array type=\"String\" Name=\"length unit\" NumberOfTuples=\"1\" format=\"ascii\">\n");
        for (const char letter : m_fields.unit) {
            m_stream.addText(std::size_t{static_cast<unsigned char>(letter)});
            m_stream.add(" ");
        }
        m_stream.add("0\n</Array>\n");
    }

    void announce(const std::string& type, const std::string& name, std::size_t components, std::size_t bytes,
                  const std::function<void()>& write)
    {
        m_stream.add("<DataArray type=\"" + type + "\" Name=\"" + xmlText(name) + "\" NumberOfComponents=\"" +
                     std::to_string(components) + "\" format=\"appended\" offset=\"" + std::to_string(m_offset) +
                     "\"/>\n");
        m_offset += sizeof(std::uint64_t) + bytes;
        m_arrays.push_back([this, bytes, write] {
            m_stream.addBinary(static_cast<std::uint64_t>(bytes));
            write();
        });
    }

    void announceCells()
    {
        const NodalCells& cells = m_fields.cells;
        announce("Int64", "connectivity", 1, 8 * cells.connectivity.size(), [&, this] { addAll(cells.connectivity); });
        announce("Int64", "offsets", 1, 8 * cells.types.size(), [&, this] {
            for (std::size_t cell = 1; cell < cells.offsets.size(); ++cell)
                m_stream.addBinary(cells.offsets[cell]);
        });
        announce("UInt8", "types", 1, cells.types.size(), [&, this] { addAll(cells.types); });
    }

    void announceVertices()
    {
        const std::size_t count = m_fields.nodes.size();
        for (const std::int64_t first : {0, 1})
            announce("Int64", first == 0 ? "connectivity" : "offsets", 1, 8 * count, [this, count, first] {
                for (std::size_t i = 0; i < count; ++i)
                    m_stream.addBinary(first + static_cast<std::int64_t>(i));
            });
        announce("UInt8", "types", 1, count, [this, count] {
            for (std::size_t i = 0; i < count; ++i)
                m_stream.addBinary(vertexCell);
        });
    }

    template <typename Number>
    void addAll(const std::vector<Number>& numbers)
    {
        for (const Number number : numbers)
            m_stream.addBinary(number);
    }

    void addNodes()
    {
        const double scale = perMetre(m_fields);
        for (const Vec3& node : m_fields.nodes)
            for (const double coordinate : node)
                m_stream.addBinary(scale * coordinate);
    }

    const NodalFields& m_fields;
    NumberStream& m_stream;
    std::size_t m_offset = 0;
    std::vector<std::function<void()>> m_arrays;
};

/// "displacement x [mm]" of "displacement [mm]", behind a comma.
void addHeading(NumberStream& stream, const NodalFields::Array& array, std::size_t component)
{
    std::string name = array.name;
    std::erase_if(name, [](char c) { return c == ',' || c == '"' || c == '\n' || c == '\r'; });
    stream.add(",");
    if (array.components == 1)
        return stream.add(name);
    const std::size_t unit = std::min(name.rfind(" ["), name.size());
    stream.add(std::string_view(name).substr(0, unit));
    stream.add(" ");
    if (array.components == 3)
        stream.add(axes[component]);
    else if (array.components == 6)
        stream.add(tensorAxes[component]);
    else
        stream.addText(component + 1);
    stream.add(std::string_view(name).substr(unit));
}

/// What is not known stays empty.
void addCell(NumberStream& stream, double number)
{
    stream.add(",");
    if (std::isfinite(number))
        addDigits(stream, number);
}

void writeTable(const NodalFields& fields, NumberStream& stream)
{
    const double scale = perMetre(fields);
    stream.add("node");
    for (const char* axis : {",X [", ",Y [", ",Z ["}) {
        stream.add(axis);
        stream.add(fields.unit);
        stream.add("]");
    }
    for (const NodalFields::Array& array : fields.arrays)
        for (std::size_t i = 0; i < static_cast<std::size_t>(array.components); ++i)
            addHeading(stream, array, i);
    for (std::size_t node = 0; node < fields.nodes.size(); ++node) {
        stream.add("\n");
        const auto number = static_cast<std::int64_t>(node + 1);
        stream.add(std::to_string(fields.labels.empty() ? number : fields.labels[node]));
        for (const double coordinate : fields.nodes[node])
            addCell(stream, scale * coordinate);
        for (const NodalFields::Array& array : fields.arrays) {
            const auto components = static_cast<std::size_t>(array.components);
            for (std::size_t i = 0; i < components; ++i)
                addCell(stream, array.values[components * node + i]);
        }
    }
    stream.add("\n");
}

} // namespace

void writeFields(const std::string& path, const NodalFields& fields, TaskControl& control)
{
    const std::string ending = lowerCaseEnding(path);
    if (ending != "vtu" && ending != "csv")
        failReading(path, Message("Field", "fields at nodes are written to .vtu and .csv files."));
    check(path, fields);
    double numbers = 5 * static_cast<double>(fields.nodes.size());
    for (const NodalFields::Array& array : fields.arrays)
        numbers += static_cast<double>(array.values.size());
    SafeFile target(path);
    NumberStream stream(target, control, 12 * numbers);
    if (ending == "vtu")
        VtuWriter(fields, stream).run();
    else
        writeTable(fields, stream);
    stream.flush();
    target.keep();
}

} // namespace knead
