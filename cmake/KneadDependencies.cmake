# Third-party packages. All of them come from Debian 12; packages.txt holds the list.
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(assimp REQUIRED)
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

# OpenCASCADE: its version file refuses 7.6.3 when 7.6 is asked for, and its COMPONENTS fail, so both are checked here.
find_package(OpenCASCADE REQUIRED NO_MODULE)
set(KNEAD_OCCT_VERSION ${OpenCASCADE_MAJOR_VERSION}.${OpenCASCADE_MINOR_VERSION})
if(KNEAD_OCCT_VERSION VERSION_LESS 7.6 OR KNEAD_OCCT_VERSION VERSION_GREATER 7.9)
    message(FATAL_ERROR "Knead needs OpenCASCADE 7.6 to 7.9; found ${KNEAD_OCCT_VERSION}")
endif()
set(knead_occt_toolkits TKernel TKMath TKG2d TKG3d TKGeomBase TKBRep TKGeomAlgo TKTopAlgo TKShHealing TKMesh TKPrim
    TKBO TKBool TKFillet TKOffset TKCDF TKLCAF TKCAF TKXCAF TKXSBase)
if(KNEAD_OCCT_VERSION VERSION_LESS 7.8)
    list(APPEND knead_occt_toolkits TKSTEP TKSTEPBase TKSTEPAttr TKSTEP209 TKXDESTEP TKIGES TKXDEIGES)
else()
    list(APPEND knead_occt_toolkits TKDESTEP TKDEIGES)
endif()
add_library(knead_occt INTERFACE)
target_include_directories(knead_occt SYSTEM INTERFACE ${OpenCASCADE_INCLUDE_DIR})
target_link_libraries(knead_occt INTERFACE ${knead_occt_toolkits})

# 3D mice, through spacenavd. It has no CMake package either.
find_path(KNEAD_SPNAV_INCLUDE spnav.h REQUIRED)
find_library(KNEAD_SPNAV spnav REQUIRED)

# lib3mf has no CMake package in Debian. Its headers include each other from their own folder.
find_path(KNEAD_LIB3MF_INCLUDE Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf REQUIRED)
find_library(KNEAD_LIB3MF 3MF REQUIRED)
add_library(knead_lib3mf INTERFACE)
target_include_directories(knead_lib3mf SYSTEM INTERFACE ${KNEAD_LIB3MF_INCLUDE})
target_link_libraries(knead_lib3mf INTERFACE ${KNEAD_LIB3MF})
