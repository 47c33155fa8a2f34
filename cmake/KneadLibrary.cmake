# What others build on: find_package(Knead COMPONENTS core io), by cmake --install BUILD --component development, after building the
# target knead_library. Who only installs the program gets nothing of it.
add_custom_target(knead_library DEPENDS knead_core knead_io)
set(development COMPONENT development EXCLUDE_FROM_ALL)
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/knead)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Knead)

# Vectors of Eigen in the headers lie as they do here, whatever instructions others compile for.
target_compile_definitions(knead_core INTERFACE $<INSTALL_INTERFACE:EIGEN_MAX_ALIGN_BYTES=16>)
target_compile_features(knead_core INTERFACE cxx_std_20)
foreach(layer core io)
    target_include_directories(knead_${layer} INTERFACE $<INSTALL_INTERFACE:${headers}>)
    set_target_properties(knead_${layer} PROPERTIES EXPORT_NAME ${layer})
    install(TARGETS knead_${layer} EXPORT Knead_${layer} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} ${development})
    install(EXPORT Knead_${layer} NAMESPACE Knead:: DESTINATION ${package} FILE Knead_${layer}.cmake ${development})
endforeach()

# Of core all but what its kernels share, which is compiled in several ways, and what needs TBB.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core DESTINATION ${headers} ${development} FILES_MATCHING PATTERN "*.h"
    PATTERN "*_impl.h" EXCLUDE PATTERN sphere_lanes.h EXCLUDE PATTERN neighborhood_cache.h EXCLUDE)
# Of io what reads and writes files, and what that is said with: nothing of OpenCASCADE and other libraries.
foreach(header importer previewer material_library export/exporter export/job_file fields/field_reader fields/field_writer
        fields/nodal_mesh files/byte_sink files/safe_file formats/cad_format formats/mesh_writer mesh/mesh_body
        picture/picture_writer project/packing project/project_file recipe/recipe_of_project recipe/recipe_override
        recipe/recipe_reader study/study_reader worker/cad_worker worker/isolated_export worker/isolated_field
        worker/isolated_import)
    cmake_path(GET header PARENT_PATH folder)
    install(FILES ${PROJECT_SOURCE_DIR}/io/${header}.h DESTINATION ${headers}/io/${folder} ${development})
endforeach()

include(CMakePackageConfigHelpers)
configure_file(cmake/KneadConfig.cmake.in package/KneadConfig.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/KneadConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/KneadConfig.cmake ${PROJECT_BINARY_DIR}/package/KneadConfigVersion.cmake
    cmake/KneadOpenCascade.cmake DESTINATION ${package} ${development})
install(DIRECTORY resources/examples/library DESTINATION ${CMAKE_INSTALL_DATADIR}/knead/examples ${development})
install(FILES cmake/debian/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libknead-dev ${development})
