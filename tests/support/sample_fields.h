#pragma once

#include "core/geometry/vec3.h"

#include <QByteArray>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

/// A small field at the nodes of two bricks, as other programs write it.
namespace knead::samples {

struct Sample {
    std::vector<Vec3> nodes;  ///< [mm]
    std::vector<Vec3> values; ///< [mm]
};

constexpr std::size_t columns = 3; ///< nodes along x; 2 along y and z

/// With digits that no short text holds.
inline Sample sample(double factor = 1)
{
    Sample result;
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 3; ++i) {
                const Vec3 X(100.0 / 3 * i, -20.0 / 7 * j, 10.0 / 3 * k + 0.1);
                result.nodes.push_back(X);
                result.values.push_back(factor *
                                        Vec3(0.001 * X.x() * X.z(), std::sin(X.x()) / 9, -1e-5 * X.squaredNorm()));
            }
    return result;
}

/// The nodes of the two bricks, as VTK and all others order them, from 0.
inline const std::vector<std::vector<int>>& bricks()
{
    static const std::vector<std::vector<int>> both{{0, 1, 4, 3, 6, 7, 10, 9}, {1, 2, 5, 4, 7, 8, 11, 10}};
    return both;
}

/// As printf.
template <typename... Arguments>
std::string text(const char* format, Arguments... arguments)
{
    char line[400];
    std::snprintf(line, sizeof line, format, arguments...);
    return line;
}

/// A number as it lies in memory.
template <typename Number>
std::string bytes(Number number, std::endian order = std::endian::little)
{
    std::string raw(sizeof number, '\0');
    std::memcpy(raw.data(), &number, sizeof number);
    if (order != std::endian::little)
        std::reverse(raw.begin(), raw.end());
    return raw;
}

inline std::string triple(const Vec3& v, const char* separator = " ")
{
    return text("%.17g%s%.17g%s%.17g", v.x(), separator, v.y(), separator, v.z());
}

/// CalculiX results of as many steps as there are samples. @param format 0 short, 1 long, 2 bytes (single), 3 bytes (double)
inline std::string frd(const std::vector<Sample>& steps, int format = 1)
{
    const auto record = [&](std::size_t label, const Vec3& v, bool isDouble) {
        if (format < 2)
            return text(format == 0 ? " -1%5zu%12.5E%12.5E%12.5E\n" : " -1%10zu%12.5E%12.5E%12.5E\n", label, v.x(),
                        v.y(), v.z());
        std::string raw = bytes(static_cast<std::int32_t>(label));
        for (const double x : v)
            raw += isDouble ? bytes(x) : bytes(static_cast<float>(x));
        return raw;
    };
    const std::string end = format < 2 ? " -3\n" : "";
    std::string file = "    1C\n    1UUSER                    anybody\n";
    const std::vector<Vec3>& nodes = steps.front().nodes;
    file += text("    2C                  %12zu%37s%1d\n", nodes.size(), "", format < 2 ? format : 3);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        file += record(i + 1, nodes[i], true);
    file += end + text("    3C                  %12zu%37s%1d\n", bricks().size(), "", std::min(format, 2));
    int number = 0;
    for (const auto& brick : bricks()) {
        ++number;
        file += format < 2 ? text(format == 0 ? " -1%5d%5d%5d%5d\n -2" : " -1%10d%5d%5d%5d\n -2", number, 1, 0, 1)
                           : bytes(number) + bytes(1) + bytes(0) + bytes(1);
        for (const int node : brick)
            file += format < 2 ? text(format == 0 ? "%5d" : "%10d", node + 1) : bytes(node + 1);
        file += format < 2 ? "\n" : "";
    }
    file += end;
    for (std::size_t step = 0; step < steps.size(); ++step)
        for (const char* name : {"DISP", "FORC"}) {
            file += text("  100CL  101%12.5f%12zu%20s%2d%5zu%10s%2d\n", 0.5 * static_cast<double>(step + 1),
                         nodes.size(), "", 0, step + 1, "", format < 2 ? format : 2);
            file += text(" -4  %-8s%5d%5d\n", name, 4, 1);
            for (int axis = 1; axis <= 3; ++axis)
                file += text(" -5  D%-7d%5d%5d%5d%5d\n", axis, 1, 2, axis, 0);
            file += " -5  ALL         1    2    0    0    1ALL\n";
            for (std::size_t i = 0; i < nodes.size(); ++i)
                file += record(i + 1, (name[0] == 'D' ? 1.0 : 1000.0) * steps[step].values[i], false);
            file += end;
        }
    return file + " 9999\n";
}

