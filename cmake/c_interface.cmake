# The C interface, include/libration.h: a shared library with the contents of the static ones that exports only the
# symbols of that header. Its version is that of the interface, which is only extended, not that of the project.

file(GLOB c_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/interface/c/*.cpp)
add_library(libration-c SHARED ${c_sources})
set_target_properties(libration-c PROPERTIES
    OUTPUT_NAME libration
    SOVERSION 1
    VERSION 1.0
    CXX_VISIBILITY_PRESET hidden)
target_compile_definitions(libration-c PRIVATE LIBRATION_VERSION="${PROJECT_VERSION}")
target_include_directories(libration-c
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(libration-c PRIVATE libration libration-warnings)
target_link_options(libration-c PRIVATE
    LINKER:--version-script=${PROJECT_SOURCE_DIR}/src/interface/c/symbols.map
    LINKER:--no-undefined
    LINKER:-z,nodelete)  # threads wait in it (proof_thread.cpp), and end in it (thread_ends.cpp)
set_property(TARGET libration-c APPEND PROPERTY LINK_DEPENDS ${PROJECT_SOURCE_DIR}/src/interface/c/symbols.map)

# The exported symbols, for the test that compares them with the header.
set(c_symbols ${PROJECT_BINARY_DIR}/libration.symbols)
add_custom_command(TARGET libration-c POST_BUILD
    COMMAND ${CMAKE_NM} -D --defined-only $<TARGET_FILE:libration-c> > ${c_symbols}
    BYPRODUCTS ${c_symbols}
    VERBATIM)

# The same for Fortran.
set(fortran_module ${PROJECT_BINARY_DIR}/libration.f90)
add_custom_command(OUTPUT ${fortran_module}
    COMMAND ${CMAKE_COMMAND} -D HEADER=${PROJECT_SOURCE_DIR}/include/libration.h -D MODULE=${fortran_module}
        -P ${PROJECT_SOURCE_DIR}/cmake/fortran_module.cmake
    DEPENDS include/libration.h cmake/fortran_module.cmake cmake/libration.f90.in
    VERBATIM)
add_custom_target(libration-fortran DEPENDS ${fortran_module})
add_dependencies(libration-c libration-fortran)

file(RELATIVE_PATH prefix_from_pkgconfig /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(cmake/libration.pc.in ${PROJECT_BINARY_DIR}/libration.pc @ONLY)
# For C++: the static library, by its path, since the shared one of the same name exports the C interface only.
set(flint_libraries -lflint)
if(NOT FLINT_ARB_LIBRARY STREQUAL FLINT_LIBRARY)
    cmake_path(GET FLINT_ARB_LIBRARY STEM arb_name)
    string(REGEX REPLACE "^lib" "-l" flint_libraries "${arb_name} -lflint")
endif()
set(quadmath_library "")
if(LIBRATION_HAS_QUADMATH)
    set(quadmath_library " -lquadmath")
endif()
set(more_include_flags "")
foreach(folder IN ITEMS ${Boost_INCLUDE_DIRS} ${FLINT_ARB_INCLUDE_DIR})
    if(NOT folder STREQUAL "/usr/include")
        string(APPEND more_include_flags " -isystem ${folder}")
    endif()
endforeach()
configure_file(cmake/libration-c++.pc.in "${PROJECT_BINARY_DIR}/libration-c++.pc" @ONLY)
install(TARGETS libration-c
    LIBRARY COMPONENT c_interface NAMELINK_COMPONENT headers)
install(FILES include/libration.h ${fortran_module} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT headers)
install(FILES ${PROJECT_BINARY_DIR}/libration.pc "${PROJECT_BINARY_DIR}/libration-c++.pc"
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT headers)
