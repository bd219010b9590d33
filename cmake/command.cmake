# The command `libration`, in the order of the modules: those on which studies depend first, the subcommands last.

find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(Threads REQUIRED)
find_package(SQLite3 REQUIRED)
if(NOT TARGET SQLite3::SQLite3) # before CMake 4.3
    add_library(SQLite3::SQLite3 ALIAS SQLite::SQLite3)
endif()
include(cmake/peers.cmake)

set(generated_dir ${PROJECT_BINARY_DIR}/generated)

# version.hpp is generated in every build, because a commit changes no source; it is rewritten only if it changes.
add_custom_target(libration-version
    COMMAND ${CMAKE_COMMAND}
        -D SOURCE_DIR=${PROJECT_SOURCE_DIR}
        -D OUTPUT=${generated_dir}/version.hpp
        -D VERSION=${PROJECT_VERSION}
        -D "COMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
        -P ${PROJECT_SOURCE_DIR}/cmake/version.cmake
    BYPRODUCTS ${generated_dir}/version.hpp
    COMMENT "Reading the commit"
    VERBATIM)

# The registry: the files of studies/ define const study& NAME(), one for each study, and nothing else lists studies.
file(GLOB_RECURSE study_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/studies/*.cpp)
set(study_declarations "")
set(study_entries "")
set(study_names "")
foreach(source IN LISTS study_sources)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    file(STRINGS ${source} definitions REGEX "^const study& [a-z0-9_]+[(][)] {")
    list(TRANSFORM definitions REPLACE "^const study& ([a-z0-9_]+).*$" "\\1")
    list(APPEND study_names ${definitions})
endforeach()
list(SORT study_names)
foreach(name IN LISTS study_names)
    string(APPEND study_declarations "const study& ${name}();\n")
    list(APPEND study_entries "&studies::${name}()")
endforeach()
list(JOIN study_entries ", " study_entries)
# The data that studies compare with, embedded by name.
file(GLOB_RECURSE data_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/studies/*.csv)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${data_files})
set(data_entries "")
foreach(file IN LISTS data_files)
    cmake_path(GET file STEM name)
    file(READ ${file} text)
    string(APPEND data_entries "        {\"${name}\", R\"csv(${text})csv\"},\n")
endforeach()
configure_file(cmake/registry.cpp.in ${generated_dir}/registry.cpp @ONLY)

set(study_rooms text run option problem sweep)
set(command_rooms plot table verify verb)
list(TRANSFORM study_rooms REPLACE ".+" "${PROJECT_SOURCE_DIR}/src/command/\\0/*.cpp")
list(TRANSFORM command_rooms REPLACE ".+" "${PROJECT_SOURCE_DIR}/src/command/\\0/*.cpp")
file(GLOB sweep_sources CONFIGURE_DEPENDS ${study_rooms})
set(rank_sources ${PROJECT_SOURCE_DIR}/src/command/mpi.cpp ${PROJECT_SOURCE_DIR}/src/command/sweep/ranks.cpp)
list(REMOVE_ITEM sweep_sources ${rank_sources})
file(GLOB claim_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/paper/claims/*.cpp)
file(GLOB command_sources CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/src/command/*.cpp ${PROJECT_SOURCE_DIR}/paper/report/*.cpp ${command_rooms})

# Separate libraries, so that tests can run a study or a sweep without starting the program. A clean build compiles
# several sources as one, the preset `dev` each by itself: both must compile, so no name may depend on other sources of
# a batch. Half of the compile time of -O2: the time-consuming code is in the library, which is compiled with -O2.
add_library(libration-sweep STATIC ${sweep_sources})
add_library(libration-studies OBJECT ${study_sources} ${generated_dir}/registry.cpp)
add_library(libration-claims OBJECT ${claim_sources})
set(cold_code $<$<CONFIG:Release>:-Og>)
set_batch(libration-sweep 60)
set_batch(libration-studies 40)
foreach(target IN ITEMS libration-sweep libration-studies libration-claims)
    target_compile_options(${target} PRIVATE ${cold_code})
endforeach()
add_dependencies(libration-sweep libration-version)
target_include_directories(libration-sweep PUBLIC
    ${PROJECT_SOURCE_DIR}/src/command ${PROJECT_SOURCE_DIR} ${generated_dir})
target_link_libraries(libration-sweep
    PUBLIC libration::libration CLI11::CLI11 fmt::fmt nlohmann_json::nlohmann_json Threads::Threads
    PRIVATE OpenSSL::Crypto SQLite3::SQLite3 libration-warnings)
target_link_libraries(libration-studies PUBLIC libration-sweep PRIVATE libration-warnings)
target_link_libraries(libration-claims PUBLIC libration-sweep PRIVATE libration-warnings)
target_precompile_headers(libration-sweep PRIVATE ${PROJECT_SOURCE_DIR}/src/command/precompiled.hpp <CLI/CLI.hpp>)
target_precompile_headers(libration-studies REUSE_FROM libration-sweep)
target_precompile_headers(libration-claims REUSE_FROM libration-sweep)

# The location of the figure scripts: in the source tree, and relative to the directory of an installed program.
set(installed_studies_dir ${CMAKE_INSTALL_DATADIR}/libration/studies)
file(RELATIVE_PATH studies_from_program /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${installed_studies_dir})
target_compile_definitions(libration-sweep PUBLIC
    LIBRATION_STUDIES_DIR="${PROJECT_SOURCE_DIR}/studies"
    LIBRATION_INSTALLED_STUDIES_DIR="${studies_from_program}")
# Programs started by libration are in the same directory in the build tree, and in libexec after installation.
set(installed_peers_dir ${CMAKE_INSTALL_LIBEXECDIR}/libration)
file(RELATIVE_PATH peers_from_program /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${installed_peers_dir})
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/command/run/program_files.cpp PROPERTIES
    COMPILE_DEFINITIONS "LIBRATION_BUILD_DIR=\"${PROJECT_BINARY_DIR}\";LIBRATION_INSTALLED_PEERS_DIR=\"${peers_from_program}\""
    SKIP_UNITY_BUILD_INCLUSION ON)

list(REMOVE_ITEM command_sources ${PROJECT_SOURCE_DIR}/src/command/main.cpp ${rank_sources})
add_library(libration-program OBJECT ${command_sources})
set_batch(libration-program 48)
target_compile_options(libration-program PRIVATE ${cold_code})
target_link_libraries(libration-program PUBLIC libration-sweep PRIVATE libration-warnings)
target_precompile_headers(libration-program REUSE_FROM libration-sweep)

add_executable(libration-command ${PROJECT_SOURCE_DIR}/src/command/main.cpp)
set_target_properties(libration-command PROPERTIES OUTPUT_NAME libration)
target_link_libraries(libration-command
    PRIVATE libration-program libration-studies libration-claims libration-sweep libration-warnings)
# GMP and MPFR are linked statically, if their archives are installed: calls between the two, and to the thread-local
# data of MPFR, then bypass the dynamic linker, which took a tenth of the time of a study. The whole archives, so that
# FLINT, which is shared, finds the same copy: the linker exports the symbols that a given shared library needs, and the
# dynamic linker prefers those of the program to those of libmpfr.so, which FLINT loads too and nobody calls. Only one
# MPFR is used, with one range of exponents and one set of constants per thread (tests/command/product_bound_test.cpp).
# The libraries link the shared ones, and so do their tests.
if(LIBRATION_STATIC_ARITHMETIC)
    find_library(LIBRATION_MPFR_ARCHIVE NAMES libmpfr.a HINTS ${mpfr_LIBRARY_DIRS} ${mpfr_LIBDIR})
    find_library(LIBRATION_GMP_ARCHIVE NAMES libgmp.a HINTS ${gmp_LIBRARY_DIRS} ${gmp_LIBDIR})
    if(LIBRATION_MPFR_ARCHIVE AND LIBRATION_GMP_ARCHIVE)
        set(arithmetic_archives ${LIBRATION_MPFR_ARCHIVE} ${LIBRATION_GMP_ARCHIVE})
    endif()
endif()

# The library before all others: of code that it and non-critical sources both instantiate, a linker keeps the first
# copy.
set(library_first
    LINKER:--whole-archive $<TARGET_FILE:libration> ${arithmetic_archives}
    LINKER:--no-whole-archive)
target_link_options(libration-command PRIVATE ${library_first})
add_dependencies(libration-command ${solver_peers})
if(TARGET libration-gsl-theta)
    add_dependencies(libration-command libration-gsl-theta)
endif()
if(TARGET libration-import)
    add_dependencies(libration-command libration-import)
endif()

# The same program with its libraries inside: ./run static, which sets the directory of some of them.
set(LIBRATION_ARCHIVES "" CACHE PATH "Directory of libflint.a, libflint-arb.a, libfmt.a and libhwy.a, for libration-static")
if(LIBRATION_ARCHIVES)
    include(cmake/static_command.cmake)
endif()

# The same program on many machines: ./run --mpi. Its packages are installed only for that command.
if(LIBRATION_BUILD_MPI)
    enable_language(C)  # for MPI's plain C interface
    find_package(MPI REQUIRED COMPONENTS C)
    add_executable(libration-mpi EXCLUDE_FROM_ALL ${rank_sources})
    target_compile_definitions(libration-mpi PRIVATE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
    target_link_libraries(libration-mpi
        PRIVATE libration-program libration-studies libration-claims libration-sweep libration-warnings MPI::MPI_C)
    target_link_options(libration-mpi PRIVATE ${library_first})
endif()

# The checker of certificates in C, which shares no code with the library, for --check; those who check a certificate of
# others take it from the source.
enable_language(C)
file(GLOB checker_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/check/c/*.c)
add_executable(libration-check ${checker_sources})
set_target_properties(libration-check PROPERTIES C_STANDARD 11 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF UNITY_BUILD OFF)
target_compile_options(libration-check PRIVATE -Wno-sign-conversion)
target_link_libraries(libration-check PRIVATE PkgConfig::gmp ZLIB::ZLIB libration-warnings)
add_dependencies(libration-command libration-check)

install(TARGETS libration-command RUNTIME COMPONENT command)
install(DIRECTORY studies/
    DESTINATION ${installed_studies_dir}
    COMPONENT command
    FILES_MATCHING PATTERN "*.gp" PATTERN "*.md.in")
# The published tables, with which `reproduce` compares its own.
install(DIRECTORY results/
    DESTINATION ${CMAKE_INSTALL_DATADIR}/libration/results
    COMPONENT command
    FILES_MATCHING PATTERN "*.csv")
install(FILES src/command/completion.bash
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    RENAME libration
    COMPONENT manual)
if(TARGET libration-gsl-theta)
    install(TARGETS libration-gsl-theta RUNTIME DESTINATION ${installed_peers_dir} COMPONENT peers)
endif()
if(TARGET libration-import)
    install(TARGETS libration-import RUNTIME DESTINATION ${installed_peers_dir} COMPONENT peers)
endif()
install(TARGETS libration-check RUNTIME DESTINATION ${installed_peers_dir} COMPONENT peers)
install(TARGETS ${solver_peers} RUNTIME DESTINATION ${installed_peers_dir} COMPONENT peers)
install(PROGRAMS peers/scipy_solvers.py peers/mpmath_solvers.py DESTINATION ${installed_peers_dir} COMPONENT peers)
install(FILES peers/equation_code.py DESTINATION ${installed_peers_dir} COMPONENT peers)
# The documentation, including the readers of tables.
install(FILES README.md CHANGELOG.md REFERENCES.md CITATION.cff LICENSE
    DESTINATION ${CMAKE_INSTALL_DOCDIR}
    COMPONENT documents)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents PATTERN site EXCLUDE)

# Everything that `cmake --install` installs: `./run install` builds this target.
add_custom_target(libration-installable DEPENDS libration libration-c libration-command)
if(LIBRATION_BUILD_MANUAL)
    include(cmake/manual.cmake)
endif()
