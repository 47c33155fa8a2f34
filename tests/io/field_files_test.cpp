#include "io/fields/field_reader.h"
#include "io/fields/field_writer.h"
#include "support/sample_fields.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fstream>

using namespace knead;
using samples::Sample;
using samples::sample;

namespace {

constexpr double exact = 1e-12;      // of texts with 17 digits and of double precision
constexpr double single = 1e-6;      // of bytes in single precision
constexpr double frdDigits = 1.1e-5; // six digits

constexpr double millimetre = 1e-3;

/// The largest difference of two lists of vectors, of the largest vector; 1 where they have not as many.
double difference(const std::vector<Vec3>& found, const std::vector<Vec3>& wanted, double unit)
{
    if (found.size() != wanted.size())
        return 1;
    double most = 0;
    double largest = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        most = std::max(most, (found[i] - unit * wanted[i]).norm());
        largest = std::max(largest, unit * wanted[i].norm());
    }
    return most / largest;
}

/// "1,5 ..." where numbers have a comma.
std::string withCommas(std::string line)
{
    std::ranges::replace(line, '.', ',');
    return line;
}

} // namespace

/// One field in every format that is read.
class FieldFilesTest : public QObject {
    Q_OBJECT

private slots:
    void everyFormatHoldsTheField_data();
    void everyFormatHoldsTheField();
    void tablesAreToldByTheirHeadings_data();
    void tablesAreToldByTheirHeadings();
    void stepsAreChosen_data();
    void stepsAreChosen();
    void vectorsAreChosenByName();
    void unitsComeFromThePersonOrTheFile();
    void pointsOfOurOwnSurfacesAreWhereTheyWere();
    void collectionsNameFilesOfEachTime();
    void nodesWithoutDisplacementsAreLeftOut();
    void nodesInOnePlaceBecomeOne();
    void meshesAreReadWithTheirCells_data();
    void meshesAreReadWithTheirCells();
    void whatIsWrittenIsReadAgain();

private:
    std::string write(const std::string& name, const std::string& content) const
    {
        const std::string path = m_folder.filePath(name.c_str()).toStdString();
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }
    FieldFile read(const std::string& name, const std::string& content, const FieldChoice& choice = {}) const
    {
        return readField(write(name, content), choice, TaskControl::none());
    }

    QTemporaryDir m_folder;
};

void FieldFilesTest::everyFormatHoldsTheField_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<double>("tolerance");
    const auto add = [](const std::string& row, const std::string& name, const std::string& content, double tolerance) {
        QTest::addRow("%s", row.c_str()) << QString::fromStdString(name) << QByteArray::fromStdString(content)
                                         << tolerance;
    };
    const Sample one = sample();
    add("frd short", "a.frd", samples::frd({one}, 0), frdDigits);
    add("frd long", "a.frd", samples::frd({one}, 1), frdDigits);
    add("frd bytes", "a.frd", samples::frd({one}, 2), single);
    for (const char* kind : {"UNSTRUCTURED_GRID", "POLYDATA", "STRUCTURED_GRID"})
        for (const bool isBinary : {false, true})
            for (const bool isField : {false, true})
                add(samples::text("vtk %s%s%s", kind, isBinary ? " bytes" : "", isField ? " field" : ""), "a.vtk",
                    samples::legacyVtk(one, kind, isBinary, isField), exact);
    add("vtu text", "a.vtu", samples::xmlVtk(one, {.format = "ascii"}), exact);
    add("vts text", "a.vts", samples::xmlVtk(one, {.kind = "StructuredGrid", .format = "ascii"}), exact);
    for (const auto order : {std::endian::little, std::endian::big})
        for (int bits = 0; bits < 16; ++bits) {
            const samples::XmlStyle style{.format = (bits & 1) != 0 ? "binary" : "appended",
                                          .isBase64 = (bits & 2) != 0,
                                          .isCompressed = (bits & 4) != 0,
                                          .hasLongHeaders = (bits & 8) != 0,
                                          .isSingle = bits == 0,
                                          .order = order};
            add(samples::text("vtu %d %d", bits, order == std::endian::big), "a.vtu", samples::xmlVtk(one, style),
                style.isSingle ? single : exact);
        }
    for (const bool isVersion4 : {false, true})
        for (const bool isBinary : {false, true})
            add(samples::text("msh %d %d", isVersion4, isBinary), "a.msh", samples::gmsh({one}, isVersion4, isBinary),
                exact);
    add("rpt", "a.rpt", samples::report({one}), exact);
    // The content decides, not the ending.
    add("vtu called frd", "a.frd", samples::xmlVtk(one, {}), exact);
    add("frd called txt", "a.txt", samples::frd({one}), frdDigits);
}

