// What a program looks like that needs the templates alone, without FLINT and without the library: the Pade approximant
// [3/3] of exp(x) at 1, in 30 digits, from the power series of the exponential of x.
#include <iostream>
#include <libration/approximant/pade.hpp>
#include <libration/scalar/decimal.hpp>
#include <libration/scalar/scalar.hpp>
#include <libration/series/series.hpp>

int main() {
    using namespace libration;
    const precision_scope digits(40);
    auto x = series::power_series<mpfr>::zero(6);
    x[1] = 1;
    const auto approximant = pade(series::exponential(x), 3, 3);
    std::cout << to_decimal((*approximant)(mpfr(1)).value, 30) << '\n';
}
