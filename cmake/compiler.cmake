# Compiler options of Libration's targets. Nothing in this file affects a project that uses the library.

# Link libration-warnings PRIVATE to every target of the project. `cmake --compile-no-warning-as-error` turns the errors
# off for a packager whose compiler is newer than this list.
add_library(libration-warnings INTERFACE)
target_compile_options(libration-warnings INTERFACE
    $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra;-Wpedantic;-Wconversion;-Wshadow>)
# The flow analysis of GCC 12 and later takes an empty std::optional of a quad for an uninitialized number.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12)
    target_compile_options(libration-warnings INTERFACE -Wno-error=maybe-uninitialized)
endif()
if(PROJECT_IS_TOP_LEVEL)
    set(CMAKE_COMPILE_WARNING_AS_ERROR ON)
endif()

if(LIBRATION_SANITIZE)
    set(sanitizer_options -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_compile_options(${sanitizer_options})
    add_link_options(-fsanitize=address,undefined)
    # Instrumented code causes false positives in GCC's flow analysis; the plain builds keep this warning an error.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(libration-warnings INTERFACE -Wno-maybe-uninitialized)
    endif()
endif()

# Six sevenths of the code of individually compiled sources are the same template instances as in other sources. The
# presets for clean builds set CMAKE_UNITY_BUILD, which compiles many sources as one; `dev` does not, so that a change
# there compiles one source. Sources may therefore share only the names in headers: each test has a separate namespace,
# as has the inside of each study. Large batches have few copies of an instance and need 2 to 3 GB of memory: as many are
# compiled at once as fit into that of the machine.
if(NOT CMAKE_UNITY_BUILD_BATCH_SIZE)
    set(CMAKE_UNITY_BUILD_BATCH_SIZE 25)
endif()
cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY) # in MiB
math(EXPR jobs "${memory} / 2560")
if(jobs LESS 1)
    set(jobs 1)
endif()
set_property(GLOBAL APPEND PROPERTY JOB_POOLS libration_batches=${jobs})

# Compiles COUNT sources of the target as one, instead of 25; with sanitizers, which double the memory, half of them.
function(set_batch target count)
    if(LIBRATION_SANITIZE)
        math(EXPR count "${count} / 2")
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE ${count})
    if(CMAKE_UNITY_BUILD)
        set_target_properties(${target} PROPERTIES JOB_POOL_COMPILE libration_batches)
    endif()
endfunction()

# GCC collects garbage when its heap has doubled, from 128 MB on. Later collections save about a twentieth of the compile
# time of a batch and need about a fifth more memory.
if(PROJECT_IS_TOP_LEVEL AND CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(--param=ggc-min-heapsize=524288 --param=ggc-min-expand=200)
endif()

# Compiling Boost.Multiprecision dominates the build time. ccache caches sources with a precompiled header only if it
# may ignore that header's time stamps and macros.
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    find_program(LIBRATION_CCACHE ccache)
    mark_as_advanced(LIBRATION_CCACHE)
    if(LIBRATION_CCACHE)
        set(CMAKE_CXX_COMPILER_LAUNCHER
            ${CMAKE_COMMAND} -E env
            CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
            ${LIBRATION_CCACHE})
        if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
            add_compile_options(-fpch-preprocess)
        endif()
    endif()
endif()
