# Programs around third-party libraries that may not be linked into libration (GSL is under the GPL): each is a separate
# process started by a study. If the library is missing, the study reports it.

pkg_check_modules(gsl QUIET IMPORTED_TARGET gsl)
if(gsl_FOUND)
    add_executable(libration-gsl-theta ${PROJECT_SOURCE_DIR}/peers/gsl_theta.cpp)
    target_link_libraries(libration-gsl-theta PRIVATE PkgConfig::gsl libration-warnings)
    add_executable(libration-gsl-trajectory EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/peers/gsl_trajectory.cpp)
    target_link_libraries(libration-gsl-trajectory PRIVATE PkgConfig::gsl libration-warnings)
    add_executable(libration-gsl-equations EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/peers/gsl_equations.cpp)
    target_link_libraries(libration-gsl-equations PRIVATE PkgConfig::gsl libration-warnings)
endif()

# The peers of the study `solvers`.
add_executable(libration-odeint-solvers ${PROJECT_SOURCE_DIR}/peers/odeint_solvers.cpp)
target_link_libraries(libration-odeint-solvers PRIVATE Boost::headers libration-warnings)
set(solver_peers libration-odeint-solvers)
if(gsl_FOUND)
    add_executable(libration-gsl-solvers ${PROJECT_SOURCE_DIR}/peers/gsl_solvers.cpp)
    target_link_libraries(libration-gsl-solvers PRIVATE PkgConfig::gsl libration-warnings)
    list(APPEND solver_peers libration-gsl-solvers)
endif()
find_path(SUNDIALS_INCLUDE_DIR cvode/cvode.h)
find_library(SUNDIALS_CVODE_LIBRARY sundials_cvode)
find_library(SUNDIALS_VECTOR_LIBRARY sundials_nvecserial)
mark_as_advanced(SUNDIALS_INCLUDE_DIR SUNDIALS_CVODE_LIBRARY SUNDIALS_VECTOR_LIBRARY)
if(SUNDIALS_INCLUDE_DIR AND SUNDIALS_CVODE_LIBRARY AND SUNDIALS_VECTOR_LIBRARY)
    add_executable(libration-sundials-solvers ${PROJECT_SOURCE_DIR}/peers/sundials_solvers.cpp)
    target_include_directories(libration-sundials-solvers SYSTEM PRIVATE ${SUNDIALS_INCLUDE_DIR})
    target_link_libraries(libration-sundials-solvers
        PRIVATE ${SUNDIALS_CVODE_LIBRARY} ${SUNDIALS_VECTOR_LIBRARY} libration-warnings)
    list(APPEND solver_peers libration-sundials-solvers)
endif()
foreach(script IN ITEMS scipy_solvers.py mpmath_solvers.py equation_code.py)
    configure_file(peers/${script} ${PROJECT_BINARY_DIR}/${script} COPYONLY)
endforeach()

# `libration import`: models in SBML, by libsbml. Not through pkg-config, which also requires libxml-2.0: only linking
# the archive needs that, and Debian does not install it with libsbml5-dev.
find_path(LIBRATION_SBML_INCLUDE_DIR sbml/SBMLTypes.h)
find_library(LIBRATION_SBML_LIBRARY sbml)
mark_as_advanced(LIBRATION_SBML_INCLUDE_DIR LIBRATION_SBML_LIBRARY)
if(LIBRATION_SBML_INCLUDE_DIR AND LIBRATION_SBML_LIBRARY)
    file(GLOB import_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/import/*.cpp)
    add_executable(libration-import ${import_sources})
    target_include_directories(libration-import SYSTEM PRIVATE ${LIBRATION_SBML_INCLUDE_DIR})
    target_link_libraries(libration-import PRIVATE ${LIBRATION_SBML_LIBRARY} fmt::fmt libration-warnings)
endif()
