# Programs around other people's libraries that libration may not be linked with (GSL is under the GPL): each is a
# process of its own, which a study starts. Where the library is missing, the study says so.

pkg_check_modules(gsl QUIET IMPORTED_TARGET gsl)
if(gsl_FOUND)
    add_executable(libration-gsl-theta ${PROJECT_SOURCE_DIR}/peers/gsl_theta.cpp)
    target_link_libraries(libration-gsl-theta PRIVATE PkgConfig::gsl libration-warnings)
    add_executable(libration-gsl-trajectory EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/peers/gsl_trajectory.cpp)
    target_link_libraries(libration-gsl-trajectory PRIVATE PkgConfig::gsl libration-warnings)
    add_executable(libration-gsl-equations EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/peers/gsl_equations.cpp)
    target_link_libraries(libration-gsl-equations PRIVATE PkgConfig::gsl libration-warnings)
endif()
