// knead fields: what other programs take up of what was done to a part.
#include "app/cad_process.h"
#include "app/cad_program.h"
#include "app/opened_shape.h"
#include "io/fields/field_reader.h"
#include "io/project/packing.h"
#include "io/project/project_file.h"
#include "support/pressed_part.h"
#include "support/workshop.h"

#include <QtTest>

#include <cmath>

using namespace knead;
using namespace knead::sessions;
using namespace workshop;

namespace {

constexpr const char* bar = KNEAD_RESOURCES "/examples/bar.step"; // 160 x 20 x 20 mm
constexpr double spacing = 0.004;

/// A block of n x 2 x 2 bricks in the bar as an input of CalculiX, in millimetres; nodes and elements are numbered from 11 and 101.
std::string brickInput(const Box& box, int n)
{
    std::ostringstream text;
    text << "*NODE\n";
    const Eigen::Vector3i cells(n, 2, 2);
    const auto label = [&](int i, int j, int k) { return 11 + i + (n + 1) * (j + 3 * k); };
    for (int k = 0; k <= 2; ++k)
        for (int j = 0; j <= 2; ++j)
            for (int i = 0; i <= n; ++i) {
                const Vec3 share = Vec3(i, j, k).cwiseQuotient(cells.cast<double>());
                const Vec3 place = 1e3 * (box.min() + box.sizes().cwiseProduct(share));
                text << label(i, j, k) << ", " << place.x() << ", " << place.y() << ", " << place.z() << "\n";
            }
    text << "*ELEMENT, TYPE=C3D8, ELSET=BAR\n";
    for (int e = 0; e < 4 * n; ++e) {
        const int i = e % n;
        const int j = e / n % 2;
        const int k = e / n / 2;
        text << 101 + e;
        for (const int up : {0, 1})
            for (const auto& [di, dj] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
                text << ", " << label(i + di, j + dj, k + up);
        text << "\n";
    }
    return text.str();
}

void writeNodes(const std::string& path, const std::vector<Vec3>& nodes)
{
    std::ofstream file(path);
    file.precision(15);
    file << "X [mm],Y [mm],Z [mm]\n";
    for (const Vec3& node : nodes)
        file << 1e3 * node.x() << ',' << 1e3 * node.y() << ',' << 1e3 * node.z() << '\n';
}

/// The numbers of a line, what is empty as NaN.
std::vector<double> numbersOf(const std::string& line)
{
    std::vector<double> numbers;
    std::istringstream pieces(line);
    for (std::string piece; std::getline(pieces, piece, ',');)
        numbers.push_back(piece.empty() ? std::nan("") : std::stod(piece));
    return numbers;
}

std::vector<std::string> linesOf(const std::string& path)
{
    std::vector<std::string> lines;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
        lines.push_back(line);
    return lines;
}

} // namespace

class FieldsCommandTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        setCadProgram(cadProgramBeside(KNEAD_PROGRAM));
        const Project project = packed(pressedPart(bar, spacing));
        m_box = project.model->parts[0].box;
        writeProject(m_shop.path("bar.knead"), project);
        std::ofstream(m_shop.path("mesh.inp")) << brickInput(m_box, 16);
    }

    /// What is read again carries the surface to where the project has it.
    void theFieldCarriesTheSkinToWhereItIs()
    {
        const OpenedShape shape = openShape(m_shop.path("bar.knead"), {}, {}, TaskControl::none());
        const std::vector<Vec3>& rest = shape.content.bodies[0]->mesh.vertices;
        const std::vector<Vec3>& now = shape.frame->bodies[0]->places;
        writeNodes(m_shop.path("rest.csv"), rest);
        for (const char* output : {"out.vtu", "out.csv"}) {
            const json report = fields("rest.csv", output);
            QVERIFY(!report.is_null());
            QCOMPARE(report.at("nodes").get<std::size_t>(), rest.size());
            QCOMPARE(report.at("nodes_outside").get<int>(), 0);
            const FieldFile read = readField(m_shop.path(output), {}, TaskControl::none());
            QCOMPARE(read.unit, std::string("mm"));
            double largest = 0;
            for (std::size_t i = 0; i < read.field.nodes.size(); ++i) {
                const Vec3& X = read.field.nodes[i];
                const auto vertex =
                    std::ranges::min_element(rest, {}, [&](const Vec3& place) { return (place - X).squaredNorm(); });
                const Vec3 there = now[static_cast<std::size_t>(vertex - rest.begin())];
                largest = std::max(largest, (X + read.field.displacements[i] - there).norm());
            }
            QVERIFY2(read.field.nodes.size() > 20 && largest < 1e-3 * spacing, std::to_string(largest).c_str());
        }
        // A mesh of the present shape is taken back.
        writeNodes(m_shop.path("now.csv"), now);
        const json report = fields("now.csv", "now_out.csv", {"--at", "now", "--fields", "displacement"});
        QVERIFY(!report.is_null());
        QCOMPARE(report.at("fields")[0].get<std::string>(), std::string("moved from rest by [mm]"));
        const std::vector<std::string> lines = linesOf(m_shop.path("now_out.csv"));
        QCOMPARE(lines.size(), now.size() + 1);
        for (std::size_t i = 0; i < now.size(); ++i) {
            const std::vector<double> numbers = numbersOf(lines[i + 1]);
            const Vec3 moved = 1e-3 * Vec3(numbers[4], numbers[5], numbers[6]);
            QVERIFY((moved - (now[i] - rest[i])).norm() < 1e-3 * spacing);
        }
    }

    /// Nodes where they are now, and the stress at each integration point of each brick.
    void aSolverIsToldOfNodesAndStress()
    {
        const json report = fields("mesh.inp", "start.inp");
        QVERIFY(!report.is_null());
        const std::vector<std::string> lines = linesOf(m_shop.path("start.inp"));
        const auto nodes = std::ranges::find(lines, "*NODE");
        const auto stress = std::ranges::find(lines, "*INITIAL CONDITIONS, TYPE=STRESS");
        QVERIFY(nodes != lines.end() && stress != lines.end());
        QCOMPARE(numbersOf(*(nodes + 1))[0], 11.0);
        QCOMPARE(std::distance(stress + 1, lines.end()), 8 * 64);
        for (const std::string& line : lines)
            for (std::size_t begin = 0; begin != line.npos && !line.starts_with("*");) {
                const std::size_t comma = line.find(", ", begin);
                QVERIFY(std::min(comma, line.size()) - begin <= 20); // letters that CalculiX looks at
                begin = comma == line.npos ? comma : comma + 2;
            }
        // The same at the second point of the first brick as of a node there [MPa].
        const Vec3 half = m_box.sizes().cwiseQuotient(Vec3(32, 4, 4));
        const double gauss = 1 / std::sqrt(3);
        writeNodes(m_shop.path("point.csv"), {m_box.min() + half.cwiseProduct(Vec3(1 + gauss, 1 - gauss, 1 - gauss))});
        QVERIFY(!fields("point.csv", "point_out.csv", {"--fields", "stress"}).is_null());
        const std::vector<double> there = numbersOf(linesOf(m_shop.path("point_out.csv"))[1]);
        const std::vector<double> told = numbersOf(*(stress + 2));
        QCOMPARE(told[0], 101.0);
        QCOMPARE(told[1], 2.0);
        const double size = std::abs(there[4]) + std::abs(there[5]) + std::abs(there[6]);
        QVERIFY(size > 0);
        const std::array<std::size_t, 6> order{4, 5, 6, 7, 9, 8}; // xx yy zz xy yz xz in tables, xz before yz here
        for (std::size_t i = 0; i < 6; ++i)
            QVERIFY(std::abs(told[2 + i] - there[order[i]]) < 1e-6 * size);
        const json abaqus =
            fields("mesh.inp", "abaqus.inp", {"--solver", "abaqus", "--fields", "stress,plastic-strain"});
        QVERIFY(!abaqus.is_null());
        const std::vector<std::string> other = linesOf(m_shop.path("abaqus.inp"));
        QVERIFY(std::ranges::find(other, "*NODE") == other.end());
        const auto flow = std::ranges::find(other, "*INITIAL CONDITIONS, TYPE=HARDENING");
        QCOMPARE(std::distance(flow + 1, other.end()), 64);
        QCOMPARE(std::distance(std::ranges::find(other, "*INITIAL CONDITIONS, TYPE=STRESS") + 1, flow), 65);
    }

    void whatPressesIsSharedOut()
    {
        QVERIFY(!fields("mesh.inp", "press.csv", {"--fields", "contact-force,von-mises,velocity"}).is_null());
        const std::vector<std::string> lines = linesOf(m_shop.path("press.csv"));
        QVERIFY2(lines[0].find("contact force z [N]") != std::string::npos &&
                     lines[0].find("velocity x [mm/s]") != std::string::npos &&
                     lines[0].find("von Mises stress [MPa]") != std::string::npos,
                 lines[0].c_str());
        double pressed = 0; // up by the floor and down by the block
        for (std::size_t i = 1; i < lines.size(); ++i)
            pressed += std::abs(numbersOf(lines[i])[10]);
        QVERIFY2(pressed > 0.1, std::to_string(pressed).c_str());
    }

    void nodesOutsideAreTold()
    {
        writeNodes(m_shop.path("mixed.csv"), {m_box.center(), m_box.center() + Vec3(0, 0, 0.5)});
        const json report = fields("mixed.csv", "mixed_out.csv", {"--fields", "displacement"});
        QVERIFY(!report.is_null());
        QCOMPARE(report.at("nodes_outside").get<int>(), 1);
        QCOMPARE(report.at("warnings").size(), std::size_t{1});
        const std::vector<std::string> lines = linesOf(m_shop.path("mixed_out.csv"));
        QVERIFY2(lines[2].find(",,,") != std::string::npos, lines[2].c_str());
        writeNodes(m_shop.path("far.csv"), {Vec3(5, 5, 5)});
        const Outcome far = run("far.csv", "far_out.csv", {});
        QCOMPARE(far.status, 1);
        QVERIFY2(far.errors.find("no node lies in the bodies") != std::string::npos, far.errors.c_str());
        QVERIFY(!QFile::exists(m_shop.qPath("far_out.csv")));
    }

    void wrongUseIsSaid()
    {
        QCOMPARE(run("mesh.inp", "out.xyz", {}).status, 2);
        const Outcome word = run("mesh.inp", "out.csv", {"--fields", "sorrow"});
        QCOMPARE(word.status, 2);
        QVERIFY2(word.errors.find("no field \"sorrow\"") != std::string::npos, word.errors.c_str());
        QCOMPARE(run("none.inp", "out.csv", {}).status, 2);
        QCOMPARE(run("mesh.inp", "out.csv", {"--entry", "99"}).status, 2);
    }

    void runsOfRecipesTellAtTheirEnd()
    {
        const std::string text = R"({"version": 1, "part": {"file": "BAR"}, "objects": 400,
            "material": {"preset": "silicone-rubber"},
            "fixtures": [{"name": "end", "box_mm": [-1, -1, -1, 30, 21, 21]}], "gravity_m_s2": [0, 0, -9.81],
            "duration_s": 0.02})";
        std::string recipe = text;
        recipe.replace(recipe.find("BAR"), 3, bar);
        std::ofstream(m_shop.path("sag.recipe.json")) << recipe;
        const QStringList command{"run",     m_shop.qPath("sag.recipe.json"), "--out", m_shop.qPath("out"), "--json",
                                  "--nodes", m_shop.qPath("mesh.inp")};
        QCOMPARE(workshop::runKnead(command).status, 2); // and no output
        const Outcome outcome = workshop::runKnead(command + QStringList{"--fields-output", m_shop.qPath("sag.vtu")});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        QVERIFY(json::parse(outcome.out).at("files")[0] == m_shop.path("sag.vtu"));
        const FieldFile read = readField(m_shop.path("sag.vtu"), {}, TaskControl::none());
        QVERIFY(std::ranges::any_of(read.field.displacements, [](const Vec3& u) { return u.z() < -1e-5; }));
    }

private:
    Outcome run(const char* nodes, const char* output, const QStringList& more) const
    {
        return workshop::runKnead(QStringList{"fields", m_shop.qPath("bar.knead"), "--json", "--nodes",
                                              m_shop.qPath(nodes), "--output", m_shop.qPath(output)} +
                                  more);
    }

    /// The report; null where it failed.
    json fields(const char* nodes, const char* output, const QStringList& more = {}) const
    {
        const Outcome outcome = run(nodes, output, more);
        if (outcome.status != 0)
            qWarning("%s", outcome.errors.c_str());
        return outcome.status == 0 ? json::parse(outcome.out) : json();
    }

    Workshop m_shop;
    Box m_box;
};

QTEST_GUILESS_MAIN(FieldsCommandTest)
#include "fields_command_test.moc"
