// What a user's program with proved arithmetic looks like: the period of a pendulum, every digit of it certain.
#include <iostream>
#include <libration/pendulum/period.hpp>
#include <libration/scalar/ball/decimal.hpp>

int main() {
    using namespace libration;
    using namespace libration::pendulum;
    const precision_scope digits(60);
    const motion swing = motion::of_state(read_exact("90deg"), read_exact("0"));
    const auto period = to_proved_decimal(effective_period(energy_level_of<ball>(swing)), 50);
    std::cout << (period ? period->text + " +/- " + period->uncertainty : "not proved") << '\n';
    return period ? 0 : 1;
}
