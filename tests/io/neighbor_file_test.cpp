#include "io/fields/field_reader.h"
#include "io/files/neighbor_file.h"
#include "io/importer.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include <filesystem>
#include <fstream>

#include <sys/stat.h>

using namespace knead;

namespace {

const std::string tetrahedron = "mtllib colors.mtl\nusemtl paint\nv 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\n"
                                "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
const std::string paint = "newmtl paint\nKd 1 0 0\n";

std::string replacedText(std::string text, const std::string& before, const std::string& after)
{
    return text.replace(text.find(before), before.size(), after);
}

/// What is said of a file.
template <class Read>
std::string refusalBy(const Read& read)
{
    try {
        read();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

} // namespace

/// Files of strangers name what they like; only ordinary files beside them are read.
class NeighborFileTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void ordinaryFilesBelowAreNeighbors();
    void materialsElsewhereAreNotRead_data();
    void materialsElsewhereAreNotRead();
    void numbersElsewhereAreNotRead_data();
    void numbersElsewhereAreNotRead();
    void fieldsElsewhereAreNotRead();

private:
    std::string write(const std::string& name, const std::string& content) const
    {
        const std::string path = m_folder->filePath(QString::fromStdString(name)).toStdString();
        std::filesystem::create_directories(std::filesystem::path(path).parent_path());
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

/// A folder "own" with a link and a pipe, and files beside it.
void NeighborFileTest::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    write("other.mtl", paint);
    const std::string own = m_folder->filePath("own").toStdString();
    std::filesystem::create_directories(own);
    std::filesystem::create_symlink("../other.mtl", own + "/link.mtl");
    QVERIFY(mkfifo((own + "/pipe.mtl").c_str(), 0600) == 0);
}

void NeighborFileTest::ordinaryFilesBelowAreNeighbors()
{
    const std::string path = write("own/part.obj", tetrahedron);
    const std::string own = m_folder->filePath("own").toStdString();
    QVERIFY(isNeighborFile(write("own/colors.mtl", paint), path));
    QVERIFY(isNeighborFile(write("own/deep/down/colors.mtl", paint), path));
    QVERIFY(isNeighborFile(own + "/deep/../colors.mtl", path));
    for (const char* name : {"/missing.mtl", "/link.mtl", "/pipe.mtl", "/deep", "/../other.mtl", ""})
        QVERIFY2(!isNeighborFile(own + name, path), name);
    QVERIFY(!isNeighborFile("/dev/null", path) && !isNeighborFile("/etc/passwd", path));
    QVERIFY(!isNeighborFile(write("own-too/colors.mtl", paint), path));
    const QString before = QDir::currentPath();
    QDir::setCurrent(QString::fromStdString(own));
    const bool isFoundFromHere =
        isNeighborFile("colors.mtl", "part.obj") && !isNeighborFile("../other.mtl", "part.obj");
    QDir::setCurrent(before);
    QVERIFY(isFoundFromHere);
}

void NeighborFileTest::materialsElsewhereAreNotRead_data()
{
    QTest::addColumn<QString>("library");
    QTest::addColumn<bool>("isRead");
    QTest::newRow("beside") << "colors.mtl" << true;
    QTest::newRow("in a folder") << "deep/colors.mtl" << true;
    QTest::newRow("above") << "../other.mtl" << false;
    QTest::newRow("whole path") << m_folder->filePath("other.mtl") << false;
    QTest::newRow("by a link") << "link.mtl" << false;
    QTest::newRow("pipe, which nobody writes into") << "pipe.mtl" << false;
    QTest::newRow("device") << "/dev/zero" << false;
}

void NeighborFileTest::materialsElsewhereAreNotRead()
{
    QFETCH(QString, library);
    QFETCH(bool, isRead);
    write("own/colors.mtl", paint);
    write("own/deep/colors.mtl", paint);
    const Model model =
        importFile(write("own/part.obj", replacedText(tetrahedron, "colors.mtl", library.toStdString())));
    QCOMPARE(model.parts.size(), 1U);
    const bool isRed = model.parts[0].color && model.parts[0].color->r > 0.9F && model.parts[0].color->g < 0.1F;
    QCOMPARE(isRed, isRead);
}

void NeighborFileTest::numbersElsewhereAreNotRead_data()
{
    QTest::addColumn<QString>("uri");
    QTest::newRow("above") << "../other.mtl";
    QTest::newRow("above, in disguise") << "%2e%2e/other.mtl";
    QTest::newRow("pipe") << "pipe.mtl";
    QTest::newRow("link") << "link.mtl";
    QTest::newRow("device") << "/dev/zero";
}

void NeighborFileTest::numbersElsewhereAreNotRead()
{
    QFETCH(QString, uri);
    const std::string path = write("own/part.gltf", R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":9,"uri":")" +
                                                        uri.toStdString() + R"("}]})");
    const std::string refusal = refusalBy([&] { importFile(path); });
    QVERIFY2(refusal.find("which is not beside it; put it there.") != std::string::npos, refusal.c_str());
}

void NeighborFileTest::fieldsElsewhereAreNotRead()
{
    for (const char* name : {"../other.mtl", "link.mtl", "pipe.mtl", "/dev/zero"}) {
        const std::string path =
            write("own/all.pvd", std::string("<VTKFile type=\"Collection\"><DataSet timestep=\"0\" file=\"") + name +
                                     "\"/></VTKFile>");
        const std::string refusal = refusalBy([&] { readField(path, {}, TaskControl::none()); });
        QVERIFY2(refusal.find("no ordinary file in its folder") != std::string::npos, refusal.c_str());
    }
}

QTEST_GUILESS_MAIN(NeighborFileTest)
#include "neighbor_file_test.moc"
