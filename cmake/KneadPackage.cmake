# Packages by CPack, see ./dev package: a .deb, and an archive that runs wherever it is unpacked.
set(KNEAD_MAINTAINER "The Knead maintainers <maintainers@knead.example.org>" CACHE STRING "Who answers for packages")
# The archive is named after the system whose libraries it needs: "debian12".
cmake_host_system_information(RESULT system QUERY DISTRIB_ID)
cmake_host_system_information(RESULT release QUERY DISTRIB_VERSION_ID)

set(CPACK_PACKAGE_NAME knead)
set(CPACK_PACKAGE_VENDOR "The Knead maintainers")
set(CPACK_PACKAGE_CONTACT ${KNEAD_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "CAD workbench in which a part is a lump of real material")
set(CPACK_PACKAGE_DESCRIPTION
"Knead opens STEP, IGES and mesh files, turns their parts into lumps of
material, and lets one push, bend, squeeze and cut them with tools while one
watches. What comes of it is exported as STEP, with the smooth faces, names
and colors that it came with, or as a mesh.
.
Recipes, sweeps, measuring and deformation by number work on the command
line, too, without a display.")
set(CPACK_PACKAGE_FILE_NAME knead-${PROJECT_VERSION}-${system}${release}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_THREADS 0)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(TARGET knead_python) # is of this Python, whose NumPy it takes
    math(EXPR next "${Python_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PACKAGE_DEPENDS
        "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next}), python3-numpy")
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS qt6-translations-l10n)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "calculix-ccx, slurm-client, spacenavd")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/write_changelog.cmake)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/debian/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
include(CPack)

# What Knead's own build takes of numbers, threads and files is what its libraries are linked with.
file(STRINGS ${PROJECT_SOURCE_DIR}/packages.txt lines)
list(FILTER lines INCLUDE REGEX "^lib(eigen3|tbb|occt-[a-z-]+|assimp|expat1|png|sqlite3|sqlitecpp|zstd)-dev$|^zlib1g-dev$")
list(JOIN lines ", " needed)

# libknead-dev: the component development alone, see KneadLibrary.cmake.
file(WRITE ${PROJECT_BINARY_DIR}/CPackDevelopmentConfig.cmake [=[
include(${CMAKE_CURRENT_LIST_DIR}/CPackConfig.cmake)
set(CPACK_PACKAGE_NAME libknead-dev)
set(CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_CURRENT_LIST_DIR};knead;development;/")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "libraries of the CAD workbench Knead, for programs of one's own")
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS)
]=])
file(APPEND ${PROJECT_BINARY_DIR}/CPackDevelopmentConfig.cmake "set(CPACK_DEBIAN_PACKAGE_DEPENDS \"${needed}\")\n")
