#include "io/library_versions.h"

#include "core/computing_versions.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <Standard_Version.hxx>
#include <assimp/version.h>
#include <expat.h>
#include <nlohmann/json.hpp>
#include <png.h>
#include <sqlite3.h>
#include <zlib.h>
#include <zstd.h>

namespace knead {

namespace {

std::string assimpVersion()
{
    return std::to_string(aiGetVersionMajor()) + '.' + std::to_string(aiGetVersionMinor()) + '.' +
           std::to_string(aiGetVersionPatch());
}

std::string expatVersion()
{
    const XML_Expat_Version expat = XML_ExpatVersionInfo();
    return std::to_string(expat.major) + '.' + std::to_string(expat.minor) + '.' + std::to_string(expat.micro);
}

std::string sqliteCppVersion()
{
    constexpr int number = SQLITECPP_VERSION_NUMBER;
    return std::to_string(number / 1'000'000) + '.' + std::to_string(number / 1000 % 1000) + '.' +
           std::to_string(number % 1000);
}

std::string jsonVersion()
{
    return std::to_string(NLOHMANN_JSON_VERSION_MAJOR) + '.' + std::to_string(NLOHMANN_JSON_VERSION_MINOR) + '.' +
           std::to_string(NLOHMANN_JSON_VERSION_PATCH);
}

} // namespace

std::vector<LibraryVersion> libraryVersions()
{
    return {{"OpenCASCADE", OCC_VERSION_COMPLETE, "LGPL 2.1 with exception"},
            {"Eigen", eigenVersion(), "MPL 2"},
            {"oneTBB", tbbVersion(), "Apache 2"},
            {"SQLite", sqlite3_libversion(), "public domain"},
            {"SQLiteC++", sqliteCppVersion(), "MIT"},
            {"Zstandard", ZSTD_versionString(), "BSD"},
            {"zlib", zlibVersion(), "zlib"},
            {"libpng", png_get_libpng_ver(nullptr), "libpng"},
            {"Assimp", assimpVersion(), "BSD"},
            {"Expat", expatVersion(), "MIT"},
            {"JSON for Modern C++", jsonVersion(), "MIT"}};
}

} // namespace knead
