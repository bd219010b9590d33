# Writes OUTPUT (version.hpp) for the sources in SOURCE_DIR. Run in every build; see command.cmake.

# The commit identifies the program that produced a result. So only the sources of the program make it dirty: neither a
# regenerated results/ nor an edited README does.
set(program_sources include src studies paper cmake CMakeLists.txt CMakePresets.json)

set(COMMIT unknown)
set(CHANGES "")
set(YEAR "")
find_program(GIT git)
if(GIT)
    execute_process(
        COMMAND ${GIT} -C ${SOURCE_DIR} rev-parse --show-toplevel
        OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    file(REAL_PATH "${SOURCE_DIR}" source_dir)
    # An archive unpacked inside another repository is not at that repository's commit.
    if(top STREQUAL source_dir)
        execute_process(
            COMMAND ${GIT} -C ${SOURCE_DIR} rev-parse --quiet --verify --short=10 HEAD
            OUTPUT_VARIABLE head OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
            RESULT_VARIABLE failed)
        execute_process(
            COMMAND ${GIT} -C ${SOURCE_DIR} status --porcelain -- ${program_sources}
            OUTPUT_VARIABLE changes ERROR_QUIET)
        execute_process(
            COMMAND ${GIT} -C ${SOURCE_DIR} log -1 --format=%cd --date=format:%Y
            OUTPUT_VARIABLE YEAR OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
        if(NOT failed)
            set(COMMIT ${head})
            if(changes)
                string(APPEND COMMIT -dirty)
                # Uncommitted changes are identified by a hash of their content.
                execute_process(
                    COMMAND ${GIT} -C ${SOURCE_DIR} diff HEAD -- ${program_sources}
                    OUTPUT_VARIABLE difference ERROR_QUIET)
                execute_process(
                    COMMAND ${GIT} -C ${SOURCE_DIR} ls-files --others --exclude-standard -- ${program_sources}
                    COMMAND ${GIT} -C ${SOURCE_DIR} hash-object --stdin-paths
                    OUTPUT_VARIABLE untracked ERROR_QUIET)
                string(SHA256 CHANGES "${difference}${untracked}")
                string(SUBSTRING "${CHANGES}" 0 10 CHANGES)
            endif()
        endif()
    endif()
endif()

# `git archive` writes the commit and its date into archive.txt, the only source for an unpacked archive.
if(COMMIT STREQUAL unknown)
    file(READ ${CMAKE_CURRENT_LIST_DIR}/archive.txt archived)
    if(archived MATCHES "^([0-9a-f]+) ([0-9]+)-")
        string(SUBSTRING ${CMAKE_MATCH_1} 0 10 COMMIT)
        set(YEAR ${CMAKE_MATCH_2})
    endif()
endif()

# configure_file does not touch a file whose content would not change.
configure_file(${CMAKE_CURRENT_LIST_DIR}/version.hpp.in ${OUTPUT} @ONLY)
