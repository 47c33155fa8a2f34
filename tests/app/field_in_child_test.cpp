#include "app/cad_process.h"
#include "app/cad_program.h"
#include "io/fields/nodal_mesh.h"
#include "support/sample_fields.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fstream>

using namespace knead;
using samples::sample;

/// Fields and meshes of other programs, read by the program in a process of its own.
class FieldInChildTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setCadProgram(cadProgramBeside(KNEAD_PROGRAM)); }
    void aFieldComesBackWhole();
    void aMeshComesBackWhole();
    void whatIsWrongIsSaid();
    void cancellingEndsIt();

private:
    std::string write(const std::string& name, const std::string& content) const
    {
        const std::string path = m_folder.filePath(name.c_str()).toStdString();
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }

    QTemporaryDir m_folder;
};

void FieldInChildTest::aFieldComesBackWhole()
{
    const std::string path = write("räumlich 'u'.vtu", samples::xmlVtk(sample(), {.isCompressed = true}));
    const FieldFile file =
        readFieldInChild(path, {.step = 0, .name = "velocity & more", .unit = "cm"}, TaskControl::none());
    QCOMPARE(file.path, path);
    QCOMPARE(file.format, std::string("VTK"));
    QCOMPARE(file.names, (std::vector<std::string>{"displacement", "velocity & more"}));
    QCOMPARE(file.unit, std::string("cm"));
    QCOMPARE(file.field.nodes.size(), sample().nodes.size());
    for (std::size_t i = 0; i < file.field.nodes.size(); ++i) {
        QVERIFY((file.field.nodes[i] - 0.01 * sample().nodes[i]).norm() < 1e-14);
        QCOMPARE(file.field.displacements[i], file.field.nodes[i]);
    }
    const FieldFile guessed = readFieldInChild(path, {}, TaskControl::none());
    QCOMPARE(guessed.name, std::string("displacement"));
    QCOMPARE(guessed.warnings.size(), 1U);
    QCOMPARE(guessed.warnings[0].subject(), std::string("Unit"));
}

void FieldInChildTest::aMeshComesBackWhole()
{
    const NodalMesh mesh = readNodesInChild(write("mesh.inp", samples::input(sample())), {}, TaskControl::none());
    QCOMPARE(mesh.nodes.size(), sample().nodes.size());
    QCOMPARE(mesh.labels.back(), std::int64_t{12});
    QCOMPARE(mesh.cells.types, (std::vector<std::uint8_t>{12, 12}));
}

void FieldInChildTest::whatIsWrongIsSaid()
{
    const auto sentence = [](const std::string& path) {
        try {
            readFieldInChild(path, {}, TaskControl::none());
        } catch (const Problem& problem) {
            return std::string(problem.what());
        }
        return std::string();
    };
    QCOMPARE(sentence(write("a.csv", "1 2 3 4 5\n")),
             std::string(
                 "a.csv: it cannot be told what its 5 columns are; name them in the first line: X, Y, Z, DX, DY, DZ."));
    QCOMPARE(sentence(m_folder.filePath("missing.frd").toStdString()),
             std::string("missing.frd: the file does not exist."));
}

void FieldInChildTest::cancellingEndsIt()
{
    class Cancel final : public TaskControl {
    public:
        void report(double, std::string_view) override { m_isCancelled = true; }
        bool isCancelled() const override { return m_isCancelled; }

    private:
        bool m_isCancelled = false;
    };
    Cancel cancel;
    const std::string path = write("steps.frd", samples::frd(std::vector(2000, sample())));
    QVERIFY_THROWS_EXCEPTION(Cancelled, readFieldInChild(path, {}, cancel));
}

QTEST_GUILESS_MAIN(FieldInChildTest)
#include "field_in_child_test.moc"
