# The tests: one Catch2 program for all *_test.cpp, and tests that need a compiler or an installed tree.

find_package(Catch2 REQUIRED)
include(Catch)

file(GLOB_RECURSE test_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/*_test.cpp)
if(NOT LIBRATION_BUILD_COMMAND)
    list(FILTER test_sources EXCLUDE REGEX "/tests/(text|run|option|sweep|studies|command|paper)/")
endif()

add_executable(libration-tests ${test_sources})
target_include_directories(libration-tests PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/src)
if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
    target_include_directories(libration-tests PRIVATE ${PROJECT_SOURCE_DIR}/tests/catch3)
endif()
target_link_libraries(libration-tests PRIVATE libration::ball Catch2::Catch2WithMain libration-warnings)
# The C interface, linked as by a separate program.
target_link_libraries(libration-tests PRIVATE libration-c)
# Certificates are checked by a separate program.
target_link_libraries(libration-tests PRIVATE ZLIB::ZLIB)
target_compile_definitions(libration-tests PRIVATE
    LIBRATION_SYMBOLS="${c_symbols}"
    LIBRATION_CHECKER="${PROJECT_SOURCE_DIR}/check/libration_check.py"
    LIBRATION_LISTS="${PROJECT_SOURCE_DIR}/problems/series/")
# Calls it while memory allocation fails, by replacing the allocator.
if(NOT LIBRATION_SANITIZE)
    add_executable(libration-failing-memory
        ${PROJECT_SOURCE_DIR}/tests/c/failing_memory.cpp ${PROJECT_SOURCE_DIR}/tests/c/failing_allocation.cpp)
    add_library(libration-failing-allocation MODULE ${PROJECT_SOURCE_DIR}/tests/c/failing_allocation.cpp)
    set_target_properties(libration-failing-memory libration-failing-allocation PROPERTIES UNITY_BUILD OFF)
    target_link_libraries(libration-failing-allocation PRIVATE libration-warnings)
    target_link_libraries(libration-failing-memory PRIVATE libration-c libration-warnings)
    target_compile_definitions(libration-tests PRIVATE
        LIBRATION_FAILING_MEMORY="$<TARGET_FILE:libration-failing-memory>"
        LIBRATION_FAILING_ALLOCATION="$<TARGET_FILE:libration-failing-allocation>")
    add_dependencies(libration-tests libration-failing-memory libration-failing-allocation)
endif()
# MPFI, under Boost's intervals: a type for which the library has no special support.
target_link_libraries(libration-tests PRIVATE mpfi)
set_batch(libration-tests 50)
target_precompile_headers(libration-tests PRIVATE ${PROJECT_SOURCE_DIR}/tests/precompiled.hpp)
# Half of the compile time of -O2; the command, which many of the tests start, is compiled as it is installed. Catch's
# macros without a handler per assertion, so that exceptions end the test case: a quarter of the code size.
target_compile_options(libration-tests PRIVATE $<$<CONFIG:Release>:-Og>)
target_compile_definitions(libration-tests PRIVATE
    CATCH_CONFIG_FAST_COMPILE
    LIBRATION_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    LIBRATION_REFERENCE_DIR="${PROJECT_SOURCE_DIR}/tests/reference")
if(LIBRATION_BUILD_COMMAND)
    target_link_libraries(libration-tests PRIVATE libration-program libration-studies libration-claims libration-sweep)
    target_compile_definitions(libration-tests PRIVATE LIBRATION_COMMAND="$<TARGET_FILE:libration-command>")
    add_dependencies(libration-tests libration-command)
    # The tables for C++ are compiled as by their users.
    target_compile_definitions(libration-tests PRIVATE LIBRATION_COMPILER="${CMAKE_CXX_COMPILER}"
        LIBRATION_BOOST="${Boost_INCLUDE_DIRS}")
endif()
catch_discover_tests(libration-tests PROPERTIES TIMEOUT 600)

# Random statements compared with independent true values: some here, and many in tests/long.sh.
find_package(fmt REQUIRED)
file(GLOB_RECURSE attack_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/attack/*.cpp)
add_executable(libration-attack ${attack_sources} ${PROJECT_SOURCE_DIR}/src/command/table/elliptic_values.cpp)
target_include_directories(libration-attack PRIVATE
    ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/src/command)
target_compile_definitions(libration-attack PRIVATE
    LIBRATION_REFERENCE_DIR="${PROJECT_SOURCE_DIR}/tests/reference")
target_link_libraries(libration-attack PRIVATE libration::ball fmt::fmt libration-warnings)
target_compile_options(libration-attack PRIVATE $<$<CONFIG:Release>:-Og>)
if(LIBRATION_BUILD_COMMAND)
    add_dependencies(libration-attack libration-command)
    add_test(NAME attack COMMAND libration-attack statements 160)
    set_tests_properties(attack PROPERTIES TIMEOUT 600)
endif()

# The installed tree: complete, usable by find_package(libration), and sufficient for the first program of docs/cpp.md.
set(installed ${PROJECT_BINARY_DIR}/installed)
list(JOIN sanitizer_options " " consumer_flags) # linking our archives requires the sanitizers too
set(consumer ${CMAKE_COMMAND}
    -D FLAGS=${consumer_flags}
    -D PREFIX=${installed}
    -D PROJECT=${PROJECT_SOURCE_DIR}/tests/consumer
    -D COMPILER=${CMAKE_CXX_COMPILER}
    -D GENERATOR=${CMAKE_GENERATOR})
add_test(NAME install
    COMMAND ${CMAKE_COMMAND}
        -D BUILD=${PROJECT_BINARY_DIR}
        -D CONFIG=$<CONFIG>
        -D PREFIX=${installed}
        -D PROGRAM=$<$<BOOL:${LIBRATION_BUILD_COMMAND}>:${CMAKE_INSTALL_BINDIR}/libration>
        -P ${PROJECT_SOURCE_DIR}/cmake/check_install.cmake)
add_test(NAME consumer
    COMMAND ${consumer}
        -D BUILD=${PROJECT_BINARY_DIR}/consumer
        -P ${PROJECT_SOURCE_DIR}/cmake/check_consumer.cmake)
add_test(NAME consumer_of_balls
    COMMAND ${consumer}
        -D BUILD=${PROJECT_BINARY_DIR}/consumer_of_balls
        -D PROGRAM=proved.cpp
        -D TARGET=ball
        -P ${PROJECT_SOURCE_DIR}/cmake/check_consumer.cmake)
add_test(NAME consumer_without_flint
    COMMAND ${consumer}
        -D BUILD=${PROJECT_BINARY_DIR}/consumer_without_flint
        -D PROGRAM=templates.cpp
        -D TARGET=headers
        -D WITHOUT_FLINT=ON
        -P ${PROJECT_SOURCE_DIR}/cmake/check_consumer.cmake)
add_test(NAME cpp_example
    COMMAND ${consumer}
        -D BUILD=${PROJECT_BINARY_DIR}/cpp_example
        -D README=${PROJECT_SOURCE_DIR}/docs/cpp.md
        -P ${PROJECT_SOURCE_DIR}/cmake/check_consumer.cmake)
add_test(NAME equations_example
    COMMAND ${consumer}
        -D BUILD=${PROJECT_BINARY_DIR}/equations
        -D README=${PROJECT_SOURCE_DIR}/docs/equations_cpp.md
        -P ${PROJECT_SOURCE_DIR}/cmake/check_consumer.cmake)
add_test(NAME own_scalar
    COMMAND ${consumer}
        -D BUILD=${PROJECT_BINARY_DIR}/own_scalar
        -D README=${PROJECT_SOURCE_DIR}/docs/scalars.md
        -D "FLAGS=${consumer_flags} -I${PROJECT_SOURCE_DIR}/docs/examples"
        -P ${PROJECT_SOURCE_DIR}/cmake/check_consumer.cmake)
add_test(NAME missing_operation
    COMMAND ${CMAKE_COMMAND}
        -D TYPE=${PROJECT_SOURCE_DIR}/docs/examples/counting.hpp
        -D INCLUDE=${PROJECT_SOURCE_DIR}/include
        -D COMPILER=${CMAKE_CXX_COMPILER}
        -D "FLAGS=-idirafter ${Boost_INCLUDE_DIRS}"
        -D WORK=${PROJECT_BINARY_DIR}/missing_operation
        -P ${PROJECT_SOURCE_DIR}/cmake/check_missing_operation.cmake)
# The first example of docs/cpp.md with the flags of pkg-config.
add_test(NAME pkg_config
    COMMAND ${CMAKE_COMMAND}
        -D PREFIX=${installed}
        -D PAGE=${PROJECT_SOURCE_DIR}/docs/cpp.md
        -D CXX=${CMAKE_CXX_COMPILER}
        -D "FLAGS=${consumer_flags}"
        -D WORK=${PROJECT_BINARY_DIR}/pkg_config
        -P ${PROJECT_SOURCE_DIR}/cmake/check_pkg_config.cmake)
# The examples for C and Fortran, compiled with the installed files alone.
add_test(NAME c_examples
    COMMAND ${CMAKE_COMMAND}
        -D PREFIX=${installed}
        -D EXAMPLES=${PROJECT_SOURCE_DIR}/docs/examples
        -D EXPECTED=${PROJECT_SOURCE_DIR}/tests/reference/c_examples.csv
        -D WORK=${PROJECT_BINARY_DIR}/c_examples
        -D FLAGS=${consumer_flags}
        -P ${PROJECT_SOURCE_DIR}/cmake/check_c_examples.cmake)
set_tests_properties(c_examples PROPERTIES FIXTURES_REQUIRED installed TIMEOUT 120)
set_tests_properties(install PROPERTIES FIXTURES_SETUP installed TIMEOUT 120)
set_tests_properties(consumer consumer_of_balls consumer_without_flint cpp_example equations_example own_scalar pkg_config PROPERTIES FIXTURES_REQUIRED installed TIMEOUT 600)

add_test(NAME versions
    COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -P ${PROJECT_SOURCE_DIR}/cmake/check_versions.cmake)

# The documents do not contain the expressions in tests/words/banned.txt, and messages, comments and studies no more of
# them than tests/words/present.txt lists.
set(worded
    README.md
    docs
    CHANGELOG.md
    CONTRIBUTING.md
    REFERENCES.md
    studies/errata.md.in
    results/errata.md)
find_program(words_python python3 PATHS /usr/bin)
if(words_python)
    add_test(NAME words
        COMMAND ${words_python} ${PROJECT_SOURCE_DIR}/tests/words/check_words.py
            --readme-lines 100
            --sentences ${PROJECT_SOURCE_DIR}/tests/words/sentences.txt
            ${worded})
    set_tests_properties(words PROPERTIES TIMEOUT 20)
    add_test(NAME words_of_sources COMMAND ${PROJECT_SOURCE_DIR}/tests/words/sources)
    set_tests_properties(words_of_sources PROPERTIES TIMEOUT 120)
    add_test(NAME tables_of_contents COMMAND ${words_python} ${PROJECT_SOURCE_DIR}/tests/docs/check_toctree.py)
    set_tests_properties(tables_of_contents PROPERTIES TIMEOUT 20)
    add_test(NAME places_of_planted_faults
        COMMAND ${words_python} ${PROJECT_SOURCE_DIR}/tests/faults/plant.py --places)
    set_tests_properties(places_of_planted_faults PROPERTIES TIMEOUT 20)
    # Changes of published certificates are reported by ./run check.
    add_test(NAME changed_certificates
        COMMAND ${words_python} -I ${PROJECT_SOURCE_DIR}/tests/certificates/changed.py
            ${PROJECT_BINARY_DIR}/changed_certificates)
    set_tests_properties(changed_certificates PROPERTIES TIMEOUT 60)
    # Both checkers have the same verdicts; many more in tests/long.sh.
    if(TARGET libration-check)
        set(certified ${PROJECT_SOURCE_DIR}/results/certified)
        add_test(NAME two_checkers_of_certificates
            COMMAND ${words_python} ${PROJECT_SOURCE_DIR}/tests/certificates/second.py --mutations 25
                $<TARGET_FILE:libration-check> ${certified}/logistic.cert ${certified}/detest_e4.cert
                ${certified}/detest_a4.cert ${certified}/sakiadis.cert)
        set_tests_properties(two_checkers_of_certificates PROPERTIES TIMEOUT 60)
        add_test(NAME certificates_by_the_checker_in_c
            COMMAND ${words_python} -I ${PROJECT_SOURCE_DIR}/check/certified.py --c logistic harmonic)
        set_tests_properties(certificates_by_the_checker_in_c PROPERTIES TIMEOUT 60)
        add_test(NAME forged_certificates
            COMMAND ${words_python} ${PROJECT_SOURCE_DIR}/tests/certificates/forge.py --count 75
                $<TARGET_FILE:libration-command> $<TARGET_FILE:libration-check>)
        set_tests_properties(forged_certificates PROPERTIES TIMEOUT 300)
    endif()
endif()

# The readers of tables in docs/ whose tools are in Debian.
if(LIBRATION_BUILD_COMMAND)
    add_test(NAME completion COMMAND ${PROJECT_SOURCE_DIR}/tests/completion/check $<TARGET_FILE:libration-command>)
    add_test(NAME python_reader
        COMMAND ${CMAKE_COMMAND}
            -D LIBRATION=$<TARGET_FILE:libration-command>
            -D READER=${PROJECT_SOURCE_DIR}/docs/readers/read_table.py
            -D WORK=${PROJECT_BINARY_DIR}
            -P ${PROJECT_SOURCE_DIR}/cmake/check_reader.cmake)
    add_test(NAME reference_readers
        COMMAND ${CMAKE_COMMAND}
            -D LIBRATION=$<TARGET_FILE:libration-command>
            -D READERS=${PROJECT_SOURCE_DIR}/docs/readers
            -D WORK=${PROJECT_BINARY_DIR}
            -P ${PROJECT_SOURCE_DIR}/cmake/check_reference_readers.cmake)
endif()
