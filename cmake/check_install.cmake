# cmake -D BUILD= -D CONFIG= -D PREFIX= [-D PROGRAM=bin/libration] -P check_install.cmake
# Installs the build into an emptied PREFIX, as a user would, and starts the installed program.

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

if(PROGRAM)
    execute_process(COMMAND ${PREFIX}/${PROGRAM} --version COMMAND_ERROR_IS_FATAL ANY)
endif()
