# The compiled half of the Python package, on the C interface: pyproject.toml and python/ have the rest. A wheel is the
# component `python`, with the shared library beside the module, and the component `command` in its folder `program`.

find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
set(PYBIND11_FINDPYTHON OFF)
set(PYTHON_EXECUTABLE ${Python3_EXECUTABLE})
find_package(pybind11 2.10 REQUIRED CONFIG)

pybind11_add_module(libration-python MODULE EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/src/python/module.cpp)
set_target_properties(libration-python PROPERTIES
    OUTPUT_NAME _libration
    UNITY_BUILD OFF
    INSTALL_RPATH "$ORIGIN")
target_link_libraries(libration-python PRIVATE libration-c libration-warnings)

add_custom_target(libration-wheel DEPENDS libration-python libration-command)
install(TARGETS libration-python LIBRARY DESTINATION . COMPONENT python EXCLUDE_FROM_ALL)
# By the name that the module asks for: a wheel holds no links.
install(FILES $<TARGET_FILE:libration-c>
    DESTINATION .
    RENAME $<TARGET_SONAME_FILE_NAME:libration-c>
    COMPONENT python EXCLUDE_FROM_ALL)
