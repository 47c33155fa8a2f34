// A part of the book in CalculiX: writes its input, runs it, reads what it found.
#include "verify/calculix.h"

#include "verify/part.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include <sys/resource.h>

namespace knead::book {

namespace {

/// Nodes at corners and edge middles of the cells of a block, numbered from 1.
class Mesh {
public:
    explicit Mesh(const MappedBlock& block)
        : m_block(block)
    {
        // CalculiX wants corners counter-clockwise seen from outside the last face; maps may turn space inside out.
        const Vec3 o = block.at(0, 0, 0);
        const Vec3 u = block.at(0.01, 0, 0) - o, v = block.at(0, 0.01, 0) - o, w = block.at(0, 0, 0.01) - o;
        m_mirrored = u.cross(v).dot(w) < 0;
        for (int i = 0; i < block.cells[0]; ++i)
            for (int j = 0; j < block.cells[1]; ++j)
                for (int k = 0; k < block.cells[2]; ++k)
                    addElement(2 * i, 2 * j, 2 * k);
    }

    std::vector<Vec3> places; ///< of nodes
    std::vector<std::array<int, 20>> elements;

private:
    int node(int i, int j, int k)
    {
        if (m_block.closed)
            i %= 2 * m_block.cells[0];
        const auto [entry, isNew] = m_numbers.try_emplace({i, j, k}, static_cast<int>(places.size()) + 1);
        if (isNew)
            places.push_back(m_block.at(0.5 * i, 0.5 * j, 0.5 * k));
        return entry->second;
    }

    void addElement(int i, int j, int k)
    {
        // Corners of the lower and upper face, middles of their edges, middles of the edges between them.
        static constexpr int steps[20][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2},
                                             {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 0}, {2, 1, 0},
                                             {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2}, {1, 2, 2},
                                             {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
        std::array<int, 20> element{};
        for (std::size_t n = 0; n < 20; ++n) {
            const auto& s = steps[n];
            element[n] = node(i + s[0], j + s[1], k + (m_mirrored ? 2 - s[2] : s[2]));
        }
        elements.push_back(element);
    }

    const MappedBlock& m_block;
    bool m_mirrored = false;
    std::map<std::tuple<int, int, int>, int> m_numbers;
};

using NodeSet = std::vector<int>;

std::string number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.9e", value);
    return text;
}

std::string materialText(const Material& material, const CalculixLaw& law, double density)
{
    std::string text = "*MATERIAL, NAME=M\n";
    const double nu = material.poissonRatio;
    if (law.isRubber) {
        // W = C10 (I1 - 3) + (J - 1)^2 / D1
        const double bulk = material.youngsModulus / (3 * (1 - 2 * nu));
        text += "*HYPERELASTIC, NEO HOOKE\n" + number(material.shearModulus() / 2) + "," + number(2 / bulk) + "\n";
    } else {
        text += "*ELASTIC\n" + number(material.youngsModulus) + "," + number(nu) + "\n";
    }
    if (material.yields())
        text += "*PLASTIC\n" + number(material.yieldStress) + ",0.\n" +
                number(material.yieldStress + 5 * material.hardening + 1e-6 * material.yieldStress) + ",5.\n";
    text += "*DENSITY\n" + number(density) + "\n*SOLID SECTION, ELSET=EALL, MATERIAL=M\n";
    return text;
}

/// Nodes of each grip.
std::vector<NodeSet> gripNodes(const Part& part, const Mesh& mesh)
{
    std::vector<NodeSet> sets(part.grips.size());
    for (std::size_t g = 0; g < part.grips.size(); ++g)
        if (part.grips[g].program != Grip::Program::knead)
            for (std::size_t n = 0; n < mesh.places.size(); ++n)
                if (part.grips[g].zone(mesh.places[n]) <= 1e-9)
                    sets[g].push_back(static_cast<int>(n) + 1);
    return sets;
}

std::string stepText(const Part& part, const Stage& stage, const std::set<std::size_t>& released, const Mesh& mesh,
                     const std::vector<NodeSet>& sets)
{
    CalculixLaw law = part.law;
    if (law.isRubber || part.material.yields())
        law = {law.isRubber, std::min(law.firstIncrement, 0.1), std::min(law.largestIncrement, 0.25)};
    std::string text = "*STEP, NLGEOM, INC=1000\n*STATIC\n" + number(law.firstIncrement) + ",1.,1e-6," +
                       number(law.largestIncrement) + "\n*BOUNDARY, OP=NEW\n";
    for (std::size_t g = 0; g < sets.size(); ++g) {
        if (released.contains(g))
            continue;
        for (const int n : sets[g]) {
            const Vec3& place = mesh.places[static_cast<std::size_t>(n - 1)];
            const Vec3 way = part.grips[g].path(place, stage.share);
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                if (part.grips[g].axes[axis] != 0)
                    text += std::to_string(n) + "," + std::to_string(axis + 1) + "," + std::to_string(axis + 1) + "," +
                            number(way[axis]) + "\n";
        }
    }
    if (part.gravity != Vec3::Zero()) {
        const Vec3 direction = part.gravity.normalized();
        text += "*DLOAD\nEALL,GRAV," + number(part.gravity.norm()) + "," + number(direction.x()) + "," +
                number(direction.y()) + "," + number(direction.z()) + "\n";
    }
    // Reactions and stresses at the end of the step only.
    return text + "*NODE FILE, FREQUENCY=100000\nU,RF\n*EL FILE, FREQUENCY=100000\nS\n*END STEP\n";
}

/// One block of values per node out of a results file.
struct Field {
    std::string name;
    std::vector<std::array<double, 6>> values; ///< per node
};

/// All blocks in their order. Values are in columns of twelve characters after a node number of ten.
std::vector<Field> readResults(const std::filesystem::path& file, std::size_t nodes)
{
    std::ifstream stream(file);
    std::vector<Field> fields;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with(" -4"))
            fields.push_back({line.substr(5, line.find(' ', 5) - 5), std::vector<std::array<double, 6>>(nodes)});
        if (!line.starts_with(" -1") || fields.empty())
            continue;
        const std::size_t node = std::stoul(line.substr(3, 10)) - 1;
        for (std::size_t c = 0; c < 6 && line.size() >= 13 + 12 * (c + 1); ++c)
            fields.back().values.at(node)[c] = std::stod(line.substr(13 + 12 * c, 12));
    }
    return fields;
}

