# The target libration-static: the command with all libraries except glibc inside, for machines on which nothing can be
# installed. It has the objects of libration-command; only its libraries differ. LIBRATION_ARCHIVES has those that Debian
# distributes only as shared libraries, made by static_libraries.sh.

foreach(name IN ITEMS flint-arb flint fmt hwy)
    list(APPEND static_archives ${LIBRATION_ARCHIVES}/lib${name}.a)
endforeach()
foreach(name IN ITEMS mpfr gmp sqlite3 crypto z quadmath)
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=lib${name}.a
        OUTPUT_VARIABLE archive OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    list(APPEND static_archives ${archive})
endforeach()
foreach(archive IN LISTS static_archives)
    if(NOT EXISTS ${archive})
        message(FATAL_ERROR "${archive} does not exist: libration-static is built by ./run static")
    endif()
endforeach()

add_executable(libration-static EXCLUDE_FROM_ALL
    ${PROJECT_SOURCE_DIR}/src/command/main.cpp
    $<TARGET_OBJECTS:libration-program> $<TARGET_OBJECTS:libration-studies> $<TARGET_OBJECTS:libration-claims>)
set_target_properties(libration-static PROPERTIES
    OUTPUT_NAME libration
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/static)
target_include_directories(libration-static PRIVATE ${PROJECT_SOURCE_DIR}/src/command)
# The files of the project's libraries, because their targets link the shared libraries.
set(own_archives $<TARGET_FILE:libration-sweep> $<TARGET_FILE:libration>)
add_dependencies(libration-static libration-sweep libration)
target_link_options(libration-static PRIVATE
    -static-libstdc++ -static-libgcc -s
    LINKER:--whole-archive $<TARGET_FILE:libration> LINKER:--no-whole-archive)
target_link_libraries(libration-static PRIVATE
    libration-warnings -Wl,--start-group ${own_archives} ${static_archives} -Wl,--end-group Threads::Threads m)
set_property(TARGET libration-static APPEND PROPERTY LINK_DEPENDS ${own_archives} ${static_archives})