void FieldFilesTest::everyFormatHoldsTheField()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    QFETCH(double, tolerance);
    const FieldFile file = read(name.toStdString(), content.toStdString());
    const double nodes = difference(file.field.nodes, sample().nodes, millimetre);
    const double values = difference(file.field.displacements, sample().values, millimetre);
    QVERIFY2(nodes < tolerance && values < tolerance, qPrintable(QString("%1 %2").arg(nodes).arg(values)));
    QCOMPARE(file.steps.size(), 1U);
    QCOMPARE(file.unit, std::string("mm"));
    QVERIFY(isFieldFile(file.path));
}

void FieldFilesTest::tablesAreToldByTheirHeadings_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<double>("unitOfNodes");
    QTest::addColumn<double>("unitOfValues");
    const auto add = [](const char* row, const std::string& heading, const auto& line, double nodes = millimetre,
                        double values = millimetre) {
        QTest::newRow(row) << QByteArray::fromStdString(samples::table(sample(), heading, line)) << nodes << values;
    };
    const auto join = [](const char* separator) {
        return [separator](std::size_t, const Vec3& X, const Vec3& u) {
            return samples::triple(X, separator) + separator + samples::triple(u, separator);
        };
    };
    const auto labelled = [](std::size_t i, const Vec3& X, const Vec3& u) {
        return samples::text("%zu,", i + 7) + samples::triple(X, ",") + "," + samples::triple(u, ",");
    };
    add("blanks", "", join(" "));
    add("tabs and a comment", "# made by hand\n\n", join("\t"));
    add("commas and line ends of DOS", "X,Y,Z,DX,DY,DZ\r\n",
        [&](std::size_t i, const Vec3& X, const Vec3& u) { return join(",")(i, X, u) + "\r"; });
    add("decimal commas", "X;Y;Z;UX;UY;UZ\n",
        [&](std::size_t i, const Vec3& X, const Vec3& u) { return withCommas(join(";")(i, X, u)); });
    add("decimal commas between blanks", "",
        [&](std::size_t i, const Vec3& X, const Vec3& u) { return withCommas(join(" ")(i, X, u)); });
    add("labels without headings", "", labelled);
    add("units in headings", "Node Number,X Location (m),Y Location (m),Z Location (m),U1 [um],U2 [um],U3 [um]\n",
        labelled, 1, 1e-6);
    add("units below headings", "x;y;z;disp_x;disp_y;disp_z\ncm;cm;cm;mm;mm;mm\n", join(";"), 1e-2, millimetre);
    add("another order", "temperature;dz;dy;dx;z;y;x;\n", [](std::size_t, const Vec3& X, const Vec3& u) {
        return "20.5;" + samples::triple(u.reverse(), ";") + ";" + samples::triple(X.reverse(), ";") + ";";
    });
    add("quotes as of ParaView",
        "\"displacement:0\",\"displacement:1\",\"displacement:2\",\"Points:0\",\"Points:1\",\"Points:2\"\n",
        [](std::size_t, const Vec3& X, const Vec3& u) {
            return samples::triple(u, ",") + "," + samples::triple(X, ",");
        });
    add("a mark of UTF-8", "\xEF\xBB\xBFX [inch],Y [inch],Z [inch],DX [inch],DY [inch],DZ [inch]\n", join(","), 0.0254,
        0.0254);
    add("FORTRAN", "", [](std::size_t, const Vec3& X, const Vec3& u) {
        std::string line =
            samples::text("%.16e %.16e %.16e %.16e %.16e %.16e", X.x(), X.y(), X.z(), u.x(), u.y(), u.z());
        std::ranges::replace(line, 'e', 'D');
        return line;
    });
}

