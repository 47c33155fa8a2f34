#include "io/formats/mesh_input.h"

#include "io/files/safe_file.h"

#include <array>
#include <cstdio>
#include <string>

namespace knead {

namespace {

constexpr double perMillimeter = 1000;
constexpr std::size_t numbersOfLine = 8;

/// At most 20 characters a number, as the programs read them.
std::string nodeLine(std::size_t number, const Vec3& place)
{
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "%zu, %.11g, %.11g, %.11g\n", number, perMillimeter * place.x(),
                  perMillimeter * place.y(), perMillimeter * place.z());
    return text.data();
}

template <class Numbers>
std::string numberLines(const Numbers& numbers)
{
    std::string text;
    std::size_t count = 0;
    for (const auto number : numbers) {
        text += (count == 0 ? "" : count % numbersOfLine == 0 ? ",\n" : ", ") + std::to_string(number + 1);
        ++count;
    }
    return text + "\n";
}

} // namespace

void writeMeshInput(const std::string& path, const CellMesh& mesh)
{
    SafeFile file(path);
    file.write("** Hexahedra of a filling, in mm.\n*NODE, NSET=NALL\n");
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
        file.write(nodeLine(i + 1, mesh.nodes[i]));
    file.write("*ELEMENT, TYPE=C3D8I, ELSET=EALL\n");
    for (std::size_t i = 0; i < mesh.cells.size(); ++i)
        file.write(std::to_string(i + 1) + ",\n" + numberLines(mesh.cells[i]));
    for (const CellMesh::NodeSet& set : mesh.sets)
        if (!set.nodes.empty())
            file.write("*NSET, NSET=" + set.name + "\n" + numberLines(set.nodes));
    file.keep();
}

} // namespace knead
