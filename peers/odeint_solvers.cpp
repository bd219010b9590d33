// Initial value problems in double by Boost.odeint, for the study `solvers`: see equation_code.hpp.
#include <boost/numeric/odeint.hpp>
#include <boost/version.hpp>

#include "equation_code.hpp"

namespace {

namespace odeint = boost::numeric::odeint;
using state = std::vector<double>;

template <class Stepper>
void march(Stepper stepper, peers::equations& of, std::vector<double>& values) {
    const auto slopes = [&](const state& y, state& out, double t) {
        if (!of.slopes(t, y.data(), out.data())) {
            throw peers::no_answer();
        }
    };
    std::vector<double> times{of.begin};
    times.insert(times.end(), of.times.begin(), of.times.end());
    state y = of.start;
    bool first = true;
    try {
        odeint::integrate_times(stepper, slopes, y, times, (of.times.back() - of.begin) * 1e-4,
                                [&](const state& now, double /*t*/) {
                                    if (!first) {
                                        values.insert(values.end(), now.begin(), now.end());
                                    }
                                    first = false;
                                });
    } catch (const std::exception&) {  // a step that does not get smaller
        throw peers::no_answer();
    }
}

void solve(peers::equations& of, const std::string& method, double tolerance, std::vector<double>& values) {
    if (method == "dopri5") {
        march(odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<state>()), of, values);
    } else if (method == "rkf78") {
        march(odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_fehlberg78<state>()), of, values);
    } else if (method == "bulirsch-stoer") {
        march(odeint::bulirsch_stoer<state>(tolerance, tolerance), of, values);
    } else {
        throw peers::no_answer();
    }
}

}  // namespace

int main() {
    const std::string version =
        std::to_string(BOOST_VERSION / 100000) + "." + std::to_string(BOOST_VERSION / 100 % 1000);
    return peers::answer("Boost.odeint " + version, solve);
}
