#include "core/model/readable_name.h"
#include "io/fields/field_content.h"
#include "io/fields/text_scanner.h"
#include "io/fields/vtk_cells.h"
#include "io/fields/vtk_xml_arrays.h"
#include "io/fields/xml_scanner.h"
#include "io/files/lower_case.h"

#include <algorithm>
#include <array>

namespace knead {

namespace {

constexpr std::array<std::string_view, 8> vtkSections{"FieldData", "PointData", "Points", "Cells",
                                                      "Verts",     "Lines",     "Polys",  "CellData"};
constexpr const char* ownDisplacement = "displacement [m]"; // as Knead's export of meshes calls it

/// VTK's XML files of points: unstructured grids, surfaces and structured grids, in one piece or several.
class VtkXmlReader {
public:
    VtkXmlReader(std::string_view bytes, const FieldRequest& request, TaskControl& control)
        : m_xml(bytes)
        , m_request(request)
        , m_control(control)
    {
    }

    FieldContent run()
    {
        m_content.format = "VTK";
        while (const auto tag = m_xml.next())
            if (!take(*tag))
                break;
        readFieldData();
        m_content.steps = {m_time};
        if (!m_request.isForMesh) {
            m_content.names = namesOfVectors();
            choose(m_request.choice, m_content);
            m_content.valueUnit = unitIn(m_content.name);
            m_content.areNodesMoved = m_isOfKnead && m_content.name == ownDisplacement;
        }
        for (std::size_t i = 0; i < m_pieces.size(); ++i) {
            m_control.throwIfCancelled();
            m_control.report(static_cast<double>(i) / static_cast<double>(m_pieces.size()), "reading the file");
            readPiece(m_pieces[i]);
        }
        return std::move(m_content);
    }

private:
    using Piece = std::vector<VtkXmlArray>;

    /// @return whether there may be more
    bool take(const XmlTag& tag)
    {
        if (tag.isEnd) {
            if (tag.name == m_section)
                m_section.clear();
        } else if (tag.name == "VTKFile") {
            readHead(tag);
        } else if (tag.name == "Piece") {
            m_pieces.emplace_back();
        } else if (tag.name == "DataArray" || tag.name == "Array") {
            takeArray(tag);
        } else if (tag.name == "AppendedData") {
            takeAppended(tag);
            return false;
        } else if (std::ranges::find(vtkSections, tag.name) != vtkSections.end() && !tag.isClosed) {
            m_section = tag.name;
        }
        return true;
    }

    void readHead(const XmlTag& tag)
    {
        const std::string type = tag.attribute("type");
        if (type != "UnstructuredGrid" && type != "PolyData" && type != "StructuredGrid")
            throw Problem(Message("Field", "this VTK file is of the kind %1, which is not read; save it as an "
                                           "unstructured grid (.vtu).")
                              .with(readableName(type)));
        m_isSurface = type == "PolyData";
        m_coding.order = tag.attribute("byte_order") == "BigEndian" ? std::endian::big : std::endian::little;
        m_coding.hasLongHeaders = tag.attribute("header_type") == "UInt64";
        const std::string compressor = tag.attribute("compressor");
        if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
            throw Problem(Message("Field", "its numbers are compressed by %1, which is not read; save it with zlib or "
                                           "without compression.")
                              .with(readableName(compressor)));
        m_coding.isCompressed = !compressor.empty();
    }

    void takeArray(const XmlTag& tag)
    {
        VtkXmlArray array{.section = m_section,
                          .name = readableName(tag.attribute("Name")),
                          .type = tag.attribute("type"),
                          .format = tag.attribute("format"),
                          .text = tag.isClosed ? std::string_view() : m_xml.textHere()};
        const auto components = wholeNumberIn(tag.attribute("NumberOfComponents"));
        array.components = components && *components > 0 ? static_cast<std::size_t>(*components) : 1;
        const auto offset = wholeNumberIn(tag.attribute("offset"));
        if (array.format == "appended" && (!offset || *offset < 0))
            failAsDamaged();
        array.offset = static_cast<std::uint64_t>(offset.value_or(0));
        if (m_section == "FieldData")
            m_fieldData.push_back(std::move(array));
        else if (!m_pieces.empty())
            m_pieces.back().push_back(std::move(array));
    }

