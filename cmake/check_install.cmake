# cmake -D BUILD= -D CONFIG= -D PREFIX= [-D PROGRAM=bin/libration] -P check_install.cmake
# Installs the build into an emptied PREFIX, as a user would, and runs the installed program.

unset(ENV{DESTDIR})
file(REMOVE_RECURSE ${PREFIX})
execute_process(
    COMMAND ${CMAKE_COMMAND} --install ${BUILD} --config "${CONFIG}" --prefix ${PREFIX}
    OUTPUT_QUIET
    COMMAND_ERROR_IS_FATAL ANY)

file(GLOB config ${PREFIX}/lib*/cmake/libration/libration-config-version.cmake
    ${PREFIX}/lib/*/cmake/libration/libration-config-version.cmake)
file(GLOB headers ${PREFIX}/include/libration/scalar/*.hpp)
if(NOT config OR NOT headers)
    message(FATAL_ERROR "no package file or no headers in ${PREFIX}")
endif()

if(NOT PROGRAM)
    return()
endif()
execute_process(COMMAND ${PREFIX}/${PROGRAM} --version COMMAND_ERROR_IS_FATAL ANY)
foreach(needed IN ITEMS share/libration/studies/style.gp share/libration/studies/errata.md.in share/libration/results/claims.csv
        share/doc/libration/README.md share/doc/libration/docs/tutorial.md share/doc/libration/docs/readers/read_table.py
        share/bash-completion/completions/libration)
    if(NOT EXISTS ${PREFIX}/${needed})
        message(FATAL_ERROR "${needed} is not installed")
    endif()
endforeach()

# If manual pages were generated, each subcommand has one.
if(EXISTS ${BUILD}/manual AND NOT EXISTS ${PREFIX}/share/man/man1/libration-period.1)
    message(FATAL_ERROR "the manual pages are not installed")
endif()

# The installed files alone suffice for a study, its figures, a report, and its peer if that was built.
set(work ${PREFIX}/work)
file(MAKE_DIRECTORY ${work})
set(quick study period_error --energies 0.5,1.5 --orders 2)
execute_process(COMMAND ${PREFIX}/${PROGRAM} ${quick} --out out
    WORKING_DIRECTORY ${work} ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PREFIX}/${PROGRAM} reproduce --only period_error
    WORKING_DIRECTORY ${work} ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
if(NOT EXISTS ${work}/out/period_error/period_error.svg OR NOT EXISTS ${work}/reproduced/index.html)
    message(FATAL_ERROR "the installed program does not produce a figure and a report")
endif()
if(EXISTS ${BUILD}/libration-gsl-theta)
    execute_process(COMMAND ${PREFIX}/${PROGRAM} study audit_gsl --gaps 1e-3 --times 1
        OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endif()

# Without its scripts it draws nothing: it does not use the source tree.
file(RENAME ${PREFIX}/share/libration ${PREFIX}/share/hidden)
execute_process(COMMAND ${PREFIX}/${PROGRAM} figure period_error --out out
    WORKING_DIRECTORY ${work} ERROR_QUIET RESULT_VARIABLE code)
file(RENAME ${PREFIX}/share/hidden ${PREFIX}/share/libration)
if(code EQUAL 0)
    message(FATAL_ERROR "the installed program draws with the scripts of the source tree")
endif()