void FieldFilesTest::tablesAreToldByTheirHeadings()
{
    QFETCH(QByteArray, content);
    QFETCH(double, unitOfNodes);
    QFETCH(double, unitOfValues);
    const FieldFile file = read("table.csv", content.toStdString());
    QVERIFY(difference(file.field.nodes, sample().nodes, unitOfNodes) < exact);
    QVERIFY(difference(file.field.displacements, sample().values, unitOfValues) < exact);
    QCOMPARE(file.format, std::string("table"));
}

void FieldFilesTest::stepsAreChosen_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("second");
    const std::vector<Sample> steps{sample(1), sample(2), sample(3)};
    QTest::newRow("frd") << QByteArray::fromStdString(samples::frd(steps)) << "1.00000";
    QTest::newRow("frd of bytes") << QByteArray::fromStdString(samples::frd(steps, 2)) << "1.00000";
    QTest::newRow("msh") << QByteArray::fromStdString(samples::gmsh(steps, true, true)) << "1";
    QTest::newRow("rpt") << QByteArray::fromStdString(samples::report(steps))
                         << "Step-2, Increment 1: Step Time = 1.000";
}

void FieldFilesTest::stepsAreChosen()
{
    QFETCH(QByteArray, content);
    QFETCH(QString, second);
    const FieldFile last = read("steps", content.toStdString());
    QCOMPARE(last.step, 2U);
    QCOMPARE(last.steps.size(), 3U);
    QCOMPARE(last.steps[1], second.toStdString());
    QVERIFY(difference(last.field.displacements, sample(3).values, millimetre) < frdDigits);
    const FieldFile one = read("steps", content.toStdString(), {.step = 1});
    QCOMPARE(one.step, 1U);
    QVERIFY(difference(one.field.displacements, sample(2).values, millimetre) < frdDigits);
    const auto saysLast = [](const knead::Message& message) {
        return message.english().find("the last one was read") != std::string::npos;
    };
    QVERIFY(std::ranges::any_of(last.warnings, saysLast));
    QVERIFY(std::ranges::none_of(one.warnings, saysLast));
    QVERIFY_THROWS_EXCEPTION(Problem, read("steps", content.toStdString(), {.step = 3}));
}

void FieldFilesTest::vectorsAreChosenByName()
{
    const FieldFile forces = read("a.frd", samples::frd({sample()}), {.name = "FORC"});
    QCOMPARE(forces.names, (std::vector<std::string>{"DISP", "FORC"}));
    QCOMPARE(forces.name, std::string("FORC"));
    QVERIFY(difference(forces.field.displacements, sample(1000).values, millimetre) < frdDigits);
    const FieldFile others = read("a.vtu", samples::xmlVtk(sample(), {}), {.name = "velocity & more"});
    QVERIFY(difference(others.field.displacements, sample().nodes, millimetre) < exact);
    QVERIFY_THROWS_EXCEPTION(Problem, read("a.frd", samples::frd({sample()}), {.name = "STRESS"}));
    // Nothing tells which of the two is meant.
    QVERIFY_THROWS_EXCEPTION(Problem, read("a.vtu", samples::xmlVtk(sample(), {.name = "something"})));
}

