# cmake -D LIBRATION= -D READER= -D WORK= -P check_reader.cmake
# The Python reader of the docs returns all digits of a table, more than double precision.

# Debian's interpreter first, because the package python3-mpmath belongs to it.
find_program(PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(PYTHON python3 REQUIRED)
set(table ${WORK}/read_table.csv)
execute_process(
    COMMAND ${LIBRATION} study error_norm --energies 1.71 --orders 6 --scalar mpfr:50
    OUTPUT_FILE ${table}
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(
    COMMAND ${PYTHON} ${READER} ${table} 60
    OUTPUT_VARIABLE printed
    COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ${table} lines)
list(GET lines 0 names)
list(GET lines 1 cells)
string(REPLACE "," ";" names "${names}")
string(REPLACE "," ";" cells "${cells}")
foreach(name IN ITEMS norm time_of_maximum)
    list(FIND names ${name} place)
    list(GET cells ${place} cell)
    if(NOT printed MATCHES "\n${name} ${cell}\n")
        message(FATAL_ERROR "the reader did not print ${name} = ${cell}, but\n${printed}")
    endif()
endforeach()
message("${printed}")
