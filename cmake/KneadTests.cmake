# Tests: each file is one QtTest class with its own main() and stands for itself. Compiled one by one, most of the time goes into what
# all of them include, so eight become one program here, with a link to it by the name of each test. -DKNEAD_UNITY=OFF makes one
# program of each, which is quicker for who works on one. ALONE are tests with libraries or options of their own, and those that run
# code before main().
#
# knead_share_test_headers(NAME core_headers LIBRARIES knead_core HEADERS ...): what nearly every test of a folder begins with is
# parsed once, these headers, too; knead_add_tests(... HEADERS core_headers) takes it.
set(knead_tests_of_one_program 8)

function(knead_share_test_headers)
    cmake_parse_arguments(arg "" "NAME" "LIBRARIES;HEADERS" ${ARGN})
    add_library(${arg_NAME} OBJECT ${PROJECT_SOURCE_DIR}/tests/support/precompiled.cpp)
    knead_set_up_test(${arg_NAME} ${arg_LIBRARIES})
    if(NOT "knead_ui" IN_LIST arg_LIBRARIES)
        target_compile_definitions(${arg_NAME} PUBLIC QT_NO_EMIT) # the name is one of TBB's too
    endif()
    target_precompile_headers(${arg_NAME} PRIVATE
        <QtTest> <Eigen/Core> <algorithm> <cmath> <functional> <map> <memory> <string> <vector> ${arg_HEADERS})
endfunction()

