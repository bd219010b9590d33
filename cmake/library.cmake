# The library, here and for find_package(libration) after `cmake --install`:
#   libration::headers    the templates alone, linking only MPFR and GMP; of the headers, those that do not include FLINT
#   libration::libration  everything, with the non-template parts compiled once (aliases: libration::proved, libration::ball)
# Sources are in src/libration/MODULE, their headers in include/libration/MODULE.

list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_package(Boost 1.81 REQUIRED CONFIG)
find_package(PkgConfig REQUIRED)
pkg_check_modules(mpfr REQUIRED IMPORTED_TARGET mpfr)
pkg_check_modules(gmp REQUIRED IMPORTED_TARGET gmp)
pkg_check_modules(hwy REQUIRED IMPORTED_TARGET libhwy)
find_package(FLINT 2.9 REQUIRED)
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(ZLIB REQUIRED)
include(cmake/flint_self_test.cmake)

add_library(libration-headers INTERFACE)
add_library(libration::headers ALIAS libration-headers)
set_target_properties(libration-headers PROPERTIES EXPORT_NAME headers)
target_compile_features(libration-headers INTERFACE cxx_std_20)
target_include_directories(libration-headers INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(libration-headers INTERFACE Boost::headers PkgConfig::mpfr PkgConfig::gmp)

# quad is __float128 if GCC provides libquadmath (not on every processor); the header detects it by
# __has_include(<quadmath.h>), so a user who compiles with clang gets the portable type and no library.
include(CheckCXXSourceCompiles)
block()
    set(CMAKE_REQUIRED_LIBRARIES quadmath)
    check_cxx_source_compiles(
        "#include <quadmath.h>
         int main(int count, char**) { return static_cast<int>(sqrtq(static_cast<__float128>(count))) - 1; }"
        LIBRATION_HAS_QUADMATH)
endblock()
if(LIBRATION_HAS_QUADMATH)
    target_link_libraries(libration-headers INTERFACE $<$<CXX_COMPILER_ID:GNU>:quadmath>)
endif()

file(GLOB_RECURSE library_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/libration/*.cpp)
set(vector_sources ${library_sources})
list(FILTER vector_sources INCLUDE REGEX "/([a-z]+_vectors|vector_instructions)\\.cpp$")
list(REMOVE_ITEM library_sources ${vector_sources})

# The catalogue: the texts of problems/ and of its folders algebraic/, delay/, hybrid/ and stiff/, embedded, by name.
file(GLOB problem_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/problems/*.ode ${PROJECT_SOURCE_DIR}/problems/stiff/*.ode
    ${PROJECT_SOURCE_DIR}/problems/hybrid/*.ode ${PROJECT_SOURCE_DIR}/problems/algebraic/*.ode
    ${PROJECT_SOURCE_DIR}/problems/delay/*.ode)
list(SORT problem_files COMPARE FILE_BASENAME)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${problem_files})
set(catalogue_entries "")
foreach(file IN LISTS problem_files)
    cmake_path(GET file STEM name)
    file(READ ${file} text)
    string(APPEND catalogue_entries "        {\"${name}\", R\"ode(${text})ode\"},\n")
endforeach()
# The published lists of coefficients, problems/series/NAME.csv; `published` is what is known of them.
file(GLOB series_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/problems/series/*.csv)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${series_files})
set(series_entries "")
foreach(file IN LISTS series_files)
    cmake_path(GET file STEM name)
    file(READ ${file} text)
    string(APPEND series_entries "        {\"${name}\", R\"list(${text})list\"},\n")
endforeach()
configure_file(cmake/catalogue.cpp.in ${PROJECT_BINARY_DIR}/generated/catalogue.cpp @ONLY)

add_library(libration STATIC ${library_sources} ${PROJECT_BINARY_DIR}/generated/catalogue.cpp)
foreach(alias IN ITEMS libration proved ball)
    add_library(libration::${alias} ALIAS libration)
endforeach()
# Each header compiles alone, as checked by the target all_verify_interface_header_sets of the preset `lint`.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/libration/*.hpp)
target_sources(libration PUBLIC
    FILE_SET headers TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/include FILES ${headers})
# The templates that it compiles once (scalar/compiled.hpp) are declared extern to its users.
target_compile_definitions(libration PUBLIC LIBRATION_COMPILED)
# It is also linked into a shared library (c_interface.cmake): hidden symbols keep calls as direct as in a program.
# Several modules are compiled as one source, in which the names of anonymous namespaces are unique: those of a line, or
# with sanitizers, which double the memory, one directory.
set(units
    "scalar|scalar/ball|digits|function|number"
    "algebra|elliptic|approximant|convergence|pendulum"
    "equation|equation/text"
    "expansion|integration|integration/(taylor|model|root|closed_form|delay)|event"
    "integration/collocation"
    "plane|manifold"
    "hybrid|query"
    "query/(certificate|connection|sets|shooting)"
    "problem|problem/known|verification")
foreach(source IN LISTS library_sources)
    cmake_path(GET source PARENT_PATH unit)
    if(NOT LIBRATION_SANITIZE)
        foreach(folders IN LISTS units)
            if(unit MATCHES "/src/libration/(${folders})$")
                set(unit ${folders})
                break()
            endif()
        endforeach()
    endif()
    string(MAKE_C_IDENTIFIER ${unit} unit)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${unit})
endforeach()
set_target_properties(libration PROPERTIES UNITY_BUILD_MODE GROUP)
if(CMAKE_UNITY_BUILD)
    set_target_properties(libration PROPERTIES JOB_POOL_COMPILE libration_batches)
endif()
set_target_properties(libration PROPERTIES
    POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden)
target_precompile_headers(libration PRIVATE ${PROJECT_SOURCE_DIR}/src/libration/precompiled.hpp)
target_link_libraries(libration
    PUBLIC libration-headers FLINT::FLINT
    PRIVATE ZLIB::ZLIB $<LINK_ONLY:PkgConfig::hwy> $<BUILD_INTERFACE:Eigen3::Eigen>
        $<BUILD_INTERFACE:libration-warnings>)
# A new kind of node, function or operation causes a compile error until each switch handles it.
set(switches_name_all $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wswitch-enum>)
target_compile_options(libration PRIVATE ${switches_name_all})

# The sources that use Highway, which compiles them once per set of vector instructions, separately.
add_library(libration-vectors OBJECT ${vector_sources})
set_target_properties(libration-vectors PROPERTIES
    POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden)
set_source_files_properties(
    ${PROJECT_SOURCE_DIR}/src/libration/expansion/lane_vectors.cpp
    ${PROJECT_SOURCE_DIR}/src/libration/expansion/batch_vectors.cpp
    PROPERTIES COMPILE_OPTIONS -ffp-contract=off)
target_include_directories(libration-vectors PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
target_compile_features(libration-vectors PRIVATE cxx_std_20)
# Vectors of a length known only at run time would need other loops; processors with them also have NEON.
target_compile_definitions(libration-vectors PRIVATE
    "HWY_DISABLED_TARGETS=(HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128|HWY_RVV)")
target_link_libraries(libration-vectors PRIVATE PkgConfig::hwy Boost::headers libration-warnings)
target_compile_options(libration-vectors PRIVATE ${switches_name_all})
target_sources(libration PRIVATE $<TARGET_OBJECTS:libration-vectors>)

include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/libration)
configure_package_config_file(cmake/libration-config.cmake.in
    ${PROJECT_BINARY_DIR}/libration-config.cmake
    INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/libration-config-version.cmake
    COMPATIBILITY SameMinorVersion)

# Component "headers": for C++ projects. Component "command": the program and its figure scripts. The library is exported
# in a separate file, which is included only if FLINT is found.
install(TARGETS libration-headers EXPORT libration-headers-targets)
install(TARGETS libration
    EXPORT libration-targets
    ARCHIVE COMPONENT headers
    FILE_SET headers COMPONENT headers)
foreach(set IN ITEMS libration-headers-targets libration-targets)
    install(EXPORT ${set} NAMESPACE libration:: DESTINATION ${package_dir} COMPONENT headers)
endforeach()
# For one release: the headers at their places in version 1.0 include those of today (moved_headers.txt: old new).
file(STRINGS cmake/moved_headers.txt moved_headers REGEX "^[a-z]")
foreach(line IN LISTS moved_headers)
    string(REGEX MATCH "^([^ ]+) ([^ ]+)$" line "${line}")
    set(forwarding ${PROJECT_BINARY_DIR}/moved_headers/libration/${CMAKE_MATCH_1})
    file(CONFIGURE OUTPUT ${forwarding}
        CONTENT "#pragma once\n#include \"libration/${CMAKE_MATCH_2}\"  // moved\n" @ONLY)
endforeach()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS cmake/moved_headers.txt)
install(DIRECTORY ${PROJECT_BINARY_DIR}/moved_headers/libration DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT headers)
install(FILES
    cmake/FindFLINT.cmake
    ${PROJECT_BINARY_DIR}/libration-config.cmake
    ${PROJECT_BINARY_DIR}/libration-config-version.cmake
    DESTINATION ${package_dir}
    COMPONENT headers)
