#include "io/files/safe_file.h"
#include "io/formats/mesh_writer.h"
#include "io/picture/picture_writer.h"
#include "io/worker/export_worker.h"
#include "io/worker/isolated_export.h"
#include "support/deep.h"
#include "support/export_jobs.h"
#include "support/killed_child.h"
#include "support/shapes.h"

#include <QtTest>

#include <array>
#include <filesystem>
#include <fstream>

using namespace knead;
using namespace knead::killed;

namespace {

bool isCad(const std::string& ending)
{
    return ending == "step" || ending == "brep";
}

std::string nameOf(std::uint32_t number)
{
    return number % 2 == 0 ? "even" : "odd";
}

std::vector<MeshBody> bodiesNumber(std::uint32_t number)
{
    const bool isEven = number % 2 == 0;
    return {{nameOf(number), Color{isEven ? 1.0F : 0.0F, 0, 0}, shapes::sphere(isEven ? 0.01 : 0.02, 120)}};
}

ExportJob jobNumber(std::uint32_t number)
{
    static const std::array<Model, 2> models{export_jobs::example("bracket.step"), export_jobs::example("bar.step")};
    ExportJob job = export_jobs::jobOf(models.at(number % 2), nullptr);
    job.parts[0].part.name = nameOf(number);
    return job;
}

void exportNumber(std::uint32_t number, const std::string& path, const std::string& ending)
{
    if (isCad(ending))
        exportIsolated("/proc/self/exe", path, jobNumber(number), TaskControl::none());
    else if (ending == "png")
        writePicture(path, bodiesNumber(number), {.width = 320, .height = 200});
    else
        writeMeshes(path, bodiesNumber(number));
}

/// Until it is killed.
[[noreturn]] void exportForever(const std::string& path, const std::string& ending)
{
    for (std::uint32_t number = 1;; ++number) {
        say(number);
        exportNumber(number, path, ending);
        say(number);
    }
}

std::string contentOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

/// A kill while something is exported over an older file leaves that or the new one, whole.
class ExportKillTest : public QObject {
    Q_OBJECT

    int m_between = 0;

private slots:
    /// All that come out with the same bytes each time; see ReplayTest.
    void aFileIsTheOldOrTheNewOne_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<int>("kills");
        QTest::addColumn<int>("wait"); // at most [us]
        for (const char* ending : {"stl", "obj", "ply", "glb", "3mf", "vtp", "png"})
            QTest::newRow(ending) << QString(ending) << loadOf(4, 8) << 30'000;
        for (const char* ending : {"step", "brep"})
            QTest::newRow(ending) << QString(ending) << loadOf(2, 4) << 300'000;
    }

    void aFileIsTheOldOrTheNewOne()
    {
        QFETCH(QString, ending);
        QFETCH(int, kills);
        QFETCH(int, wait);
        const QTemporaryDir folder;
        const std::string path = folder.filePath("out." + ending).toStdString();
        std::array<std::string, 2> expected; // by whether the number is odd
        for (const std::uint32_t number : {1U, 0U}) {
            exportNumber(number, path, ending.toStdString());
            expected.at(number) = contentOf(path);
        }
        QVERIFY(expected[0] != expected[1] && expected[0].size() > 500);
        fuzz::Random random(static_cast<std::uint64_t>(kills) + ending.at(0).unicode());
        for (int trial = 0; trial < kills; ++trial) {
            Child child({"--export", path, ending.toStdString()});
            QVERIFY(child.waitForBegin());
            waitAWhile(random, static_cast<std::size_t>(wait));
            const Said said = child.kill();
            const std::string now = contentOf(path);
            QVERIFY2(now == expected.at(said.ended % 2) || now == expected.at(said.begun % 2),
                     std::to_string(trial).c_str());
            m_between += said.isCut() ? 1 : 0;
            removeLeftOvers(path);
            QCOMPARE(filesIn(folder), ending == "obj" ? 2 : 1); // with its materials
            exportNumber(0, path, ending.toStdString());
        }
    }

    void manyWereKilledInTheMiddle()
    {
        qInfo("%d were killed while they exported", m_between);
        QVERIFY(m_between > loadOf(15, 30));
    }

private:
    static int filesIn(const QTemporaryDir& folder)
    {
        return static_cast<int>(std::distance(std::filesystem::directory_iterator(folder.path().toStdString()), {}));
    }
};

int main(int argc, char** argv)
{
    if (isExportWorker(argc, argv))
        return runExportWorker(argc, argv);
    if (argc == 4 && std::string(argv[1]) == "--export")
        exportForever(argv[2], argv[3]);
    QCoreApplication application(argc, argv);
    ExportKillTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "export_kill_test.moc"