/// @param kind "UNSTRUCTURED_GRID", "POLYDATA", "STRUCTURED_GRID". @param attribute "VECTORS" or "FIELD"
inline std::string legacyVtk(const Sample& sample, const std::string& kind, bool isBinary, bool isField)
{
    const auto vectors = [&](const std::vector<Vec3>& all) {
        std::string raw;
        for (const Vec3& v : all)
            if (isBinary)
                for (const double x : v)
                    raw += bytes(x, std::endian::big);
            else
                raw += triple(v) + "\n";
        return raw + "\n";
    };
    const auto whole = [&](int number) { return isBinary ? bytes(number, std::endian::big) : text("%d ", number); };
    std::string file = std::string("# vtk DataFile Version 3.0\nany title\n") + (isBinary ? "BINARY" : "ASCII") +
                       "\nDATASET " + kind + "\n";
    if (kind == "STRUCTURED_GRID")
        file += "DIMENSIONS 3 2 2\n";
    file += text("POINTS %zu double\n", sample.nodes.size()) + vectors(sample.nodes);
    if (kind == "UNSTRUCTURED_GRID") {
        file += "CELLS 2 18\n";
        for (const auto& brick : bricks()) {
            file += whole(8);
            for (const int node : brick)
                file += whole(node);
        }
        file += "\nCELL_TYPES 2\n" + whole(12) + whole(12) + "\n";
    } else if (kind == "POLYDATA") {
        file += "POLYGONS 1 4\n" + whole(3) + whole(0) + whole(1) + whole(3) + "\n";
    }
    const int scalar = isBinary ? 1 : 0;
    file += text("POINT_DATA %zu\nSCALARS temperature double 1\nLOOKUP_TABLE default\n", sample.nodes.size());
    for (std::size_t i = 0; i < sample.nodes.size(); ++i)
        file += scalar == 1 ? bytes(0.5 * static_cast<double>(i), std::endian::big) : text("%zu\n", i);
    file += isField ? text("\nFIELD FieldData 1\ndisplacement%%20[mm] 3 %zu double\n", sample.nodes.size())
                    : "\nVECTORS displacement%20[mm] double\n";
    return file + vectors(sample.values) + "METADATA\nINFORMATION 0\n\n";
}

/// How a VTK XML file is written.
struct XmlStyle {
    std::string kind = "UnstructuredGrid";
    std::string format = "appended"; ///< or "ascii", "binary"
    bool isBase64 = false;           ///< of what is appended
    bool isCompressed = false;
    bool hasLongHeaders = true;
    bool isSingle = false; ///< numbers in single precision
    std::endian order = std::endian::little;
    std::string name = "displacement";
    std::string fieldData{}; ///< as XML
};

/// Writes arrays as a style says.
class XmlArrays {
public:
    explicit XmlArrays(const XmlStyle& style)
        : m_style(style)
    {
    }

    std::string appended; ///< of all so far

    std::string reals(const std::string& name, const std::vector<Vec3>& vectors)
    {
        std::string raw;
        std::string words;
        for (const Vec3& v : vectors)
            for (const double x : v) {
                raw += m_style.isSingle ? bytes(static_cast<float>(x), m_style.order) : bytes(x, m_style.order);
                words += text("%.17g ", x);
            }
        return array(m_style.isSingle ? "Float32" : "Float64", name, 3, raw, words);
    }

    std::string wholes(const std::string& name, const std::vector<int>& numbers)
    {
        std::string raw;
        std::string words;
        for (const int number : numbers) {
            raw += bytes(std::int64_t{number}, m_style.order);
            words += text("%d ", number);
        }
        return array("Int64", name, 1, raw, words);
    }

private:
    std::string header(const std::vector<std::size_t>& numbers) const
    {
        std::string raw;
        for (const std::size_t number : numbers)
            raw += m_style.hasLongHeaders ? bytes(std::uint64_t{number}, m_style.order)
                                          : bytes(static_cast<std::uint32_t>(number), m_style.order);
        return raw;
    }

    static std::string base64(const std::string& raw)
    {
        return QByteArray(raw.data(), static_cast<qsizetype>(raw.size())).toBase64().toStdString();
    }

