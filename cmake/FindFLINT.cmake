# FLINT with ball arithmetic: FLINT 3, or FLINT 2.9 with Arb 2.23 (Debian: libflint-dev and libflint-arb-dev). Defines
# the target FLINT::FLINT and FLINT_VERSION.

find_path(FLINT_INCLUDE_DIR flint/flint.h)
find_library(FLINT_LIBRARY flint)
# Arb was a separate library before FLINT 3; Debian calls it flint-arb.
find_path(FLINT_ARB_INCLUDE_DIR NAMES flint/arb.h arb.h HINTS ${FLINT_INCLUDE_DIR})
if(FLINT_ARB_INCLUDE_DIR AND EXISTS ${FLINT_ARB_INCLUDE_DIR}/flint/arb.h)
    set(FLINT_ARB_LIBRARY ${FLINT_LIBRARY})
else()
    find_library(FLINT_ARB_LIBRARY NAMES flint-arb arb)
endif()
mark_as_advanced(FLINT_INCLUDE_DIR FLINT_LIBRARY FLINT_ARB_INCLUDE_DIR FLINT_ARB_LIBRARY)

if(FLINT_INCLUDE_DIR)
    file(STRINGS ${FLINT_INCLUDE_DIR}/flint/flint.h version REGEX "define (__)?FLINT_VERSION[ \t]+\"?[0-9]")
    if(version MATCHES "([0-9]+\\.[0-9.]+)")
        set(FLINT_VERSION ${CMAKE_MATCH_1})
    else()
        file(STRINGS ${FLINT_INCLUDE_DIR}/flint/flint.h parts REGEX "define __FLINT_VERSION(_MINOR|_PATCHLEVEL)?[ \t]")
        string(REGEX MATCHALL "[0-9]+" parts "${parts}")
        list(JOIN parts "." FLINT_VERSION)
    endif()
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FLINT
    REQUIRED_VARS FLINT_LIBRARY FLINT_INCLUDE_DIR FLINT_ARB_LIBRARY FLINT_ARB_INCLUDE_DIR
    VERSION_VAR FLINT_VERSION)

if(FLINT_FOUND AND NOT TARGET FLINT::FLINT)
    add_library(FLINT::FLINT INTERFACE IMPORTED)
    set_target_properties(FLINT::FLINT PROPERTIES
        INTERFACE_INCLUDE_DIRECTORIES "${FLINT_INCLUDE_DIR};${FLINT_ARB_INCLUDE_DIR}"
        INTERFACE_LINK_LIBRARIES "${FLINT_ARB_LIBRARY};${FLINT_LIBRARY}")
endif()
