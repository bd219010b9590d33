# cmake -D SOURCE=FOLDER -P check_versions.cmake
# The version is given in five files: checks that all agree with CMakeLists.txt, or fails with those that do not. Prints
# it. Checks also that every description of the program has the same words.

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

# Line breaks, comment and string delimiters differ between files.
set(description "power-series solutions of ordinary differential equations to arbitrary precision")
foreach(file IN ITEMS
        README.md CITATION.cff CMakeLists.txt pyproject.toml debian/control cmake/libration.pc.in
        python/libration/__init__.py src/command/option/help.hpp src/command/verb/cite.cpp)
    file(READ ${SOURCE}/${file} text)
    string(REGEX REPLACE "[ \n\"]+" " " text "${text}")
    string(TOLOWER "${text}" text)
    string(FIND "${text}" "${description}" place)
    if(place EQUAL -1)
        string(APPEND others "\n  ${file}")
    endif()
endforeach()
if(others)
    message(FATAL_ERROR "these files do not describe the program as '${description}':${others}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E echo ${version})
