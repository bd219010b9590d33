# cmake -D PREFIX= -D EXAMPLES= -D EXPECTED= -D WORK= [-D FLAGS=] -P check_c_examples.cmake
# Compiles the examples for C and Fortran against the installed library with the flags of pkg-config, runs them, and
# compares their output with independent values. Fortran is skipped with a message if gfortran is not installed.

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
file(GLOB_RECURSE description ${PREFIX}/libration.pc)
if(NOT description)
    message(FATAL_ERROR "no libration.pc is installed in ${PREFIX}")
endif()
cmake_path(GET description PARENT_PATH folder)
set(ENV{PKG_CONFIG_PATH} ${folder})
foreach(what IN ITEMS cflags libs)
    execute_process(COMMAND pkg-config --${what} libration
        OUTPUT_VARIABLE ${what} OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(${what})
endforeach()
separate_arguments(FLAGS)
string(REGEX REPLACE "^.*-L([^;]+).*$" "\\1" libraries "${libs}")
string(REGEX REPLACE "^.*-I([^;]+).*$" "\\1" include "${cflags}")

# Each row of the expected values: a program, the word with which a line begins, and the leading digits of a number in
# it.
function(check program)
    execute_process(COMMAND ${program} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
    cmake_path(GET program FILENAME name)
    string(REPLACE "\n" ";" lines "${printed}")
    file(STRINGS ${EXPECTED} rows REGEX "^${name},")
    foreach(row IN LISTS rows)
        string(REPLACE "," ";" row "${row}")
        list(GET row 1 word)
        list(GET row 2 value)
        set(found OFF)
        foreach(line IN LISTS lines)
            string(FIND "${line}" "${word} " at)
            string(FIND "${line}" " ${value}" behind)
            if(at EQUAL 0 AND behind GREATER 0)
                set(found ON)
            endif()
        endforeach()
        if(NOT found)
            message(FATAL_ERROR "${name} did not print ${value} after ${word}, but\n${printed}")
        endif()
    endforeach()
    message("${printed}")
endfunction()

find_program(CC NAMES gcc cc REQUIRED)
execute_process(
    COMMAND ${CC} -std=c99 -pedantic -Wall -Wextra -Werror ${FLAGS} ${cflags} ${EXAMPLES}/pendulum.c
        -o ${WORK}/in_c ${libs} -Wl,-rpath,${libraries}
    COMMAND_ERROR_IS_FATAL ANY)
check(${WORK}/in_c)

find_program(FORTRAN gfortran)
if(NOT FORTRAN)
    message("Fortran is skipped: gfortran is not installed")
    return()
endif()
execute_process(
    COMMAND ${FORTRAN} -std=f2008 -Wall -Werror ${FLAGS} -J ${WORK} ${include}/libration.f90 ${EXAMPLES}/pendulum.f90
        -o ${WORK}/in_fortran ${libs} -Wl,-rpath,${libraries}
    COMMAND_ERROR_IS_FATAL ANY)
check(${WORK}/in_fortran)
