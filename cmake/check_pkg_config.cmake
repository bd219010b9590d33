# cmake -D PREFIX= -D PAGE=docs/cpp.md -D CXX= -D WORK= [-D FLAGS=] -P check_pkg_config.cmake
# Compiles the first C++ example of a page against the installed library with the flags of pkg-config alone, runs it, and compares
# what it prints with the text below the example.

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
file(GLOB_RECURSE description "${PREFIX}/libration-c++.pc")
if(NOT description)
    message(FATAL_ERROR "no libration-c++.pc is installed in ${PREFIX}")
endif()
cmake_path(GET description PARENT_PATH folder)
set(ENV{PKG_CONFIG_PATH} ${folder})
execute_process(COMMAND pkg-config --cflags --libs libration-c++
    OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(found)
separate_arguments(FLAGS)

function(fenced_block language text variable)
    string(FIND "${text}" "```${language}\n" begin)
    string(LENGTH "```${language}\n" head)
    math(EXPR begin "${begin} + ${head}")
    string(SUBSTRING "${text}" ${begin} -1 rest)
    string(FIND "${rest}" "```" end)
    string(SUBSTRING "${rest}" 0 ${end} content)
    set(${variable} "${content}" PARENT_SCOPE)
endfunction()

file(READ ${PAGE} page)
fenced_block(cpp "${page}" example)
fenced_block(text "${page}" expected)
file(WRITE ${WORK}/example.cpp "${example}")
execute_process(COMMAND ${CXX} ${FLAGS} ${WORK}/example.cpp -o ${WORK}/example ${found} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/example OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
if(NOT printed STREQUAL expected)
    message(FATAL_ERROR "the example prints\n${printed}instead of\n${expected}")
endif()
