#include "io/library_versions.h"

#include <Standard_Version.hxx>
#include <assimp/version.h>
#include <nlohmann/json.hpp>
#include <png.h>
#include <sqlite3.h>
#include <zlib.h>
#include <zstd.h>

#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <set>

using namespace knead;

namespace {

QString versionOf(const std::string& name)
{
    const std::vector<LibraryVersion> all = libraryVersions();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const LibraryVersion& library) { return library.name == name; });
    return found == all.end() ? QString() : QString::fromStdString(found->version);
}

} // namespace

/// What the box About lists.
class LibraryVersionsTest : public QObject {
    Q_OBJECT

private slots:
    void eachIsNamedOnceWithVersionAndLicense()
    {
        static const QRegularExpression version("^\\d+(\\.\\d+)+$");
        std::set<std::string> names;
        for (const LibraryVersion& library : libraryVersions()) {
            QVERIFY2(names.insert(library.name).second, library.name.c_str());
            QVERIFY2(version.match(QString::fromStdString(library.version)).hasMatch(),
                     (library.name + " " + library.version).c_str());
            QVERIFY2(!library.license.empty(), library.name.c_str());
        }
    }

    /// All that core and io are linked with, or made from.
    void noneIsLeftOut()
    {
        for (const char* name : {"OpenCASCADE", "Eigen", "oneTBB", "SQLite", "SQLiteC++", "Zstandard", "zlib", "libpng",
                                 "Assimp", "Expat", "JSON for Modern C++"})
            QVERIFY2(!versionOf(name).isEmpty(), name);
        QCOMPARE(libraryVersions().size(), std::size_t{11});
    }

    /// What runs is as new as the headers, or newer within the same compatible series.
    void theyAreThoseOfTheHeaders()
    {
        QCOMPARE(versionOf("OpenCASCADE"), QString(OCC_VERSION_COMPLETE));
        QCOMPARE(versionOf("SQLite").section('.', 0, 0).toInt(), SQLITE_VERSION_NUMBER / 1'000'000);
        QVERIFY(versionOf("SQLite").section('.', 1, 1).toInt() >= SQLITE_VERSION_NUMBER / 1000 % 1000);
        QCOMPARE(versionOf("Zstandard").section('.', 0, 0).toInt(), ZSTD_VERSION_MAJOR);
        QVERIFY(versionOf("Zstandard").section('.', 1, 1).toInt() >= ZSTD_VERSION_MINOR);
        QCOMPARE(versionOf("zlib").section('.', 0, 0), QString(ZLIB_VERSION).section('.', 0, 0));
        QCOMPARE(versionOf("libpng").section('.', 0, 1), QString(PNG_LIBPNG_VER_STRING).section('.', 0, 1));
        QCOMPARE(versionOf("Assimp").section('.', 0, 0).toUInt(), aiGetVersionMajor());
        QCOMPARE(versionOf("JSON for Modern C++"), QString("%1.%2.%3")
                                                       .arg(NLOHMANN_JSON_VERSION_MAJOR)
                                                       .arg(NLOHMANN_JSON_VERSION_MINOR)
                                                       .arg(NLOHMANN_JSON_VERSION_PATCH));
    }
};

QTEST_GUILESS_MAIN(LibraryVersionsTest)
#include "library_versions_test.moc"
