#include "core/model/readable_name.h"
#include "io/fields/field_content.h"
#include "io/fields/text_scanner.h"
#include "io/fields/vtk_cells.h"
#include "io/fields/vtk_legacy_numbers.h"
#include "io/files/lower_case.h"

#include <algorithm>
#include <array>
#include <optional>

namespace knead {

namespace {

/// Names and places of vectors, to be read when one is chosen.
struct LegacyVectors {
    std::string name;
    LegacyTypeName type;
    std::size_t tuples = 0;
    std::size_t place = 0;
};

/// VTK's older format: keywords, and behind them numbers as text or as bytes, highest first.
class VtkLegacyReader {
public:
    VtkLegacyReader(std::string_view bytes, const FieldRequest& request, TaskControl& control)
        : m_request(request)
        , m_text(bytes, control)
    {
    }

    FieldContent run()
    {
        m_content.format = "VTK";
        m_text.line(); // "# vtk DataFile Version 4.2"
        m_text.line(); // the title
        const std::string coding = lowerCase(std::string(m_text.word()));
        if (coding != "ascii" && coding != "binary")
            m_text.failHere();
        m_numbers.setBinary(coding == "binary");
        for (std::string word = keyword(); !word.empty(); word = keyword())
            readSection(word);
        if (m_content.nodes.empty())
            makeGridNodes();
        m_content.steps = {m_time};
        if (!m_request.isForMesh)
            readChosen();
        return std::move(m_content);
    }

private:
    std::string keyword() { return m_numbers.keyword(); }

    /// Up to an empty line.
    void skipMetadata()
    {
        m_text.line();
        while (!m_text.isAtEnd() && !trimmedText(m_text.line()).empty()) {}
    }

    void readSection(const std::string& word)
    {
        if (word == "dataset")
            m_text.word(); // the sections that follow say all
        else if (word == "points")
            readPoints();
        else if (word == "dimensions")
            std::ranges::generate(m_dimensions, [&] { return m_text.count(); });
        else if (word == "origin")
            std::ranges::generate(m_origin, [&] { return m_text.number(); });
        else if (word == "spacing" || word == "aspect_ratio")
            std::ranges::generate(m_spacing, [&] { return m_text.number(); });
        else if (word == "x_coordinates" || word == "y_coordinates" || word == "z_coordinates")
            readCoordinates(static_cast<std::size_t>(word.front() - 'x'));
        else if (word == "metadata")
            skipMetadata();
        else if (word == "point_data" || word == "cell_data")
            beginData(word == "point_data");
        else if (!readCellSection(word) && !readAttribute(word))
            m_text.failHere();
    }

    bool readCellSection(const std::string& word)
    {
        if (word == "cells" || word == "cell_types")
            word == "cells" ? readCells("") : readCellTypes();
        else if (word == "vertices")
            readCells("Verts");
        else if (word == "lines")
            readCells("Lines");
        else if (word == "polygons")
            readCells("Polys");
        else if (word == "triangle_strips")
            readCells("Strips");
        else
            return false;
        return true;
    }

    void readPoints()
    {
        const std::size_t count = m_text.count();
        const LegacyTypeName numberType = m_numbers.type();
        appendVectors(m_numbers.numbers(m_numbers.checkedCount(count, 3, numberType), numberType), m_content.nodes);
    }

    void readCoordinates(std::size_t axis)
    {
        const std::size_t count = m_text.count();
        const LegacyTypeName numberType = m_numbers.type();
        m_coordinates[axis] = m_numbers.numbers(m_numbers.checkedCount(count, 1, numberType), numberType);
    }

