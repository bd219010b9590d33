// What a user's program looks like: the period of a pendulum in 50 digits and in quad.
#include <iostream>
#include <libration/pendulum/energy/period.hpp>  // at its place in version 1.0
#include <libration/scalar/decimal.hpp>

int main() {
    using namespace libration;
    using namespace libration::pendulum;
    const precision_scope digits(60);
    const motion swing = motion::of_state(read_exact("90deg"), read_exact("0"));
    std::cout << to_decimal(effective_period(energy_level_of<mpfr>(swing)), 50) << '\n';
    std::cout << to_decimal(effective_period(energy_level_of<quad>(swing)), 30) << '\n';
}
