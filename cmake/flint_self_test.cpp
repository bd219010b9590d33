// Runs the self-test of the installed FLINT when the project is configured (flint_self_test.cmake).
#include <cstdio>

#include "libration/scalar/ball/product_self_test.hpp"

int main() {
    std::puts(libration::describe_flint_products().c_str());
    return libration::flint_products().guarded_is_right ? 0 : 1;
}
