# How our own targets are compiled. Nothing in here reaches a project that uses the library.

# Link libration-warnings PRIVATE to every target of ours. `cmake --compile-no-warning-as-error` turns the errors off
# for a packager whose compiler is newer than this list.
add_library(libration-warnings INTERFACE)
target_compile_options(libration-warnings INTERFACE
    $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra;-Wpedantic;-Wconversion;-Wshadow>)
# From GCC 12 on its flow analysis takes an empty std::optional of a quad for an uninitialized number.
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
    # Instrumented code makes GCC's flow analysis guess wrong; the plain builds keep this warning an error.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(libration-warnings INTERFACE -Wno-maybe-uninitialized)
    endif()
endif()

# Six sevenths of the code that sources compile by themselves are the same template instances as in other sources. The
# presets that build from nothing set CMAKE_UNITY_BUILD, which compiles so many sources as one; `dev` does not, so that
# a change there compiles one source. Sources may therefore share no name but those of headers: each test has a
# namespace of its own, each study one for what is inside it.
if(NOT CMAKE_UNITY_BUILD_BATCH_SIZE)
    set(CMAKE_UNITY_BUILD_BATCH_SIZE 25)
endif()

# Compiling Boost.Multiprecision is the cost of a build. ccache caches sources with a precompiled header only when it
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
