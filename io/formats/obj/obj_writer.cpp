#include "io/files/safe_file.h"
#include "io/formats/mesh_formats.h"
#include "io/formats/number_stream.h"
#include "io/formats/threemf/color_groups.h"

#include <filesystem>
#include <set>

namespace knead {

namespace {

/// Readers of OBJ cut names at spaces.
std::string wordForObj(const std::string& name)
{
    std::string word;
    for (const char c : name)
        word += static_cast<unsigned char>(c) <= ' ' || c == '#' ? '_' : c;
    return word;
}

/// Objects with equal names would become one in other programs.
std::vector<std::string> uniqueWords(const std::vector<std::string>& names)
{
    std::vector<std::string> words;
    std::set<std::string> used;
    for (const std::string& name : names) {
        const std::string wanted = wordForObj(name);
        std::string word = wanted;
        for (int i = 2; !used.insert(word).second; ++i)
            word = wanted + "_" + std::to_string(i);
        words.push_back(word);
    }
    return words;
}

void writeLibrary(const Palette& palette, NumberStream& stream)
{
    stream.add("# Knead\n");
    for (const Color& color : palette.colors) {
        stream.add("newmtl " + materialName(color) + "\nKd");
        stream.addText(Vec3(color.r, color.g, color.b), " ");
        stream.add("\nKs 0.1 0.1 0.1\nNs 20\nd 1\nillum 2\n");
    }
}

void writeBody(const MeshBody& body, double perMetre, std::size_t firstVertex, NumberStream& stream)
{
    for (const Vec3& vertex : body.mesh.vertices) {
        stream.add("v");
        stream.addText(Vec3(perMetre * vertex), " ");
        stream.add("\n");
    }
    const ColorGroups colors = groupByColor(body);
    for (const ColorGroups::Group& group : colors.groups) {
        stream.add("usemtl " + materialName(group.color) + "\n");
        for (std::size_t i = group.begin; i < group.end; ++i) {
            stream.add("f");
            for (const std::uint32_t vertex : body.mesh.triangles[colors.triangle(i)]) {
                stream.add(" ");
                stream.addText(firstVertex + vertex);
            }
            stream.add("\n");
        }
    }
}

} // namespace

void writeObj(const MeshFile& file)
{
    const std::filesystem::path library = std::filesystem::path(file.path).replace_extension(".mtl");
    SafeFile libraryTarget(library.string());
    NumberStream libraryStream(libraryTarget, TaskControl::none(), 1);
    writeLibrary(Palette(file.bodies), libraryStream);
    libraryStream.flush();

    SafeFile target(file.path);
    const double expectedBytes =
        36 * static_cast<double>(file.vertexCount) + 22 * static_cast<double>(file.triangleCount);
    NumberStream stream(target, file.control, expectedBytes);
    stream.add("# Knead, lengths in " + file.unit + "\nmtllib " + library.filename().string() + "\n");
    const std::vector<std::string> words = uniqueWords(file.names);
    std::size_t firstVertex = 1;
    for (std::size_t i = 0; i < file.bodies.size(); ++i) {
        stream.add("o " + words[i] + "\n");
        writeBody(*file.bodies[i], file.perMetre, firstVertex, stream);
        firstVertex += file.bodies[i]->mesh.vertices.size();
    }
    stream.flush();
    libraryTarget.finish();
    target.finish();
    libraryTarget.keep();
    target.keep();
}

} // namespace knead
