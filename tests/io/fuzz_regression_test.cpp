#include "io/importer.h"
#include "support/model_flaws.h"

#include <QtTest>

#include <algorithm>
#include <fstream>
#include <iterator>

using namespace knead;

// Damaged files that made the readers crash, hang or say something that is not so. They are read in this process: what
// they did must not happen even there.

namespace {

const std::string folder = std::string(KNEAD_TEST_DATA) + "/fuzz/";

} // namespace

class FuzzRegressionTest : public QObject {
    Q_OBJECT

private slots:
    void damageIsNamed_data();
    void damageIsNamed();
    void facesWithoutCornersAreRefused();
    void promisedNumbersMustBeThere();
    void facesWithoutTrianglesAreTold();

private:
    std::string write(const std::string& name, const std::string& text) const
    {
        const std::string path = m_folder.filePath(name.c_str()).toStdString();
        std::ofstream(path, std::ios::binary) << text;
        return path;
    }
    /// Why a file is refused, or what is said of it when what is left of it is read.
    static std::string refusalOf(const std::string& path)
    {
        try {
            const Model model = importFile(path);
            return model.warnings.empty() ? std::string() : model.warnings.front().english();
        } catch (const std::runtime_error& error) {
            return error.what();
        }
    }

    QTemporaryDir m_folder;
};

void FuzzRegressionTest::damageIsNamed_data()
{
    QTest::addColumn<std::string>("words");
    const auto row = [](const char* file, const char* words) { QTest::newRow(file) << std::string(words); };
    row("cut_in_header.ply", "the header of the PLY file has no end");
    row("cut_in_list_property.ply", "the header of the PLY file has no end");
    row("end_of_header_damaged.ply", "the header of the PLY file has no end");
    row("property_damaged.ply", "the line \"proper z\" in the header");
    row("corner_beyond_vertices.ply", "corners that are not there");
    row("line_without_direction.step", "#177 refers to something of the wrong kind");
    row("curve_of_itself.step", "refers to something of the wrong kind");
    row("curve_on_surface_without_items.step", "#59 refers to something of the wrong kind");
    row("edge_lacks_vertex.step", "#24 refers to something of the wrong kind");
    row("loop_lacks_edge.step", "#19 and 8 more refer to something of the wrong kind");
    row("face_lacks_bound.step", "#210 refers to something of the wrong kind");
    row("solid_lacks_shell.igs", "entity 3 of the IGES file (type 186) refers to something of the wrong kind");
    row("face_lacks_loop.igs", "entity 69 of the IGES file (type 510) refers to something of the wrong kind");
    row("edge_lacks_vertices.igs", "(type 504) has 18 values where 77 are needed");
    row("boundary_of_wrong_type.igs", "(type 144) refers to something of the wrong kind");
    row("spline_without_degree.igs", "(type 128) states an impossible count");
    row("line_of_six_values.igs", "(type 110) has 6 values where 7 are needed");
    row("mesh_outside_of_edges.brep", "its faces lead far away from their edges");
    row("directory_counted_wrong.igs", "line 37 of section D of the IGES file has another number");
    row("values_twice.igs", "(type 110) has its values twice");
}

void FuzzRegressionTest::damageIsNamed()
{
    QFETCH(std::string, words);
    const std::string name = QTest::currentDataTag();
    const std::string sentence = refusalOf(folder + name);
    QVERIFY2(sentence.find(words) != std::string::npos, sentence.c_str());
    QCOMPARE(flawOfRefusal(sentence, name), std::string());
}

void FuzzRegressionTest::facesWithoutCornersAreRefused()
{
    const std::string sentence =
        refusalOf(write("empty.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                     "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
                                     "end_header\n0 0 0\n1 0 0\n0 1 0\n0\n3 0 1 2\n"));
    QVERIFY2(sentence.find("corners that are not there") != std::string::npos, sentence.c_str());
}

void FuzzRegressionTest::promisedNumbersMustBeThere()
{
    const std::string sentence =
        refusalOf(write("promise.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n"
                                       "property float x\nproperty float y\nproperty float z\nelement face 1\n"
                                       "property list uchar int vertex_indices\nend_header\nabcdefghijkl"));
    QVERIFY2(sentence.find("fewer numbers than its header promises") != std::string::npos, sentence.c_str());
}

/// A face of which a boundary says nonsense: it has edges, so it counts for the size of the part, and is not seen.
void FuzzRegressionTest::facesWithoutTrianglesAreTold()
{
    std::ifstream file(folder + "seeds/assembly.igs", std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::string boundary = "142,0,211,0,215,2;";
    const std::size_t place = text.find(boundary);
    QVERIFY(place != std::string::npos);
    text.replace(place, boundary.size(), "142,211,0,215,2;  "); // the columns stay
    const Model model = importFile(write("bare.igs", text));
    QCOMPARE(flawOf(model), std::string());
    QVERIFY(std::any_of(model.parts.begin(), model.parts.end(), [](const Part& part) {
        return std::any_of(part.warnings.begin(), part.warnings.end(), [](const knead::Message& warning) {
            return warning.english().find("1 face that no triangles could be found for") != std::string::npos;
        });
    }));
}

QTEST_GUILESS_MAIN(FuzzRegressionTest)
#include "fuzz_regression_test.moc"
