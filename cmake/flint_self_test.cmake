# Tests whether the FLINT found multiplies integer polynomials correctly at the bound of its transform. Each process
# repeats this self-test (scalar/ball/product_self_test.hpp), since the library at run time may be another one. The
# result is cached as LIBRATION_FLINT_PRODUCTS. A cross build without an emulator leaves it to the processes.

if(NOT DEFINED LIBRATION_FLINT_PRODUCTS)
    set(tested "not tested: cross build")
    if(NOT CMAKE_CROSSCOMPILING OR CMAKE_CROSSCOMPILING_EMULATOR)
        set(ball_sources ${PROJECT_SOURCE_DIR}/src/libration/scalar/ball)
        try_run(flint_run flint_compiled
            SOURCES ${PROJECT_SOURCE_DIR}/cmake/flint_self_test.cpp
                ${ball_sources}/product_self_test.cpp ${ball_sources}/product_guard.cpp
                ${ball_sources}/product_check.cpp
            CMAKE_FLAGS -DINCLUDE_DIRECTORIES=${PROJECT_SOURCE_DIR}/include
            LINK_LIBRARIES FLINT::FLINT PkgConfig::mpfr PkgConfig::gmp
            COMPILE_OUTPUT_VARIABLE flint_compile_output
            RUN_OUTPUT_VARIABLE tested
            CXX_STANDARD 20)
        string(STRIP "${tested}" tested)
        if(NOT flint_compiled)
            message(FATAL_ERROR "the self-test of FLINT does not compile:\n${flint_compile_output}")
        elseif(NOT flint_run EQUAL 0)
            message(WARNING "FLINT ${FLINT_VERSION}: products of integer polynomials are wrong (${tested})")
        endif()
    endif()
    set(LIBRATION_FLINT_PRODUCTS "${tested}" CACHE STRING "Result of the self-test of FLINT's products")
    mark_as_advanced(LIBRATION_FLINT_PRODUCTS)
    message(STATUS "FLINT ${FLINT_VERSION}, products of integer polynomials: ${LIBRATION_FLINT_PRODUCTS}")
endif()
