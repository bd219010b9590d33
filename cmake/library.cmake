# The headers: target libration::libration, here and for find_package(libration) after `cmake --install`.

find_package(Boost 1.81 REQUIRED CONFIG)
find_package(PkgConfig REQUIRED)
pkg_check_modules(mpfr REQUIRED IMPORTED_TARGET mpfr)
pkg_check_modules(gmp REQUIRED IMPORTED_TARGET gmp)

add_library(libration INTERFACE)
add_library(libration::libration ALIAS libration)
target_compile_features(libration INTERFACE cxx_std_20)
target_include_directories(libration INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(libration INTERFACE Boost::headers PkgConfig::mpfr PkgConfig::gmp)

# quad is __float128 where GCC brings libquadmath (not on every processor); the header finds out by itself through
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
    target_link_libraries(libration INTERFACE $<$<CXX_COMPILER_ID:GNU>:quadmath>)
endif()

# Proved arithmetic is a target of its own, there where FLINT is: a program that stops at mpfr needs no FLINT.
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_package(FLINT 2.9 QUIET)
if(FLINT_FOUND)
    add_library(libration-ball INTERFACE)
    add_library(libration::ball ALIAS libration-ball)
    set_target_properties(libration-ball PROPERTIES EXPORT_NAME ball)
    target_link_libraries(libration-ball INTERFACE libration FLINT::FLINT)
endif()

include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/libration)
configure_package_config_file(cmake/libration-config.cmake.in
    ${PROJECT_BINARY_DIR}/libration-config.cmake
    INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/libration-config-version.cmake
    COMPATIBILITY SameMinorVersion
    ARCH_INDEPENDENT)

# Component "headers": what a C++ project needs. Component "command": the program and its figure scripts.
install(TARGETS libration EXPORT libration-targets)
install(EXPORT libration-targets NAMESPACE libration:: DESTINATION ${package_dir} COMPONENT headers)
install(DIRECTORY include/libration
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    COMPONENT headers
    FILES_MATCHING PATTERN "*.hpp")
if(TARGET libration-ball)
    # In a file of its own, which is read only where FLINT is found.
    install(TARGETS libration-ball EXPORT libration-ball-targets)
    install(EXPORT libration-ball-targets NAMESPACE libration:: DESTINATION ${package_dir} COMPONENT headers)
endif()
install(FILES
    cmake/FindFLINT.cmake
    ${PROJECT_BINARY_DIR}/libration-config.cmake
    ${PROJECT_BINARY_DIR}/libration-config-version.cmake
    DESTINATION ${package_dir}
    COMPONENT headers)
