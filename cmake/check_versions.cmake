# cmake -D SOURCE=FOLDER -P check_versions.cmake
# The version is given in five files: checks that all agree with CMakeLists.txt, or fails with those that do not. Prints
# it.

function(first_match file pattern variable)
    file(STRINGS ${SOURCE}/${file} lines REGEX "${pattern}" LIMIT_COUNT 1)
    string(REGEX REPLACE "^.*${pattern}.*$" "\\1" found "${lines}")
    set(${variable} "${found}" PARENT_SCOPE)
endfunction()

set(number "([0-9]+[.][0-9]+[.][0-9]+)")
first_match(CMakeLists.txt "^ +VERSION ${number}$" version)
if(NOT version)
    message(FATAL_ERROR "CMakeLists.txt has no line VERSION X.Y.Z")
endif()

set(others "")
function(check file pattern)
    first_match(${file} "${pattern}" found)
    if(NOT found STREQUAL version)
        set(others "${others}\n  ${file}: '${found}'" PARENT_SCOPE)
    endif()
endfunction()
check(CITATION.cff "^version: ${number}$")
check(pyproject.toml "^version = \"${number}\"$")
check(debian/changelog "^libration [(]([^)]*)[)] ")
check(CHANGELOG.md "^## (.*)$")
if(others)
    message(FATAL_ERROR "CMakeLists.txt has version ${version}, but other files differ:${others}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E echo ${version})
