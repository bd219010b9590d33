# The benchmarks, one program a question; ours and its peers stand side by side in its table. None is part of `all`.

find_package(benchmark REQUIRED)
find_package(fmt REQUIRED)

file(GLOB bench_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/*.cpp)
foreach(source IN LISTS bench_sources)
    cmake_path(GET source STEM name)
    add_executable(libration-bench-${name} EXCLUDE_FROM_ALL ${source})
    target_link_libraries(libration-bench-${name}
        PRIVATE libration::ball benchmark::benchmark fmt::fmt libration-warnings)
endforeach()