void FieldFilesTest::unitsComeFromThePersonOrTheFile()
{
    const FieldFile inches = read("a.vtu", samples::xmlVtk(sample(), {}), {.unit = "inch"});
    QCOMPARE(inches.unit, std::string("inch"));
    QVERIFY(difference(inches.field.nodes, sample().nodes, 0.0254) < exact);
    QVERIFY(difference(inches.field.displacements, sample().values, 0.0254) < exact);
    // A name with a unit is about the values alone.
    const FieldFile mixed = read("a.vtu", samples::xmlVtk(sample(), {.name = "displacement [m]"}), {.unit = "cm"});
    QVERIFY(difference(mixed.field.nodes, sample().nodes, 1e-2) < exact);
    QVERIFY(difference(mixed.field.displacements, sample().values, 1) < exact);
    QVERIFY_THROWS_EXCEPTION(Problem, read("a.vtu", samples::xmlVtk(sample(), {}), {.unit = "furlong"}));
}

/// Knead's own export of meshes has points where they came to lie, and says so by the names of its parts.
void FieldFilesTest::pointsOfOurOwnSurfacesAreWhereTheyWere()
{
    Sample moved = sample();
    for (std::size_t i = 0; i < moved.nodes.size(); ++i)
        moved.nodes[i] += moved.values[i];
    for (Vec3& value : moved.values)
        value *= millimetre;
    const std::string texts =
        "<Array type=\"String\" Name=\"part names\" NumberOfTuples=\"1\" format=\"ascii\">\n66 97 114 0\n</Array>\n"
        "<Array type=\"String\" Name=\"length unit\" NumberOfTuples=\"1\" format=\"ascii\">\n109 109 0\n</Array>\n";
    const FieldFile file =
        read("a.vtp", samples::xmlVtk(moved, {.kind = "PolyData", .name = "displacement [m]", .fieldData = texts}));
    QVERIFY(difference(file.field.nodes, sample().nodes, millimetre) < exact);
    QVERIFY(difference(file.field.displacements, sample().values, millimetre) < exact);
    QVERIFY(file.warnings.empty());
}

void FieldFilesTest::collectionsNameFilesOfEachTime()
{
    for (int step = 1; step <= 2; ++step)
        write(samples::text("part%d.vtu", step), samples::xmlVtk(sample(step), {}));
    const std::string collection =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\"><Collection>\n"
        "<DataSet timestep=\"0.25\" part=\"0\" file=\"part1.vtu\"/>\n"
        "<DataSet timestep=\"0.5\" part=\"0\" file=\"part2.vtu\"/>\n</Collection></VTKFile>\n";
    const FieldFile last = read("all.pvd", collection);
    QCOMPARE(last.steps, (std::vector<std::string>{"0.25", "0.5"}));
    QCOMPARE(last.step, 1U);
    QVERIFY(difference(last.field.displacements, sample(2).values, millimetre) < exact);
    const FieldFile first = read("all.pvd", collection, {.step = 0});
    QVERIFY(difference(first.field.displacements, sample(1).values, millimetre) < exact);
}

void FieldFilesTest::nodesWithoutDisplacementsAreLeftOut()
{
    Sample holed = sample();
    holed.values[3] = Vec3::Constant(std::nan(""));
    holed.values[7].y() = HUGE_VAL;
    const FieldFile file = read("a.vtu", samples::xmlVtk(holed, {}));
    QCOMPARE(file.field.nodes.size(), holed.nodes.size() - 2);
    QCOMPARE(file.warnings.back().english(), std::string("2 of 12 nodes have no displacement and were left out."));
}

void FieldFilesTest::nodesInOnePlaceBecomeOne()
{
    Sample doubled = sample();
    doubled.nodes.push_back(doubled.nodes[4]);
    doubled.values.push_back(doubled.values[4] + Vec3(0.2, 0, 0));
    const FieldFile file = read("a.txt", samples::table(doubled, "", [](std::size_t, const Vec3& X, const Vec3& u) {
                                    return samples::triple(X) + " " + samples::triple(u);
                                }));
    QCOMPARE(file.field.nodes.size(), sample().nodes.size());
    QVERIFY((file.field.displacements[4] - millimetre * (sample().values[4] + Vec3(0.1, 0, 0))).norm() < 1e-15);
}

