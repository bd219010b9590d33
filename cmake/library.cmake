# The library, here and for find_package(libration) after `cmake --install`:
#   libration::headers    the templates alone, linking only MPFR and GMP
#   libration::libration  with the non-template parts, compiled once; no FLINT, also at link time
#   libration::proved     with proved arithmetic, if FLINT is available (alias: libration::ball)
# Sources are in src/libration/MODULE, their headers in include/libration/MODULE.

find_package(Boost 1.81 REQUIRED CONFIG)
find_package(PkgConfig REQUIRED)
pkg_check_modules(mpfr REQUIRED IMPORTED_TARGET mpfr)
pkg_check_modules(gmp REQUIRED IMPORTED_TARGET gmp)
pkg_check_modules(hwy REQUIRED IMPORTED_TARGET libhwy)

add_library(libration-headers INTERFACE)
add_library(libration::headers ALIAS libration-headers)
set_target_properties(libration-headers PROPERTIES EXPORT_NAME headers)
target_compile_features(libration-headers INTERFACE cxx_std_20)
file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/libration/*.hpp)
set(proved_headers ${headers})
list(FILTER proved_headers INCLUDE REGEX "/(ball|proved|rigorous)/|/proved\\.hpp$")
list(FILTER headers EXCLUDE REGEX "/(ball|proved|rigorous)/|/proved\\.hpp$")
# Each header of a set compiles alone, as checked by the target all_verify_interface_header_sets of the preset `lint`.
target_sources(libration-headers INTERFACE
    FILE_SET headers TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/include FILES ${headers})
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
set(proved_sources ${library_sources})
# The known facts about problems and their solutions need FLINT behind a header that does not.
set(proved_folders "/(ball|proved|rigorous|stiff)/|/problem/(known|solution)/")
list(FILTER proved_sources INCLUDE REGEX "${proved_folders}")
list(FILTER library_sources EXCLUDE REGEX "${proved_folders}")
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
configure_file(cmake/catalogue.cpp.in ${PROJECT_BINARY_DIR}/generated/catalogue.cpp @ONLY)

add_library(libration STATIC ${library_sources} ${PROJECT_BINARY_DIR}/generated/catalogue.cpp)
add_library(libration::libration ALIAS libration)
# The templates that it compiles once (scalar/compiled.hpp) are declared extern to its users.
target_compile_definitions(libration PUBLIC LIBRATION_COMPILED)
# Both static libraries are also linked into a shared one (c_interface.cmake): hidden symbols keep calls as direct as in
# a program.
set_batch(libration 20)
set_target_properties(libration PROPERTIES
    POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden)
target_precompile_headers(libration PRIVATE ${PROJECT_SOURCE_DIR}/src/libration/precompiled.hpp)
target_link_libraries(libration
    PUBLIC libration-headers
    PRIVATE $<LINK_ONLY:PkgConfig::hwy> $<BUILD_INTERFACE:libration-warnings>)
# A new kind of node, function or operation causes a compile error until each switch handles it.
set(switches_name_all $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wswitch-enum>)
target_compile_options(libration PRIVATE ${switches_name_all})

# The sources that use Highway, which compiles them once per set of vector instructions, separately.
add_library(libration-vectors OBJECT ${vector_sources})
set_target_properties(libration-vectors PROPERTIES
    POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden)
set_source_files_properties(
    ${PROJECT_SOURCE_DIR}/src/libration/ode/lane_vectors.cpp
    ${PROJECT_SOURCE_DIR}/src/libration/ode/batch/batch_vectors.cpp
    PROPERTIES COMPILE_OPTIONS -ffp-contract=off)
target_include_directories(libration-vectors PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
target_compile_features(libration-vectors PRIVATE cxx_std_20)
# Vectors of a length known only at run time would need other loops; processors with them also have NEON.
target_compile_definitions(libration-vectors PRIVATE
    "HWY_DISABLED_TARGETS=(HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128|HWY_RVV)")
target_link_libraries(libration-vectors PRIVATE PkgConfig::hwy libration-warnings)
target_compile_options(libration-vectors PRIVATE ${switches_name_all})
target_sources(libration PRIVATE $<TARGET_OBJECTS:libration-vectors>)

# Proved arithmetic is a separate target, if FLINT is available: a program that uses only mpfr does not need FLINT.
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_package(FLINT 2.9 QUIET)
if(FLINT_FOUND)
    include(cmake/flint_self_test.cmake)
    find_package(Eigen3 3.3 REQUIRED NO_MODULE)
    find_package(ZLIB REQUIRED)
    add_library(libration-proved STATIC ${proved_sources})
    add_library(libration::proved ALIAS libration-proved)
    add_library(libration::ball ALIAS libration-proved)
    set_batch(libration-proved 44)
    set_target_properties(libration-proved PROPERTIES
        EXPORT_NAME proved
        POSITION_INDEPENDENT_CODE ON
        CXX_VISIBILITY_PRESET hidden)
    target_link_libraries(libration-proved
        PUBLIC libration FLINT::FLINT
        PRIVATE ZLIB::ZLIB $<BUILD_INTERFACE:Eigen3::Eigen> $<BUILD_INTERFACE:libration-warnings>)
    target_compile_options(libration-proved PRIVATE ${switches_name_all})
    target_precompile_headers(libration-proved REUSE_FROM libration)
    target_sources(libration-proved PUBLIC
        FILE_SET headers TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/include FILES ${proved_headers})
endif()

include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/libration)
configure_package_config_file(cmake/libration-config.cmake.in
    ${PROJECT_BINARY_DIR}/libration-config.cmake
    INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/libration-config-version.cmake
    COMPATIBILITY SameMinorVersion)

# Component "headers": for C++ projects. Component "command": the program and its figure scripts.
install(TARGETS libration-headers libration
    EXPORT libration-targets
    ARCHIVE COMPONENT headers
    FILE_SET headers COMPONENT headers)
install(EXPORT libration-targets NAMESPACE libration:: DESTINATION ${package_dir} COMPONENT headers)
if(TARGET libration-proved)
    # In a separate file, which is included only if FLINT is found.
    install(TARGETS libration-proved
        EXPORT libration-proved-targets
        ARCHIVE COMPONENT headers
        FILE_SET headers COMPONENT headers)
    install(EXPORT libration-proved-targets NAMESPACE libration:: DESTINATION ${package_dir} COMPONENT headers)
endif()
install(FILES
    cmake/FindFLINT.cmake
    ${PROJECT_BINARY_DIR}/libration-config.cmake
    ${PROJECT_BINARY_DIR}/libration-config-version.cmake
    DESTINATION ${package_dir}
    COMPONENT headers)
