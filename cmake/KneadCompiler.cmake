# Compiler settings shared by every target of the project.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set_property(GLOBAL PROPERTY USE_FOLDERS ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

find_program(KNEAD_CCACHE ccache)
if(KNEAD_CCACHE)
    # By what files say, comments too, not by what is left after the preprocessor: a precompiled header holds checksums of its files, by which
    # the compiler knows what is read already. Where only a comment changed, an older one would be taken, and its classes be there twice.
    set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_DEPEND=1 ${KNEAD_CCACHE})
endif()

# Some 170 programs are linked, in a fifth of the time that the usual linker takes.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=mold KNEAD_HAS_MOLD)
if(KNEAD_HAS_MOLD)
    add_link_options(-fuse-ld=mold)
endif()

add_library(knead_settings INTERFACE)
target_compile_options(knead_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
    -Wno-missing-field-initializers)   # options are structs with defaults, given by name
if(KNEAD_WARNINGS_ARE_ERRORS)
    target_compile_options(knead_settings INTERFACE -Werror)
endif()
# Asserts name their files from the top of the source tree, wherever it lies.
target_compile_options(knead_settings INTERFACE -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=
    -fmacro-prefix-map=${PROJECT_BINARY_DIR}/=)
# What people run has its asserts, too, and containers that end the program where an index is out of range: an error found at once
# loses nothing that recovery does not bring back; one that goes on may write a wrong file.
target_compile_options(knead_settings INTERFACE -UNDEBUG)
target_compile_definitions(knead_settings INTERFACE _GLIBCXX_ASSERTIONS)
if(KNEAD_SANITIZE)
    target_compile_options(knead_settings INTERFACE -fsanitize=${KNEAD_SANITIZE} -fno-omit-frame-pointer -g)
    target_link_options(knead_settings INTERFACE -fsanitize=${KNEAD_SANITIZE})
endif()
if(KNEAD_COVERAGE)
    # These come after what targets say themselves. With fewer optimizations GCC 12 warns of strings and containers where nothing is
    # wrong. Threads count at the same time.
    target_compile_options(knead_settings INTERFACE -O1 --coverage -fprofile-update=prefer-atomic -Wno-error)
    target_link_options(knead_settings INTERFACE --coverage)
endif()

# A layer is one static library whose headers are included from the project root: "core/geometry/vec3.h".
# The dependencies of a layer are the only include folders it sees, so a wrong arrow does not compile:
# each layer's own folder is published through a link in the build tree that only its users get.
#
# knead_add_layer(ui TOGETHER COMPUTES_NOTHING): what files include takes most of the time, so ten are compiled as one, in which
# their names must differ; less is made of its code, in less time.
function(knead_add_layer name)
    cmake_parse_arguments(arg "TOGETHER;COMPUTES_NOTHING" "" "" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
    add_library(knead_${name} STATIC ${sources})
    # Shared libraries are made of it, such as the module for Python: nothing of it is seen outside of them.
    set_target_properties(knead_${name} PROPERTIES LINKER_LANGUAGE CXX POSITION_INDEPENDENT_CODE ON
        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    set(published ${PROJECT_BINARY_DIR}/include/${name})
    file(MAKE_DIRECTORY ${published})
    file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${published}/${name} SYMBOLIC)
    target_include_directories(knead_${name} PUBLIC $<BUILD_INTERFACE:${published}>)
    target_link_libraries(knead_${name} PRIVATE $<BUILD_INTERFACE:knead_settings>)
    if(arg_TOGETHER AND KNEAD_UNITY)
        set_target_properties(knead_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 10)
    endif()
    if(arg_COMPUTES_NOTHING)
        target_compile_options(knead_${name} PRIVATE $<$<CONFIG:Release>:-O2>)
    endif()
endfunction()
