# The compiled part of the Python package, based on the C interface; the rest is in pyproject.toml and python/. A wheel
# consists of the component `python`, with the shared library next to the module, and the component `command` in its
# directory `program`.

find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
set(PYBIND11_FINDPYTHON OFF)
set(PYTHON_EXECUTABLE ${Python3_EXECUTABLE})
find_package(pybind11 2.10 REQUIRED CONFIG)

pybind11_add_module(libration-python MODULE EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/src/interface/python/module.cpp)
set_target_properties(libration-python PROPERTIES
    OUTPUT_NAME _libration
    UNITY_BUILD OFF
    INSTALL_RPATH "$ORIGIN")
target_link_libraries(libration-python PRIVATE libration-c libration-warnings)

add_custom_target(libration-wheel DEPENDS libration-python libration-command)
install(TARGETS libration-python LIBRARY DESTINATION . COMPONENT python EXCLUDE_FROM_ALL)
# Under the name that the module loads: a wheel cannot contain links.
install(FILES $<TARGET_FILE:libration-c>
    DESTINATION .
    RENAME $<TARGET_SONAME_FILE_NAME:libration-c>
    COMPONENT python EXCLUDE_FROM_ALL)
