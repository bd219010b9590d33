# The benchmark programs, one executable; ours and its peers stand side by side in its table.

find_package(benchmark REQUIRED)

file(GLOB bench_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/*.cpp)
if(bench_sources)
    add_executable(libration-bench ${bench_sources})
    target_link_libraries(libration-bench PRIVATE libration::libration benchmark::benchmark_main libration-warnings)
endif()