double vonMises(const std::array<double, 6>& s)
{
    return std::sqrt(0.5 * (std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2)) +
                     3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

Finding findingOf(const Mesh& mesh, const std::vector<NodeSet>& sets, const std::set<std::size_t>& released,
                  const Field& displacement, const Field& stress, const Field& force)
{
    Finding found;
    found.rest = mesh.places;
    const auto vector = [](const std::array<double, 6>& values) { return Vec3(values[0], values[1], values[2]); };
    for (const auto& values : displacement.values)
        found.displacement.push_back(vector(values));
    found.reactions.resize(sets.size());
    for (std::size_t g = 0; g < sets.size(); ++g)
        for (const int n : sets[g]) {
            const auto i = static_cast<std::size_t>(n - 1);
            if (!released.contains(g)) // reported are forces on the part
                found.reactions[g].push_back(
                    {found.rest[i], found.rest[i] + found.displacement[i], -vector(force.values[i])});
        }
    found.vonMises = [places = mesh.places, values = stress.values](const Vec3& place) {
        std::size_t nearest = 0;
        for (std::size_t i = 0; i < places.size(); ++i)
            if ((places[i] - place).squaredNorm() < (places[nearest] - place).squaredNorm())
                nearest = i;
        return vonMises(values[nearest]);
    };
    return found;
}

/// Processor time of all programs that this one ran [s].
double childSeconds()
{
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

/// The mesh of the block in its last shape.
TriangleMesh pictureOf(const Part& part, const Mesh& mesh, const Finding& finding)
{
    TriangleMesh picture = surfaceOf(part.block);
    for (Vec3& vertex : picture.vertices) {
        for (std::size_t i = 0; i < mesh.places.size(); ++i)
            if ((mesh.places[i] - vertex).squaredNorm() < 1e-18) {
                vertex += finding.displacement[i];
                break;
            }
    }
    return picture;
}

} // namespace

std::filesystem::path& calculixFolder()
{
    static std::filesystem::path folder = std::filesystem::temp_directory_path() / "knead-verify";
    return folder;
}

Outcome runCalculix(const Part& part, const Measure& measure)
{
    static int runs = 0;
    const std::filesystem::path folder = calculixFolder();
    std::filesystem::create_directories(folder);
    const std::string name = "deck" + std::to_string(++runs);
    const Mesh mesh(part.block);
    const std::vector<NodeSet> sets = gripNodes(part, mesh);

    std::string text = "*NODE, NSET=NALL\n";
    for (std::size_t i = 0; i < mesh.places.size(); ++i) {
        const Vec3& p = mesh.places[i];
        text += std::to_string(i + 1) + "," + number(p.x()) + "," + number(p.y()) + "," + number(p.z()) + "\n";
    }
    text += "*ELEMENT, TYPE=C3D20R, ELSET=EALL\n";
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        text += std::to_string(e + 1);
        for (std::size_t n = 0; n < 20; ++n)
            text += (n == 14 ? ",\n" : ",") + std::to_string(mesh.elements[e][n]);
        text += "\n";
    }
    text += materialText(part.material, part.law, part.weighs);
    std::set<std::size_t> released;
    for (const Stage& stage : part.stages) {
        // Load first, as Knead does; what is let go afterwards is a step of its own.
        text += stepText(part, stage, released, mesh, sets);
        if (!stage.released.empty()) {
            released.insert(stage.released.begin(), stage.released.end());
            text += stepText(part, stage, released, mesh, sets);
        }
    }
    std::ofstream stream(folder / (name + ".inp"));
    stream << text;
    if (!stream.flush())
        throw std::runtime_error((folder / (name + ".inp")).string() + " could not be written.");
    stream.close();

    const double before = childSeconds();
    const std::string command =
        "cd '" + folder.string() + "' && OMP_NUM_THREADS=1 ccx " + name + " > " + name + ".log 2>&1";
    if (std::system(command.c_str()) != 0)
        throw std::runtime_error("CalculiX failed; see " + (folder / (name + ".log")).string());
    const double seconds = childSeconds() - before;

    const std::vector<Field> fields = readResults(folder / (name + ".frd"), mesh.places.size());
    const auto field = [&](const std::string& wanted, std::size_t step) -> const Field& {
        for (const Field& f : fields)
            if (f.name == wanted && step-- == 0)
                return f;
        throw std::runtime_error("CalculiX did not come to the end; see " + (folder / (name + ".log")).string());
    };
    std::vector<Finding> findings;
    released.clear();
    std::size_t step = 0;
    for (const Stage& stage : part.stages) {
        released.insert(stage.released.begin(), stage.released.end());
        step += stage.released.empty() ? 0 : 1;
        findings.push_back(
            findingOf(mesh, sets, released, field("DISP", step), field("STRESS", step), field("FORC", step)));
        ++step;
    }
    Outcome outcome{.values = measure(findings)};
    outcome.seconds = seconds;
    outcome.objects = mesh.places.size();
    outcome.picture = pictureOf(part, mesh, findings.back());
    return outcome;
}

} // namespace knead::book