    /// Until version 5 each cell is the number of its nodes, then those; since then there are two arrays.
    void readCells(std::string_view surfaceKind)
    {
        const std::size_t first = m_text.count();
        const std::size_t second = m_text.count();
        const std::size_t place = m_text.place();
        if (keyword() == "offsets") {
            const LegacyTypeName endType = m_numbers.type();
            m_ends = m_numbers.wholeNumbers(m_numbers.checkedCount(first, 1, endType), endType);
            if (keyword() != "connectivity")
                m_text.failHere();
            const LegacyTypeName nodeType = m_numbers.type();
            m_connectivity = m_numbers.wholeNumbers(m_numbers.checkedCount(second, 1, nodeType), nodeType);
        } else {
            m_text.goTo(place);
            takeCells(m_numbers.wholeNumbers(m_numbers.checkedCount(second, 1, legacyInt), legacyInt));
        }
        if (!surfaceKind.empty() && surfaceKind != "Strips" && !m_ends.empty())
            appendSurfaceCells(m_content.cells, surfaceKind, 0, m_connectivity,
                               std::span(m_ends).subspan(m_ends.front() == 0 ? 1 : 0));
    }

    void takeCells(const std::vector<std::int64_t>& list)
    {
        m_ends.clear();
        m_connectivity.clear();
        for (std::size_t i = 0; i < list.size();) {
            const std::int64_t nodes = list[i++];
            if (nodes < 0 || static_cast<std::size_t>(nodes) > list.size() - i)
                m_text.failHere();
            const auto begin = list.begin() + static_cast<std::ptrdiff_t>(i);
            m_connectivity.insert(m_connectivity.end(), begin, begin + nodes);
            m_ends.push_back(static_cast<std::int64_t>(m_connectivity.size()));
            i += static_cast<std::size_t>(nodes);
        }
    }

    void readCellTypes()
    {
        const std::size_t count = m_text.count();
        const auto types = m_numbers.wholeNumbers(m_numbers.checkedCount(count, 1, legacyInt), legacyInt);
        appendCells(m_content.cells, 0, m_connectivity, m_ends, types);
    }

    void beginData(bool isOfPoints)
    {
        m_isPointData = isOfPoints;
        m_tuples = m_text.count();
    }

    bool readAttribute(const std::string& word)
    {
        if (word == "field")
            return readField(), true;
        if (word == "lookup_table") {
            m_text.word();
            return m_numbers.skipNumbers(m_numbers.checkedCount(m_text.count(), 4, legacyByte), legacyByte), true;
        }
        const std::string name = decodedName(m_text.word());
        if (word == "vectors" || word == "normals")
            takeArray(word == "vectors" ? name : std::string(), 3, m_tuples, m_numbers.type());
        else if (word == "tensors" || word == "tensors6")
            takeArray(name, word == "tensors" ? 9 : 6, m_tuples, m_numbers.type());
        else if (word == "texture_coordinates") {
            const std::size_t components = m_text.count();
            takeArray({}, components, m_tuples, m_numbers.type());
        } else if (word == "color_scalars") {
            takeArray({}, m_text.count(), m_tuples, legacyByte);
        } else if (word == "scalars")
            readScalars(name);
        else
            return false;
        return true;
    }

    void readScalars(const std::string& name)
    {
        const LegacyTypeName numberType = m_numbers.type();
        std::size_t components = 1;
        if (const auto said = wholeNumberIn(m_text.line()); said && *said > 0)
            components = static_cast<std::size_t>(*said);
        const std::size_t behind = m_text.place();
        const bool hasTable = keyword() == "lookup_table";
        if (hasTable)
            m_text.word();
        else
            m_text.goTo(behind - 1);
        takeArray(name, components, m_tuples, numberType);
    }

    void readField()
    {
        m_text.word(); // its name
        const std::size_t arrays = m_text.count();
        for (std::size_t i = 0; i < arrays; ++i) {
            std::string name = decodedName(m_text.word());
            if (lowerCase(name) == "metadata") { // of the array before
                skipMetadata();
                name = decodedName(m_text.word());
            }
            const std::size_t components = m_text.count();
            const std::size_t tuples = m_text.count();
            if (!m_isPointData && name == "TIME")
                readTime(m_numbers.checkedCount(tuples, components, legacyByte));
            else
                takeFieldArray(name, components, tuples);
        }
    }

