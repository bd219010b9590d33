# The manual pages libration(1) and libration-NAME(1) of every subcommand, made by help2man of what the program says.

find_program(HELP2MAN help2man REQUIRED)
set(manual_dir ${PROJECT_BINARY_DIR}/manual)
add_custom_command(
    OUTPUT ${manual_dir}/libration.1
    COMMAND ${CMAKE_COMMAND}
        -D LIBRATION=$<TARGET_FILE:libration-command>
        -D EXAMPLES=${PROJECT_SOURCE_DIR}/docs/commands.md
        -D HELP2MAN=${HELP2MAN}
        -D OUTPUT=${manual_dir}
        -P ${PROJECT_SOURCE_DIR}/cmake/write_manual.cmake
    DEPENDS libration-command ${PROJECT_SOURCE_DIR}/docs/commands.md ${PROJECT_SOURCE_DIR}/cmake/write_manual.cmake
    COMMENT "Writing the manual pages"
    VERBATIM)
add_custom_target(libration-manual ALL DEPENDS ${manual_dir}/libration.1)
add_dependencies(libration-installable libration-manual)
install(DIRECTORY ${manual_dir}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT manual)