    /// With the header before it. Compressed in blocks of 64 bytes, so that there are several.
    std::string encoded(const std::string& raw, bool isBase64) const
    {
        if (!m_style.isCompressed)
            return isBase64 ? base64(header({raw.size()}) + raw) : header({raw.size()}) + raw;
        constexpr std::size_t blockSize = 64;
        std::string blocks;
        std::vector<std::size_t> head{(raw.size() + blockSize - 1) / blockSize, blockSize, raw.size() % blockSize};
        for (std::size_t at = 0; at < raw.size(); at += blockSize) {
            const std::string block = raw.substr(at, blockSize);
            const QByteArray packed =
                qCompress(reinterpret_cast<const uchar*>(block.data()), static_cast<qsizetype>(block.size())).mid(4);
            blocks += packed.toStdString();
            head.push_back(static_cast<std::size_t>(packed.size()));
        }
        return isBase64 ? base64(header(head)) + base64(blocks) : header(head) + blocks;
    }

    std::string array(const std::string& type, const std::string& name, int components, const std::string& raw,
                      const std::string& words)
    {
        const std::string tag = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                                std::to_string(components) + "\" format=\"" + m_style.format + "\"";
        if (m_style.format != "appended")
            return tag + ">\n" + (m_style.format == "ascii" ? words : encoded(raw, true)) + "\n</DataArray>\n";
        const std::string place = std::to_string(appended.size());
        appended += encoded(raw, m_style.isBase64);
        return tag + " offset=\"" + place + "\"/>\n";
    }

    const XmlStyle& m_style;
};

inline std::string xmlVtk(const Sample& sample, const XmlStyle& style)
{
    XmlArrays arrays(style);
    std::string file = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + style.kind + "\" version=\"1.0\" byte_order=\"" +
                       (style.order == std::endian::big ? "BigEndian" : "LittleEndian") + "\" header_type=\"" +
                       (style.hasLongHeaders ? "UInt64" : "UInt32") + "\"" +
                       (style.isCompressed ? " compressor=\"vtkZLibDataCompressor\"" : "") + ">\n<!-- > < -->\n<" +
                       style.kind + ">\n<FieldData>\n" + style.fieldData + "</FieldData>\n<Piece NumberOfPoints=\"" +
                       std::to_string(sample.nodes.size()) + "\" NumberOfCells=\"2\">\n<PointData Vectors=\"" +
                       style.name + "\">\n" + arrays.reals(style.name, sample.values) +
                       arrays.reals("velocity &amp; more", sample.nodes) + "</PointData>\n<Points>\n" +
                       arrays.reals("Points", sample.nodes) + "</Points>\n<Cells>\n";
    std::vector<int> connectivity;
    for (const auto& brick : bricks())
        connectivity.insert(connectivity.end(), brick.begin(), brick.end());
    file += arrays.wholes("connectivity", connectivity) + arrays.wholes("offsets", {8, 16}) +
            arrays.wholes("types", {12, 12});
    file += "</Cells>\n</Piece>\n</" + style.kind + ">\n";
    if (style.format == "appended")
        file += std::string("<AppendedData encoding=\"") + (style.isBase64 ? "base64" : "raw") + "\">\n_" +
                arrays.appended + "\n</AppendedData>\n";
    return file + "</VTKFile>\n";
}

/// Gmsh's version 2.2 or 4.1 with a view of as many steps as there are samples.
inline std::string gmsh(const std::vector<Sample>& steps, bool isVersion4, bool isBinary)
{
    const std::vector<Vec3>& nodes = steps.front().nodes;
    const auto whole = [&](std::size_t n) { return isBinary ? bytes(static_cast<std::int32_t>(n)) : text("%zu ", n); };
    const auto tag = [&](std::size_t n) { return isBinary && isVersion4 ? bytes(std::uint64_t{n}) : whole(n); };
    const auto vector = [&](const Vec3& v) {
        return isBinary ? bytes(v.x()) + bytes(v.y()) + bytes(v.z()) : triple(v) + "\n";
    };
    std::string file = text("$MeshFormat\n%s %d 8\n", isVersion4 ? "4.1" : "2.2", isBinary ? 1 : 0);
    file += (isBinary ? bytes(1) + "\n" : "") +
            "$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"body\"\n$EndPhysicalNames\n$Nodes\n";
    if (isVersion4) {
        file += tag(1) + tag(nodes.size()) + tag(1) + tag(nodes.size()) + whole(3) + whole(1) + whole(0) +
                tag(nodes.size());
        for (std::size_t i = 0; i < nodes.size(); ++i)
            file += tag(i + 1);
        for (const Vec3& node : nodes)
            file += vector(node);
    } else {
        file += text("%zu\n", nodes.size());
        for (std::size_t i = 0; i < nodes.size(); ++i)
            file += whole(i + 1) + vector(nodes[i]);
    }
    file += "\n$EndNodes\n$Elements\n";
    if (isVersion4)
        file += tag(1) + tag(2) + tag(1) + tag(2) + whole(3) + whole(1) + whole(5) + tag(2);
    else
        file += "2\n" + (isBinary ? whole(5) + whole(2) + whole(2) : std::string());
    for (std::size_t e = 0; e < bricks().size(); ++e) {
        file += tag(e + 1);
        if (!isVersion4)
            file += (isBinary ? std::string() : whole(5) + whole(2)) + whole(1) + whole(1);
        for (const int node : bricks()[e])
            file += tag(static_cast<std::size_t>(node) + 1);
    }
    file += "\n$EndElements\n";
    for (std::size_t step = 0; step < steps.size(); ++step) {
        file += text("$NodeData\n1\n\"displacement\"\n1\n%g\n3\n%zu\n3\n%zu\n", 0.5 * static_cast<double>(step + 1),
                     step, nodes.size());
        for (std::size_t i = 0; i < nodes.size(); ++i)
            file += whole(i + 1) + vector(steps[step].values[i]);
        file += "\n$EndNodeData\n";
    }
    return file;
}