void FieldFilesTest::meshesAreReadWithTheirCells_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<bool>("hasCells");
    const auto add = [](const char* row, const std::string& content, bool hasCells = true) {
        QTest::newRow(row) << QByteArray::fromStdString(content) << hasCells;
    };
    add("inp", samples::input(sample()));
    add("frd", samples::frd({sample()}));
    add("frd of bytes", samples::frd({sample()}, 2));
    add("vtu", samples::xmlVtk(sample(), {.isCompressed = true}));
    add("vtk", samples::legacyVtk(sample(), "UNSTRUCTURED_GRID", true, false));
    add("msh 2", samples::gmsh({sample()}, false, false));
    add("msh 2 of bytes", samples::gmsh({sample()}, false, true));
    add("msh 4", samples::gmsh({sample()}, true, false));
    add("msh 4 of bytes", samples::gmsh({sample()}, true, true));
    add("table",
        samples::table(sample(), "", [](std::size_t, const Vec3& X, const Vec3&) { return samples::triple(X); }),
        false);
}

void FieldFilesTest::meshesAreReadWithTheirCells()
{
    QFETCH(QByteArray, content);
    QFETCH(bool, hasCells);
    const NodalMesh mesh = readNodes(write("mesh", content.toStdString()), "m", TaskControl::none());
    QVERIFY(difference(mesh.nodes, sample().nodes, 1) < frdDigits);
    QCOMPARE(mesh.unit, std::string("m"));
    QCOMPARE(mesh.cells.isEmpty(), !hasCells);
    if (!hasCells)
        return;
    QCOMPARE(mesh.cells.types, (std::vector<std::uint8_t>{12, 12}));
    QCOMPARE(mesh.cells.offsets, (std::vector<std::int64_t>{0, 8, 16}));
    for (std::size_t i = 0; i < 16; ++i)
        QCOMPARE(mesh.cells.connectivity[i], std::int64_t{samples::bricks()[i / 8][i % 8]});
}

void FieldFilesTest::whatIsWrittenIsReadAgain()
{
    const Sample original = sample();
    NodalFields fields;
    NodalFields::Array displacement{"displacement [um]", 3, {}};
    NodalFields::Array stress{"residual stress [MPa]", 6, {}};
    for (std::size_t i = 0; i < original.nodes.size(); ++i) {
        fields.nodes.push_back(millimetre * original.nodes[i]);
        fields.labels.push_back(static_cast<std::int64_t>(10 * i + 5));
        for (const double value : original.values[i])
            displacement.values.push_back(1000 * value);
        stress.values.insert(stress.values.end(), 6, 0.1 * static_cast<double>(i));
    }
    fields.arrays = {displacement, stress};
    fields.unit = "cm";
    fields.cells = readNodes(write("mesh.inp", samples::input(sample())), "mm", TaskControl::none()).cells;
    for (const char* name : {"out.vtu", "out.csv"}) {
        const std::string path = m_folder.filePath(name).toStdString();
        writeFields(path, fields);
        const FieldFile again = readField(path, {}, TaskControl::none());
        QVERIFY(difference(again.field.nodes, original.nodes, millimetre) < exact);
        QVERIFY(difference(again.field.displacements, original.values, millimetre) < exact);
        QCOMPARE(again.unit, std::string("cm"));
        QCOMPARE(again.names.size(), 1U);
        QVERIFY(again.warnings.empty());
    }
    const std::string vtu = m_folder.filePath("out.vtu").toStdString();
    const NodalMesh mesh = readNodes(vtu, {}, TaskControl::none());
    QCOMPARE(mesh.cells.connectivity, fields.cells.connectivity);
    QCOMPARE(mesh.cells.offsets, fields.cells.offsets);
    fields.arrays[0].values.pop_back();
    QVERIFY_THROWS_EXCEPTION(Problem, writeFields(vtu, fields));
    QVERIFY_THROWS_EXCEPTION(Problem, writeFields(m_folder.filePath("out.frd").toStdString(), fields));
}

QTEST_GUILESS_MAIN(FieldFilesTest)
#include "field_files_test.moc"