    void takeAppended(const XmlTag& tag)
    {
        std::string_view rest = m_xml.rest();
        const std::size_t mark = rest.find('_');
        if (mark == rest.npos)
            failAsDamaged();
        m_coding.appended = rest.substr(mark + 1);
        m_coding.isAppendedBase64 = tag.attribute("encoding") == "base64";
    }

    void readFieldData()
    {
        for (const VtkXmlArray& array : m_fieldData) {
            m_isOfKnead = m_isOfKnead || (m_isSurface && array.name == "part names");
            if (array.name == "length unit")
                for (const std::int64_t letter : vtkXmlWholeNumbers(array, m_coding))
                    if (letter > 0 && letter < 128)
                        m_content.unit += static_cast<char>(letter);
            if (array.name == "TimeValue" || array.name == "TIME")
                if (const auto times = vtkXmlNumbers(array, m_coding); times.size() == 1)
                    m_time = shortNumber(times.front());
        }
    }

    /// Of the points in any piece, in the order of the file; normals are none.
    std::vector<std::string> namesOfVectors() const
    {
        std::vector<std::string> names;
        for (const Piece& piece : m_pieces)
            for (const VtkXmlArray& array : piece)
                if (array.section == "PointData" && array.components == 3 && lowerCase(array.name) != "normals" &&
                    std::ranges::find(names, array.name) == names.end())
                    names.push_back(array.name);
        return names;
    }

    static const VtkXmlArray* find(const Piece& piece, std::string_view section, std::string_view name)
    {
        const auto found = std::ranges::find_if(piece, [&](const VtkXmlArray& array) {
            return array.section == section && (name.empty() || array.name == name);
        });
        return found == piece.end() ? nullptr : &*found;
    }

    void readPiece(const Piece& piece)
    {
        const VtkXmlArray* points = find(piece, "Points", {});
        if (points == nullptr)
            return;
        const std::size_t first = m_content.nodes.size();
        appendVectors(vtkXmlNumbers(*points, m_coding), m_content.nodes);
        if (m_request.isForMesh)
            return readCells(piece, static_cast<std::int64_t>(first));
        const VtkXmlArray* values = find(piece, "PointData", m_content.name);
        if (values == nullptr || values->components != 3)
            return m_content.values.resize(m_content.nodes.size(), noVector());
        appendVectors(vtkXmlNumbers(*values, m_coding), m_content.values);
        checkCount(m_content.name, m_content.values.size() - first, m_content.nodes.size() - first);
    }

    void readCells(const Piece& piece, std::int64_t firstNode)
    {
        if (const VtkXmlArray* types = find(piece, "Cells", "types"))
            appendCells(m_content.cells, firstNode, numbersIn(piece, "Cells", "connectivity"),
                        numbersIn(piece, "Cells", "offsets"), vtkXmlWholeNumbers(*types, m_coding));
        for (const char* section : {"Verts", "Lines", "Polys"})
            appendSurfaceCells(m_content.cells, section, firstNode, numbersIn(piece, section, "connectivity"),
                               numbersIn(piece, section, "offsets"));
    }

    std::vector<std::int64_t> numbersIn(const Piece& piece, const char* section, const char* name) const
    {
        const VtkXmlArray* array = find(piece, section, name);
        return array == nullptr ? std::vector<std::int64_t>() : vtkXmlWholeNumbers(*array, m_coding);
    }

    XmlScanner m_xml;
    const FieldRequest& m_request;
    TaskControl& m_control;
    FieldContent m_content;
    VtkXmlCoding m_coding;
    bool m_isSurface = false;
    bool m_isOfKnead = false; ///< written by its export of meshes: points are where they came to lie
    std::string m_section;
    std::string m_time = "0";
    std::vector<VtkXmlArray> m_fieldData;
    std::vector<Piece> m_pieces;
};

} // namespace

FieldContent readXmlVtk(std::string_view bytes, const FieldRequest& request, TaskControl& control)
{
    return VtkXmlReader(bytes, request, control).run();
}

} // namespace knead
