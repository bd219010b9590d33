# cmake -D PREFIX= -D PROJECT= -D BUILD= -D COMPILER= -D GENERATOR= [-D README= | -D PROGRAM= -D TARGET=]
#     [-D WITHOUT_FLINT=ON] [-D FLAGS=] -P check_consumer.cmake
# Configures, builds and runs the project that finds libration in PREFIX, if requested as on a machine without FLINT.
# With README its program is the file's first ```cpp block, and its output must be exactly the ```text block that
# follows.

set(arguments "")
if(README)
    file(READ ${README} text)
    string(FIND "${text}" "\n```cpp\n" begin)
    if(begin EQUAL -1)
        message(FATAL_ERROR "${README} has no \`\`\`cpp block")
    endif()
    math(EXPR begin "${begin} + 8")
    string(SUBSTRING "${text}" ${begin} -1 text)
    string(FIND "${text}" "\n```\n" end)
    math(EXPR end "${end} + 1") # the block includes its last newline
    string(SUBSTRING "${text}" 0 ${end} program)
    file(WRITE ${BUILD}/readme.cpp "${program}")
    list(APPEND arguments -D PROGRAM=${BUILD}/readme.cpp)

    math(EXPR end "${end} + 4")
    string(SUBSTRING "${text}" ${end} -1 text)
    string(FIND "${text}" "```" begin)
    string(FIND "${text}" "```text\n" begin_text)
    if(begin_text EQUAL -1 OR NOT begin EQUAL begin_text)
        message(FATAL_ERROR "${README}: the \`\`\`cpp block is not followed by a \`\`\`text block with its output")
    endif()
    math(EXPR begin "${begin} + 8")
    string(SUBSTRING "${text}" ${begin} -1 text)
    string(FIND "${text}" "```" end)
    string(SUBSTRING "${text}" 0 ${end} expected)
endif()

foreach(name IN ITEMS PROGRAM TARGET)
    if(DEFINED ${name})
        list(APPEND arguments -D ${name}=${${name}})
    endif()
endforeach()
if(WITHOUT_FLINT)
    list(APPEND arguments -D CMAKE_DISABLE_FIND_PACKAGE_FLINT=ON)
endif()
if(FLAGS)
    list(APPEND arguments -D CMAKE_CXX_FLAGS=${FLAGS})
endif()
execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${PROJECT} -B ${BUILD}/build --fresh -G ${GENERATOR}
        -D CMAKE_CXX_COMPILER=${COMPILER}
        -D CMAKE_PREFIX_PATH=${PREFIX}
        ${arguments}
    OUTPUT_QUIET
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD}/build --clean-first COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${BUILD}/build/consumer OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)

if(README AND NOT printed STREQUAL expected)
    message(FATAL_ERROR "${README}: the program should print\n${expected}but it prints\n${printed}")
endif()
message("${printed}")
