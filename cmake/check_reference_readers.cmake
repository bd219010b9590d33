# cmake -D LIBRATION= -D READERS= -D WORK= -P check_reference_readers.cmake
# The readers of reference values return the values in the files: Python and C all digits, Fortran 33, Octave 16. A
# reader whose tool is not installed is skipped with a message.

set(folder ${WORK}/reference_readers)
file(REMOVE_RECURSE ${folder}) # cells of another version would be rejected
execute_process(
    COMMAND ${LIBRATION} study reference_problems --problems logistic --scalar ball:30 --out ${folder}
    OUTPUT_QUIET ERROR_QUIET
    COMMAND_ERROR_IS_FATAL ANY)
set(text ${folder}/reference_problems/logistic.txt)
file(STRINGS ${text} rows REGEX "^[^#]")
list(GET rows 7 row)
string(REPLACE " " ";" row "${row}")
list(GET row 0 time)
list(GET row 1 value)

# The last number printed by a reader equals the value of the last row up to this number of characters.
function(expect reader printed characters)
    string(SUBSTRING "${value}" 0 ${characters} digits)
    # 0.99... or 9.9...E-001: the digits without the decimal point.
    string(REGEX REPLACE "^0\\.0*" "" digits "${digits}")
    string(REPLACE "." "" found "${printed}")
    if(NOT found MATCHES "${digits}")
        message(FATAL_ERROR "${reader} did not print ${digits} of ${value}, but\n${printed}")
    endif()
    message("${reader} reads ${value} to ${characters} characters")
endfunction()

find_program(PYTHON python3)
if(PYTHON)
    execute_process(
        COMMAND ${PYTHON} ${READERS}/read_reference.py ${folder}/reference_problems/logistic.csv
        OUTPUT_VARIABLE printed
        COMMAND_ERROR_IS_FATAL ANY)
    expect(read_reference.py "${printed}" 32)
    execute_process(
        COMMAND ${PYTHON} -c "from reference_problems import PROBLEMS; print(PROBLEMS['logistic']['u'][7][0])"
        WORKING_DIRECTORY ${folder}/reference_problems
        OUTPUT_VARIABLE printed
        COMMAND_ERROR_IS_FATAL ANY)
    expect(reference_problems.py "${printed}" 32)
else()
    message("read_reference.py is skipped: python3 is not installed")
endif()

find_program(OCTAVE octave-cli)
if(OCTAVE)
    execute_process(
        COMMAND ${OCTAVE} --no-gui --norc ${READERS}/read_reference.m ${text}
        OUTPUT_VARIABLE printed
        COMMAND_ERROR_IS_FATAL ANY)
    expect(read_reference.m "${printed}" 16)
else()
    message("read_reference.m is skipped: octave is not installed")
endif()

find_program(CC NAMES gcc cc)
if(CC)
    execute_process(
        COMMAND ${CC} ${READERS}/read_reference.c -o ${folder}/read_c -lmpfr -lgmp
        COMMAND_ERROR_IS_FATAL ANY)
    execute_process(
        COMMAND ${folder}/read_c
        INPUT_FILE ${text}
        OUTPUT_VARIABLE printed
        COMMAND_ERROR_IS_FATAL ANY)
    expect(read_reference.c "${printed}" 32)
    file(WRITE ${folder}/print_last.c
        "#include <stdio.h>\n"
        "#include \"reference_problems.h\"\n"
        "int main(void) { return puts(libration_references[libration_reference_count - 1].value[7]) < 0; }\n")
    execute_process(
        COMMAND ${CC} -Wall -Werror -I${folder}/reference_problems ${folder}/print_last.c -o ${folder}/print_last
        COMMAND_ERROR_IS_FATAL ANY)
    execute_process(
        COMMAND ${folder}/print_last
        OUTPUT_VARIABLE printed
        COMMAND_ERROR_IS_FATAL ANY)
    expect(reference_problems.h "${printed}" 32)
else()
    message("read_reference.c is skipped: no C compiler is installed")
endif()

find_program(FORTRAN gfortran)
if(FORTRAN)
    execute_process(
        COMMAND ${FORTRAN} ${READERS}/read_reference.f90 -o ${folder}/read_fortran
        COMMAND_ERROR_IS_FATAL ANY)
    execute_process(
        COMMAND ${folder}/read_fortran
        INPUT_FILE ${text}
        OUTPUT_VARIABLE printed
        COMMAND_ERROR_IS_FATAL ANY)
    expect(read_reference.f90 "${printed}" 32)
else()
    message("read_reference.f90 is skipped: gfortran is not installed")
endif()
