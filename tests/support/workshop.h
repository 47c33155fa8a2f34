#pragma once

#include <nlohmann/json.hpp>

#include <QDir>
#include <QDirIterator>
#include <QProcess>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

/// Runs of the program in a folder of their own.
namespace workshop {

using nlohmann::json;

struct Outcome {
    int status = -1;
    std::string out;
    std::string errors;
};

/// Environment without a display, as on a server.
inline QProcessEnvironment serverEnvironment()
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(name);
    return environment;
}

/// Whether a process does something of its own at a signal, so that the signal does not just end it.
inline bool handles(qint64 process, int signal)
{
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("SigCgt:"))
            return (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1U) != 0;
    return false;
}

constexpr int programPatience = 600'000; // [ms], for machines that do much else

inline Outcome runKnead(const QStringList& arguments)
{
    QProcess process;
    process.setProcessEnvironment(serverEnvironment());
    process.start(KNEAD_PROGRAM, arguments);
    if (!process.waitForFinished(programPatience) || process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), process.readAllStandardOutput().toStdString(),
            process.readAllStandardError().toStdString()};
}

/// The faces of a box between two corners [mm] as an STL has them.
inline std::string boxFacets(const std::array<double, 3>& low, const std::array<double, 3>& high,
                             bool isInsideOut = false)
{
    const std::array<std::array<unsigned, 3>, 12> triangles{{{0, 2, 3},
                                                             {0, 3, 1},
                                                             {4, 5, 7},
                                                             {4, 7, 6},
                                                             {0, 1, 5},
                                                             {0, 5, 4},
                                                             {2, 6, 7},
                                                             {2, 7, 3},
                                                             {0, 4, 6},
                                                             {0, 6, 2},
                                                             {1, 3, 7},
                                                             {1, 7, 5}}};
    std::ostringstream text;
    for (std::array<unsigned, 3> triangle : triangles) {
        if (isInsideOut)
            std::swap(triangle[1], triangle[2]);
        text << "facet normal 0 0 0\nouter loop\n";
        for (const unsigned corner : triangle) {
            text << "vertex";
            for (std::size_t axis = 0; axis < 3; ++axis)
                text << ' ' << ((corner >> axis & 1U) != 0 ? high : low).at(axis);
            text << '\n';
        }
        text << "endloop\nendfacet\n";
    }
    return text.str();
}

/// A bar of 40 x 10 x 10 mm with a corner at the origin, as an STL text.
inline std::string barText()
{
    return "solid bar\n" + boxFacets({0, 0, 0}, {40, 10, 10}) + "endsolid bar\n";
}

/// Pushes the middle of a bar held at its lower end x = 0.
inline json pressRecipe()
{
    return json::parse(R"({
        "version": 1, "part": {"file": "bar.stl"}, "spacing_mm": 2.5, "duration_s": 0.2,
        "material": {"youngs_modulus_pa": 1e5, "damping_ratio": 0.2, "shape_damping_per_s": 40},
        "fixtures": [{"name": "end", "box_mm": [-1, -1, -1, 2, 11, 11]}],
        "manipulators": [{"name": "press", "size_mm": [6, 12, 6], "position_mm": [35, 5, 14],
                          "keyframes": [{"time_s": 0.1, "position_mm": [35, 5, 10]}]}],
        "exports": [{"file": "bent.stl"}, {"file": "pictures/bent.png", "width": 120, "height": 90}]})");
}

class Workshop {
public:
    Workshop() { std::ofstream(path("bar.stl")) << barText(); }

    std::string path(const std::string& name) const { return m_folder.filePath(name.c_str()).toStdString(); }
    QString qPath(const std::string& name) const { return m_folder.filePath(name.c_str()); }

    QString write(const json& recipe, const std::string& name = "press.recipe.json") const
    {
        std::ofstream(path(name)) << recipe.dump();
        return qPath(name);
    }

    QStringList filesUnder(const std::string& folder) const
    {
        QStringList names;
        QDirIterator files(qPath(folder), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (files.hasNext())
            names << QDir(qPath(folder)).relativeFilePath(files.next());
        names.sort();
        return names;
    }

private:
    QTemporaryDir m_folder;
};

/// Lowest z of a binary STL [mm].
inline float lowestZ(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    file.seekg(80);
    std::uint32_t count = 0;
    file.read(reinterpret_cast<char*>(&count), sizeof count);
    float lowest = INFINITY;
    for (std::uint32_t i = 0; i < count; ++i) {
        std::array<float, 12> numbers{};
        file.read(reinterpret_cast<char*>(numbers.data()), sizeof numbers);
        file.seekg(2, std::ios::cur);
        for (const std::size_t z : {5, 8, 11})
            lowest = std::min(lowest, numbers.at(z));
    }
    return lowest;
}

inline std::size_t lineCount(const std::string& text)
{
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

} // namespace workshop