    void readTime(std::size_t count)
    {
        if (const auto times = m_numbers.numbers(count, m_numbers.type()); times.size() == 1)
            m_time = shortNumber(times.front());
    }

    void takeFieldArray(const std::string& name, std::size_t components, std::size_t tuples)
    {
        const std::size_t place = m_text.place();
        if (keyword() == "string")
            return skipStrings(components * tuples);
        m_text.goTo(place);
        takeArray(name, components, tuples, m_numbers.type());
    }

    /// Strings stand a line each, or behind their lengths; these need the width of lengths.
    void skipStrings(std::size_t count)
    {
        if (m_numbers.isBinary())
            throw Problem(Message("Field", "it holds texts as bytes, which are not read; save it as text (ASCII)."));
        m_text.line();
        for (std::size_t i = 0; i < count && !m_text.isAtEnd(); ++i)
            m_text.line();
    }

    void takeArray(const std::string& name, std::size_t components, std::size_t tuples,
                   const LegacyTypeName& numberType)
    {
        if (components == 0 || tuples == 0)
            return;
        const std::size_t count = m_numbers.checkedCount(tuples, components, numberType);
        if (m_isPointData && components == 3 && !name.empty() && lowerCase(name) != "normals")
            m_vectors.push_back({readableName(name), numberType, tuples, m_text.place()});
        m_numbers.skipNumbers(count, numberType);
    }

    /// Of grids whose nodes are not listed. The grid has no more nodes than the file has bytes: each has a value.
    void makeGridNodes()
    {
        const bool hasCoordinates = !m_coordinates[0].empty();
        for (std::size_t axis = 0; axis < 3 && hasCoordinates; ++axis)
            m_dimensions[axis] = m_coordinates[axis].size();
        const std::size_t most = m_text.place();
        const auto [nx, ny, nz] = m_dimensions;
        if (nx == 0 || ny == 0 || nz == 0 || nx > most || ny > most / nx || nz > most / nx / ny)
            throw Problem(Message("Field", "it has no nodes; write the results with the mesh."));
        const auto coordinate = [&](std::size_t axis, std::size_t i) {
            return hasCoordinates ? m_coordinates[axis][i] : m_origin[axis] + static_cast<double>(i) * m_spacing[axis];
        };
        for (std::size_t k = 0; k < nz; ++k)
            for (std::size_t j = 0; j < ny; ++j)
                for (std::size_t i = 0; i < nx; ++i)
                    m_content.nodes.emplace_back(coordinate(0, i), coordinate(1, j), coordinate(2, k));
    }

    void readChosen()
    {
        for (const LegacyVectors& vectors : m_vectors)
            m_content.names.push_back(vectors.name);
        choose(m_request.choice, m_content);
        m_content.valueUnit = unitIn(m_content.name);
        const LegacyVectors& vectors = m_vectors[chosenName(m_request.choice, m_content.names)];
        checkCount(vectors.name, vectors.tuples, m_content.nodes.size());
        m_text.goTo(vectors.place);
        appendVectors(m_numbers.numbers(3 * m_content.nodes.size(), vectors.type), m_content.values);
    }

    const FieldRequest& m_request;
    TextScanner m_text;
    LegacyNumbers m_numbers{m_text};
    std::array<std::size_t, 3> m_dimensions{};
    std::array<double, 3> m_origin{};
    std::array<double, 3> m_spacing{1, 1, 1};
    std::array<std::vector<double>, 3> m_coordinates;
    std::vector<std::int64_t> m_ends;
    std::vector<std::int64_t> m_connectivity;
    bool m_isPointData = false;
    std::size_t m_tuples = 0;
    std::string m_time = "0";
    std::vector<LegacyVectors> m_vectors;
    FieldContent m_content;
};

} // namespace

FieldContent readLegacyVtk(std::string_view bytes, const FieldRequest& request, TaskControl& control)
{
    return VtkLegacyReader(bytes, request, control).run();
}

} // namespace knead
