# The benchmarks, one program per question, with Libration and its peers in one table. None is part of `all`.

find_package(benchmark REQUIRED)
find_package(fmt REQUIRED)

file(GLOB bench_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/*.cpp)
foreach(source IN LISTS bench_sources)
    cmake_path(GET source STEM name)
    add_executable(libration-bench-${name} EXCLUDE_FROM_ALL ${source})
    target_link_libraries(libration-bench-${name}
        PRIVATE libration::ball benchmark::benchmark fmt::fmt libration-warnings)
endforeach()

# Starts a separate peer program; its Boost.Math in float128 requires the literals of GNU C++.
set_target_properties(libration-bench-trajectory PROPERTIES CXX_EXTENSIONS ON)
target_sources(libration-bench-trajectory PRIVATE ${PROJECT_SOURCE_DIR}/src/command/run/child_program.cpp)
target_include_directories(libration-bench-trajectory PRIVATE ${PROJECT_SOURCE_DIR}/src/command)
if(TARGET libration-gsl-trajectory)
    add_dependencies(libration-bench-trajectory libration-gsl-trajectory)
    target_compile_definitions(libration-bench-trajectory PRIVATE
        LIBRATION_GSL_TRAJECTORY="$<TARGET_FILE:libration-gsl-trajectory>")
endif()

# Their peers solve differential equations, those of GSL and mpmath in separate programs.
foreach(name IN ITEMS equations batch)
    target_sources(libration-bench-${name} PRIVATE ${PROJECT_SOURCE_DIR}/src/command/run/child_program.cpp)
    target_include_directories(libration-bench-${name} PRIVATE ${PROJECT_SOURCE_DIR}/src/command)
    if(TARGET libration-gsl-equations)
        add_dependencies(libration-bench-${name} libration-gsl-equations)
        target_compile_definitions(libration-bench-${name} PRIVATE
            LIBRATION_GSL_EQUATIONS="$<TARGET_FILE:libration-gsl-equations>")
    endif()
endforeach()
target_compile_definitions(libration-bench-equations PRIVATE
    LIBRATION_MPMATH_EQUATIONS="${PROJECT_SOURCE_DIR}/peers/mpmath_equations.py")

# Runs the engine of the studies.
target_link_libraries(libration-bench-journal PRIVATE libration-studies libration-sweep)