/// A table with a line of cells for each node.
inline std::string table(const Sample& sample, const std::string& heading,
                         const std::function<std::string(std::size_t, const Vec3&, const Vec3&)>& line)
{
    std::string file = heading;
    for (std::size_t i = 0; i < sample.nodes.size(); ++i)
        file += line(i, sample.nodes[i], sample.values[i]) + "\n";
    return file;
}

/// A report of Abaqus. @param hasCoordinates whether COORD is in it
inline std::string report(const std::vector<Sample>& steps, bool hasCoordinates = true)
{
    std::string file;
    for (std::size_t step = 0; step < steps.size(); ++step) {
        file += text("\n Field Output Report, written Mon Jan  5 10:11:12 2026\n\nSource 1\n---------\n\n   ODB: "
                     "C:/Temp/Job-1.odb\n"
                     "   Step: Step-%zu\n   Frame: Increment      1: Step Time =    1.000\n\nLoc 1 : Nodal values from "
                     "source 1\n\n"
                     "Output sorted by column \"Node Label\".\n\nField Output reported at nodes for part: PART-1-1\n\n",
                     step + 1);
        std::vector<std::string> names{"COORD.COOR1", "COORD.COOR2", "COORD.COOR3", "U.Magnitude",
                                       "U.U1",        "U.U2",        "U.U3"};
        if (!hasCoordinates)
            names.erase(names.begin(), names.begin() + 3);
        file += text("%16s", "Node");
        for (const std::string& name : names)
            file += text("%26s", name.c_str());
        file += text("\n%16s", "Label");
        for (std::size_t i = 0; i < names.size(); ++i)
            file += text("%26s", "@Loc 1");
        file += "\n" + std::string(120, '-') + "\n";
        for (std::size_t i = 0; i < steps[step].nodes.size(); ++i) {
            file += text("%16zu", i + 1);
            const Vec3& value = steps[step].values[i];
            if (hasCoordinates)
                for (const double x : steps[step].nodes[i])
                    file += text("%26.17g", x);
            file += text("%26.17g", value.norm());
            for (const double x : value)
                file += text("%26.17g", x);
            file += "\n";
        }
        file += "\n\n  Minimum        0.\n\n";
    }
    return file;
}

/// An input of Abaqus or CalculiX: the mesh alone.
inline std::string input(const Sample& sample)
{
    std::string file = "** written for a test\n*HEADING\nbricks\n*Node, nset=ALL\n";
    for (std::size_t i = 0; i < sample.nodes.size(); ++i)
        file += text("%zu, ", i + 1) + triple(sample.nodes[i], ", ") + "\n";
    file += "*ELEMENT, TYPE=C3D8R, ELSET=EALL\n";
    for (std::size_t e = 0; e < bricks().size(); ++e) {
        file += text("%zu,", e + 1);
        for (std::size_t i = 0; i < 8; ++i)
            file += text(i == 4 ? "\n%d," : "%d,", bricks()[e][i] + 1);
        file.pop_back();
        file += "\n";
    }
    return file + "*MATERIAL, NAME=STEEL\n*ELASTIC\n210000., 0.3\n*STEP\n*NODE PRINT\nU\n*END STEP\n";
}

} // namespace knead::samples
