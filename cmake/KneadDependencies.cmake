# Third-party packages. All of them come from Debian 12; packages.txt holds the list.
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(assimp REQUIRED)
find_package(EXPAT 2.5 REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(zstd REQUIRED)
find_package(SQLite3 3.37 REQUIRED)
find_package(SQLiteCpp REQUIRED)
find_package(Qt6 6.4 REQUIRED COMPONENTS Core DBus Gui LinguistTools Widgets OpenGL OpenGLWidgets Svg Test)
# Qt has the mouse and writes all words: neither VTK's interaction nor its text is loaded.
find_package(VTK 9.1 REQUIRED COMPONENTS
    CommonCore CommonDataModel FiltersCore FiltersSources RenderingCore RenderingOpenGL2 IOOggTheora)
if(VTK_VERSION VERSION_GREATER_EQUAL 9.4)
    message(WARNING "Knead is tried with VTK 9.1 to 9.3; this is ${VTK_VERSION}")
endif()

# The module for Python is built where pybind11 is, for the Python of the system, which has NumPy.
if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that the module is for")
endif()
set(PYBIND11_FINDPYTHON ON)
find_package(pybind11 2.10 QUIET)
option(KNEAD_BUILD_PYTHON "Build the module for Python" ${pybind11_FOUND})
if(KNEAD_BUILD_PYTHON AND NOT pybind11_FOUND)
    message(FATAL_ERROR "The module for Python needs pybind11 and Python's headers: install pybind11-dev and python3-dev, or say "
        "-DKNEAD_BUILD_PYTHON=OFF")
endif()

include(KneadOpenCascade)
if(NOT OpenCASCADE_FOUND)
    message(FATAL_ERROR "Knead needs OpenCASCADE; ./dev setup installs it")
endif()
if(KNEAD_OCCT_VERSION VERSION_LESS 7.6 OR KNEAD_OCCT_VERSION VERSION_GREATER 7.9)
    message(FATAL_ERROR "Knead needs OpenCASCADE 7.6 to 7.9; found ${KNEAD_OCCT_VERSION}")
endif()

# 3D mice, through spacenavd. It has no CMake package either.
find_path(KNEAD_SPNAV_INCLUDE spnav.h REQUIRED)
find_library(KNEAD_SPNAV spnav REQUIRED)
