#include "io/library_versions.h"

#include "core/computing_versions.h"

#include <Standard_Version.hxx>
#include <assimp/version.h>
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
            {"Zstandard", ZSTD_versionString(), "BSD"},
            {"zlib", zlibVersion(), "zlib"},
            {"libpng", png_get_libpng_ver(nullptr), "libpng"},
            {"Assimp", assimpVersion(), "BSD"},
            {"JSON for Modern C++", jsonVersion(), "MIT"}};
}

} // namespace knead
