# cmake -D LIBRATION= -D EXAMPLES= -D HELP2MAN= -D OUTPUT= -P write_manual.cmake
# Writes the manual pages into the emptied directory OUTPUT, from the output of LIBRATION --help and the lines of the
# file EXAMPLES that begin with ./run NAME.

file(REMOVE_RECURSE ${OUTPUT})
file(MAKE_DIRECTORY ${OUTPUT})
set(added ${OUTPUT}/added)

function(ask variable)
    execute_process(COMMAND ${LIBRATION} ${ARGN}
        OUTPUT_VARIABLE said OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    set(${variable} "${said}" PARENT_SCOPE)
endfunction()

# A page from the sections [examples], ... in the file `added` and the program's help.
function(write page description help)
    execute_process(
        COMMAND ${HELP2MAN} --no-info --section=1 "--name=${description}" "--help-option=${help}"
            "--version-string=${version}" "--source=${version}" --manual=Libration --include=${added} ${LIBRATION}
        OUTPUT_VARIABLE text
        COMMAND_ERROR_IS_FATAL ANY)
    string(TOUPPER ${page} title)
    string(REGEX REPLACE "\n[.]TH [^ ]+ " "\n.TH ${title} " text "${text}")
    string(REGEX REPLACE "\n[.]SH NAME\nlibration " "\n.SH NAME\n${page} " text "${text}")
    # The examples of --help keep their lines, so that they can be copied.
    string(REGEX REPLACE "\n[.]SH EXAMPLES\n[.]IP\n((libration [^\n]*\n)+)" "\n.SH EXAMPLES\n.IP\n.nf\n\\1.fi\n" text "${text}")
    file(WRITE ${OUTPUT}/${page}.1 "${text}")
endfunction()

ask(version --version)
string(REGEX REPLACE "\n.*$" "" version "${version}")
ask(help --help)
string(REGEX REPLACE "^.*\nSubcommands:\n" "" commands "${help}")
string(REGEX REPLACE "\n          +" " " commands "${commands}") # continued lines
string(REPLACE ";" "\\;" commands "${commands}")
string(REPLACE "\n" ";" commands "${commands}")

set(pages "")
foreach(line IN LISTS commands)
    if(NOT line MATCHES "^  ([a-z]+) +(.*)$")
        continue()
    endif()
    set(name ${CMAKE_MATCH_1})
    set(description "${CMAKE_MATCH_2}")
    string(APPEND pages ".BR libration-${name} (1),\n")

    file(STRINGS ${EXAMPLES} examples REGEX "^ *[.]/run ${name} ")
    set(text "")
    foreach(example IN LISTS examples)
        string(REGEX REPLACE "^ *[.]/run (.*[^ ]) +# (.*)$" "# \\2\nlibration \\1" example "${example}")
        string(REGEX REPLACE "^ *[.]/run " "libration " example "${example}")
        string(REPLACE "\\" "\\e" example "${example}")
        string(REPLACE "-" "\\-" example "${example}")
        string(REPLACE "'" "\\(aq" example "${example}")
        string(APPEND text "\n${example}\n")
    endforeach()
    if(text)
        set(text "[examples]\n.nf${text}.fi\n\n")
    endif()
    file(WRITE ${added} "${text}[see also]\n.BR libration (1)\n")
    write(libration-${name} "${description}" "${name} --help")
endforeach()

string(REGEX REPLACE ",\n$" "\n" pages "${pages}")
file(WRITE ${added} "[exit status]\n0: success; 1: failure, or a check did not pass; 2: invalid input or wrong usage.\n
[see also]\n${pages}")
write(libration "power-series solutions of ordinary differential equations to arbitrary precision" --help)
file(REMOVE ${added})
