#include <iostream>

#include <libration/scalar/constants.hpp>
#include <libration/scalar/decimal.hpp>

int main() {
    const libration::precision_scope digits(60);
    std::cout << "pi = " << libration::to_decimal(libration::pi<libration::mpfr>(), 50) << '\n';
    std::cout << "pi = " << libration::to_decimal(libration::pi<libration::quad>(), 30) << '\n';
}
