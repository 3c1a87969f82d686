# SPDX-License-Identifier: MIT
# One static library per folder of src/. A library sees its own headers and those of the layers it
# names, nothing else: each layer has an include root of its own that holds a link to its folder, so
# an #include against the arrows does not compile.
#
#   vitrine_layer(bvh SOURCES build.cpp ... TESTS build_test.cpp ... USES base [PRIVATE lib ...])
function(vitrine_layer name)
    cmake_parse_arguments(ARG "" "FOLDER" "SOURCES;TESTS;USES;PRIVATE;PUBLIC" ${ARGN})
    if(NOT ARG_FOLDER)
        set(ARG_FOLDER ${name})
    endif()
    set(root ${CMAKE_BINARY_DIR}/include/${name})
    cmake_path(GET ARG_FOLDER PARENT_PATH parent)
    file(MAKE_DIRECTORY ${root}/${parent})
    file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${root}/${ARG_FOLDER} SYMBOLIC)

    add_library(vitrine_${name} STATIC ${ARG_SOURCES})
    target_include_directories(vitrine_${name} PUBLIC ${root})
    list(TRANSFORM ARG_USES PREPEND vitrine_)
    target_link_libraries(vitrine_${name}
        PUBLIC ${ARG_USES} ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} vitrine_flags)
    vitrine_precompile(vitrine_${name} vitrine_base "<base/math.hpp>")

    if(VITRINE_TESTS AND ARG_TESTS)
        add_executable(${name}_test ${ARG_TESTS})
        target_link_libraries(${name}_test PRIVATE vitrine_${name} vitrine_flags GTest::gtest_main)
        vitrine_precompile(${name}_test base_test "<base/math.hpp>" "<gtest/gtest.h>")
        gtest_discover_tests(${name}_test TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60
            WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} PROPERTIES TIMEOUT 300)
    endif()
endfunction()