function(knead_set_up_test target)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_link_libraries(${target} PRIVATE knead_settings Qt6::Test ${ARGN})
    target_compile_definitions(${target} PRIVATE
        KNEAD_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data" KNEAD_RESOURCES="${PROJECT_SOURCE_DIR}/resources")
    # What takes time is in the libraries. With fewer optimizations GCC 12 warns of containers and optional values where nothing is
    # wrong.
    target_compile_options(${target} PRIVATE
        "$<$<CONFIG:Release>:-O1;-Wno-array-bounds;-Wno-stringop-overflow;-Wno-maybe-uninitialized>")
endfunction()

# knead_add_tests(NAMES core_fill_test ... SOURCES fill_test.cpp ... LIBRARIES ... [HEADERS ...] [DEFINITIONS ...] [DEPENDS ...] [ALONE])
function(knead_add_tests)
    cmake_parse_arguments(arg "ALONE" "HEADERS" "NAMES;SOURCES;LIBRARIES;DEFINITIONS;DEPENDS" ${ARGN})
    foreach(name IN LISTS arg_NAMES)
        knead_register_test(${name} "${arg_LIBRARIES}")
    endforeach()
    if(arg_ALONE OR NOT KNEAD_UNITY)
        foreach(name source IN ZIP_LISTS arg_NAMES arg_SOURCES)
            knead_add_test_program(${name} ${source} ${source})
        endforeach()
        return()
    endif()
    list(LENGTH arg_NAMES count)
    foreach(begin RANGE 0 ${count} ${knead_tests_of_one_program})
        if(begin LESS count)
            list(SUBLIST arg_NAMES ${begin} ${knead_tests_of_one_program} names)
            list(SUBLIST arg_SOURCES ${begin} ${knead_tests_of_one_program} sources)
            knead_join_tests("${names}" "${sources}")
        endif()
    endforeach()
endfunction()

# In the scope of a caller that has arg_HEADERS, arg_LIBRARIES, arg_DEFINITIONS and arg_DEPENDS, as the next.
# @param source what is compiled; behind it the tests in it, each of which includes what is made of its class
function(knead_add_test_program name source)
    add_executable(${name} ${source})
    # As AUTOMOC would, in a tenth of its time.
    foreach(test ${ARGN})
        cmake_path(GET test STEM stem)
        set(moc ${CMAKE_CURRENT_BINARY_DIR}/${stem}.moc)
        qt_generate_moc(${test} ${moc})
        target_sources(${name} PRIVATE ${moc})
    endforeach()
    target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
    knead_set_up_test(${name} ${arg_LIBRARIES})
    target_compile_definitions(${name} PRIVATE ${arg_DEFINITIONS})
    if(arg_DEPENDS)
        add_dependencies(${name} ${arg_DEPENDS})
    endif()
    if(name MATCHES "window")
        add_dependencies(${name} when_display_answers)
    endif()
    if(arg_HEADERS)
        target_precompile_headers(${name} REUSE_FROM ${arg_HEADERS})
        target_compile_definitions(${name} PRIVATE $<TARGET_PROPERTY:${arg_HEADERS},INTERFACE_COMPILE_DEFINITIONS>)
    endif()
endfunction()

# One program of several tests, called as the first with an "s"; each is run by a link of its name.
function(knead_join_tests names sources)
    list(GET names 0 program)
    string(APPEND program s)
    set(joined ${CMAKE_CURRENT_BINARY_DIR}/${program}.cpp)
    add_custom_command(OUTPUT ${joined}
        COMMAND ${CMAKE_COMMAND} "-DOUTPUT=${joined}" "-DNAMES=${names}" "-DSOURCES=${sources}"
            -P ${PROJECT_SOURCE_DIR}/cmake/JoinTests.cmake
        DEPENDS ${sources} ${PROJECT_SOURCE_DIR}/cmake/JoinTests.cmake VERBATIM)
    knead_add_test_program(${program} ${joined} ${sources})
    # Files that are included are taken for headers, in which lambdas must not see what is in an unnamed namespace.
    target_compile_options(${program} PRIVATE -Wno-subobject-linkage)
    foreach(name ${names})
        add_custom_command(TARGET ${program} POST_BUILD
            COMMAND ${CMAKE_COMMAND} -E create_symlink ${program} ${CMAKE_CURRENT_BINARY_DIR}/${name} VERBATIM)
        add_custom_target(${name} DEPENDS ${program})
    endforeach()
endfunction()

find_program(KNEAD_XVFB_RUN xvfb-run REQUIRED)
add_executable(when_display_answers ${PROJECT_SOURCE_DIR}/tests/support/when_display_answers.c)
function(knead_register_test name libraries)
    set(program ${CMAKE_CURRENT_BINARY_DIR}/${name})
    if(name MATCHES "^ui_|window")
        # Two at a time and before all others, since a person's clicks are answered at once. Each has a display of its own: of
        # the windows on one display only one has the keyboard.
        get_property(windows GLOBAL PROPERTY KNEAD_WINDOW_TESTS)
        math(EXPR lane "(0${windows}) % 2")
        math(EXPR windows "0${windows} + 1")
        set_property(GLOBAL PROPERTY KNEAD_WINDOW_TESTS ${windows})
        set(display)
        if(name MATCHES "window")
            # Which does not begin anew when nobody is left on it: it would refuse who comes meanwhile.
            set(display ${KNEAD_XVFB_RUN} -a -n 4${lane}0 -s "-screen 0 1920x1200x24 -noreset"
                $<TARGET_FILE:when_display_answers>)
        endif()
        add_test(NAME ${name} COMMAND ${display} ${program})
        set_tests_properties(${name} PROPERTIES RESOURCE_LOCK window${lane} COST 50)
    else()
        add_test(NAME ${name} COMMAND nice -n 15 ${program})
    endif()
    # Qt Test's own limit is of a class, whatever its name says, and five minutes where nothing is said.
    set(environment QTEST_FUNCTION_TIMEOUT=900000)
    if("knead_ui" IN_LIST libraries)
        # Qt's offscreen platform has no OpenGL for the view; ./dev test gives the suite a display of its own.
        list(APPEND environment QT_QPA_PLATFORM=xcb)
    endif()
    set_tests_properties(${name} PROPERTIES TIMEOUT 900 ENVIRONMENT "${environment}")
endfunction()
